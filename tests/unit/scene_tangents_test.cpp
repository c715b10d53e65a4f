// Tangents that the file does not have: closed forms, seams, what has no direction, and what takes long.

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include "scene/mikktspace.h"
#include "scene/tangents.h"

using namespace crsh;
using scene::CornerTangents;
using scene::Mesh;
using scene::TangentMesh;

namespace {

constexpr glm::vec3 up{0, 0, 1};

scene::Material with_normal_map(uint32_t uv_set = 0) {
  scene::Material material;
  material.texture(scene::Slot::normal) = {.texture = 0, .texcoord = uv_set};
  return material;
}

/// Columns of two triangles each between y = 0 and 1 over these x; u is given, v goes down.
Mesh strip(const std::vector<float>& x, const std::vector<float>& u) {
  Mesh mesh;
  for (size_t i = 0; i < x.size(); ++i)
    for (int y = 0; y < 2; ++y) {
      mesh.positions.emplace_back(x[i], y, 0);
      mesh.uv[0].emplace_back(u[i], 1 - y);
      mesh.colours.emplace_back(i, y);
    }
  mesh.normals.assign(mesh.positions.size(), up);
  for (uint32_t i = 0; i + 1 < x.size(); ++i) {
    mesh.triangles.emplace_back(2 * i, 2 * i + 2, 2 * i + 3);
    mesh.triangles.emplace_back(2 * i, 2 * i + 3, 2 * i + 1);
  }
  mesh.materials.assign(mesh.triangles.size(), 0);
  return mesh;
}

void fill(Mesh& mesh) { scene::fill_tangents(mesh, std::vector{with_normal_map(), scene::Material{}}); }

void check_near(const glm::vec4& tangent, const glm::vec4& expected, float tolerance = 1e-5f) {
  for (int c = 0; c < 4; ++c) CHECK(std::abs(tangent[c] - expected[c]) <= tolerance);
}

TEST_CASE("the tangent of a quad goes along u, and the bitangent up, against v") {
  Mesh mesh = strip({0, 1}, {0, 1});
  fill(mesh);
  REQUIRE(mesh.tangents.size() == 4);
  for (const glm::vec4& tangent : mesh.tangents) check_near(tangent, {1, 0, 0, 1});
}

TEST_CASE("vertices are doubled, with all they have, where mirrored halves meet") {
  Mesh mesh = strip({-1, 0, 1}, {1, 0, 1});
  fill(mesh);
  REQUIRE(mesh.positions.size() == 8);
  for (size_t t = 0; t < mesh.triangles.size(); ++t)
    for (int c = 0; c < 3; ++c) {
      const uint32_t v = mesh.triangles[t][c];
      check_near(mesh.tangents[v], t < 2 ? glm::vec4(-1, 0, 0, -1) : glm::vec4(1, 0, 0, 1));
      CHECK(mesh.colours[v] == scene::PackedColour(mesh.positions[v].x + 1, mesh.positions[v].y));
      CHECK(mesh.uv[0][v] == glm::vec2(std::abs(mesh.positions[v].x), 1 - mesh.positions[v].y));
      CHECK(mesh.normals[v] == up);
    }
}

TEST_CASE("only vertices without tangents get them, and only where a material needs them") {
  Mesh mesh = strip({0, 1, 2, 3}, {0, 1, 2, 3});
  mesh.tangents.assign(mesh.positions.size(), glm::vec4(0));
  for (size_t v = 0; v < 2; ++v) mesh.tangents[v] = {0, 1, 0, -1};
  mesh.materials[4] = mesh.materials[5] = 1;
  fill(mesh);
  REQUIRE(mesh.tangents.size() == 8);
  for (size_t v = 0; v < 8; ++v)
    CHECK(mesh.tangents[v] == (v < 2 ? glm::vec4(0, 1, 0, -1) : v < 6 ? glm::vec4(1, 0, 0, 1) : glm::vec4(0)));
  Mesh plain = strip({0, 1}, {0, 1});
  plain.materials = {1, 1};
  fill(plain);
  CHECK(plain.tangents.empty());
}

TEST_CASE("the normal map's own set of coordinates counts") {
  Mesh mesh = strip({0, 1}, {0, 1});
  for (const glm::vec3& place : mesh.positions) mesh.uv[1].emplace_back(place.y, place.x);
  scene::fill_tangents(mesh, std::vector{with_normal_map(1)});
  for (const glm::vec4& tangent : mesh.tangents) check_near(tangent, {0, 1, 0, 1});
}

TEST_CASE("triangles without normals have tangents of their own") {
  Mesh mesh = strip({-1, 0, 1}, {0, 1, 2});
  for (glm::vec3& place : mesh.positions) place.z = -std::abs(place.x);
  mesh.normals.assign(mesh.positions.size(), glm::vec3(0));
  fill(mesh);
  CHECK(mesh.positions.size() == 8);
  const float half = std::sqrt(0.5f);
  for (size_t t = 0; t < mesh.triangles.size(); ++t)
    for (int c = 0; c < 3; ++c) check_near(mesh.tangents[mesh.triangles[t][c]], {half, 0, t < 2 ? half : -half, 1});
}

/// A sphere, u along its parallels towards negative z, v down.
TangentMesh sphere(uint32_t columns, uint32_t rows) {
  TangentMesh mesh;
  for (uint32_t j = 0; j <= rows; ++j)
    for (uint32_t i = 0; i <= columns; ++i) {
      const double a = 2 * std::numbers::pi * i / columns, b = std::numbers::pi * j / rows;
      const glm::vec3 n(std::sin(b) * std::cos(a), std::cos(b), -std::sin(b) * std::sin(a));
      mesh.positions.push_back(3.0f * n);
      mesh.normals.push_back(glm::normalize(n));
      mesh.uv.emplace_back(float(i) / columns, float(j) / rows);
      const uint32_t v = j * (columns + 1) + i;
      if (i == columns || j == rows) continue;
      mesh.triangles.emplace_back(v, v + columns + 1, v + columns + 2);
      mesh.triangles.emplace_back(v, v + columns + 2, v + 1);
    }
  return mesh;
}

TEST_CASE("a sphere's tangents go along its parallels") {
  const TangentMesh mesh = sphere(48, 24);
  const std::vector<CornerTangents> tangents = scene::mikktspace(mesh);
  for (size_t t = 0; t < mesh.triangles.size(); ++t)
    for (uint32_t c = 0; c < 3; ++c) {
      const glm::vec3 n = mesh.normals[mesh.triangles[t][int(c)]];
      if (std::abs(n.y) > 0.95f || mesh.uv[mesh.triangles[t][int(c)]].x * 4 < 1) continue;
      check_near(tangents[t][c], glm::vec4(glm::normalize(glm::vec3(n.z, 0, -n.x)), 1), 0.08f);
    }
}

TEST_CASE("triangles without extent take their neighbours' tangents, and those alone have none") {
  TangentMesh mesh{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {1, 1, 0}, {5, 5, 5}},
                   std::vector(5, up),
                   {{0, 1}, {1, 1}, {1, 0}, {1, 0}, {0, 0}},
                   {{2, 3, 0}, {0, 1, 2}, {4, 4, 4}}};
  const std::vector<CornerTangents> tangents = scene::mikktspace(mesh);
  for (size_t t = 0; t < 3; ++t)
    for (const glm::vec4& tangent : tangents[t]) check_near(tangent, t < 2 ? glm::vec4(1, 0, 0, 1) : glm::vec4(0));
}

TEST_CASE("a triangle whose coordinates give no direction joins its neighbours") {
  TangentMesh mesh{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}},
                   std::vector(4, up),
                   {{0, 1}, {1, 1}, {1, 0}, {1, 0}},
                   {{0, 1, 2}, {0, 2, 3}}};
  const std::vector<CornerTangents> tangents = scene::mikktspace(mesh);
  for (const uint32_t c : {0, 1}) check_near(tangents[1][c], {1, 0, 0, 1});
  CHECK(tangents[1][2] == glm::vec4(0));
}

/// Of such triangles the first neighbour in the file gives the tangents.
bool is_degenerate(const TangentMesh& mesh, const glm::uvec3& t) {
  const glm::vec3 &a = mesh.positions[t.x], &b = mesh.positions[t.y], &c = mesh.positions[t.z];
  return a == b || b == c || c == a;
}

TEST_CASE("the order of triangles and of their corners does not matter") {
  std::mt19937 random(7);
  const auto noise = [&] { return std::uniform_real_distribution<float>(-1, 1)(random); };
  TangentMesh mesh = sphere(20, 12);
  for (glm::vec2& uv : mesh.uv) uv += 0.04f * glm::vec2(noise(), noise());  // turns some of them over
  const std::vector<CornerTangents> before = scene::mikktspace(mesh);
  std::reverse(mesh.triangles.begin(), mesh.triangles.end());
  for (glm::uvec3& t : mesh.triangles) t = {t.y, t.z, t.x};
  const std::vector<CornerTangents> after = scene::mikktspace(mesh);
  for (size_t t = 0; t < before.size(); ++t)
    for (uint32_t c = 0; c < 3 && !is_degenerate(mesh, mesh.triangles[before.size() - 1 - t]); ++c)
      check_near(after[before.size() - 1 - t][(c + 2) % 3], before[t][c]);
}

/// Triangles round one vertex at the origin.
TangentMesh fan(uint32_t count, bool polar) {
  TangentMesh mesh{{{0, 0, 0}}, {up}, {polar ? glm::vec2(0.5f, 0) : glm::vec2(0)}, {}};
  for (uint32_t i = 0; i <= count; ++i) {
    const double a = 2 * std::numbers::pi * i / count;
    mesh.positions.emplace_back(std::cos(a), std::sin(a), 0);
    mesh.normals.push_back(up);
    mesh.uv.push_back(polar ? glm::vec2(float(i) / count, 1) : glm::vec2(std::cos(a), -std::sin(a)));
    if (i < count) mesh.triangles.emplace_back(0, i + 1, i + 2);
  }
  return mesh;
}

TEST_CASE("a vertex of 100,000 triangles takes no longer than others") {
  for (const CornerTangents& corners : scene::mikktspace(fan(100000, false))) {
    const glm::vec4 error = glm::abs(corners[0] - glm::vec4(1, 0, 0, 1));
    if (!(glm::dot(error, glm::vec4(1)) < 1e-4f)) FAIL("not along u");
  }
  for (const CornerTangents& corners : scene::mikktspace(fan(100000, true)))
    if (!std::isfinite(glm::dot(corners[0], glm::vec4(1)))) FAIL("not finite");
}

TEST_CASE("any number of triangles along one edge are paired") {
  TangentMesh mesh{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}}, std::vector(3, up), {{0, 1}, {1, 1}, {1, 0}}, {}};
  for (int i = 0; i < 100000; ++i) mesh.triangles.emplace_back(i % 3 == 0 ? glm::uvec3(1, 0, 2) : glm::uvec3(0, 1, 2));
  const std::vector<CornerTangents> tangents = scene::mikktspace(mesh);
  check_near(tangents.back()[0], {1, 0, 0, mesh.triangles.back().x == 0 ? 1 : -1});
}

TEST_CASE("directions that are exactly opposite are not averaged to none") {
  const TangentMesh mesh{{{0, 0, 0}, {0, 1, 0}, {1, 0, 0}, {0.5f, 0, 1}},
                         std::vector(4, up),
                         {{0, 1}, {0, 0}, {1, 1}, {-1, 1}},
                         {{0, 2, 1}, {0, 1, 3}}};
  const std::vector<CornerTangents> tangents = scene::mikktspace(mesh);
  check_near(tangents[0][0], {1, 0, 0, 1});
  check_near(tangents[1][0], {-1, 0, 0, 1});
}

}  // namespace
