// Normal maps by tangents that the file does not have: a surface whose map tilts it looks, directly and in a mirror,
// like one whose vertex normals are what the map says.

#include <doctest/doctest.h>

#include <cmath>
#include <numbers>
#include <string>

#include "images/built_scene.h"
#include "scene/tangents.h"
#include "support/render.h"

namespace crsh::test {
namespace {

/// A square in the plane z = 0 and how the map lies on it: `right` and `up` are where the map's own right and up go.
struct Sheet {
  const char* name;
  glm::vec3 right, up;
  glm::mat3x2 uv;  ///< of (x, y, 1)
  bool has_normals = true, back = false, mirrored = false;
  float rotation = 0;  ///< KHR_texture_transform
};

constexpr glm::vec3 x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
const glm::mat3x2 upright{{0.5f, 0}, {0, -0.5f}, {0.5f, 0.5f}};

const std::vector<Sheet>& sheets() {
  static const std::vector<Sheet> all = {
      {"as it is", x, y, upright},
      {"turned", y, -x, {{0, 0.5f}, {0.5f, 0}, {0.5f, 0.5f}}},
      {"mirrored coordinates", -x, y, {{-0.5f, 0}, {0, -0.5f}, {0.5f, 0.5f}}},
      {.name = "without normals", .right = x, .up = y, .uv = upright, .has_normals = false},
      {.name = "from behind", .right = x, .up = y, .uv = upright, .back = true},
      {.name = "mirrored instance", .right = x, .up = y, .uv = upright, .mirrored = true},
      {.name = "texture transform", .right = -y, .up = x, .uv = upright, .rotation = std::numbers::pi_v<float> / 2},
  };
  return all;
}

constexpr glm::u8vec3 texel{230, 160, 200};  // to the right and a little up

glm::vec3 tilt() { return glm::vec3(texel) / 255.0f * 2.0f - 1.0f; }

scene::Material mirror() {
  scene::Material material = matt(glm::vec3(1));
  material.metallic = 1;
  material.roughness = 0;
  return material;
}

/// The sheet and a mirror at its right.
scene::Scene scene_of(const Sheet& sheet) {
  Triangles triangles;
  const glm::vec3 a = -x - y, b = x - y, c = x + y, d = -x + y;
  if (sheet.back) triangles.add_quad(a, d, c, b);
  else triangles.add_quad(a, b, c, d);
  const float side = sheet.mirrored ? -1.4f : 1.4f;
  const glm::vec3 m = side * x;
  triangles.add_quad(m - y, m + y, m + y + 2.0f * z, m - y + 2.0f * z, 1);
  scene::Scene scene = built_scene(triangles, {matt(glm::vec3(0.8f)), mirror()});
  if (sheet.mirrored) scene.nodes[0].transform.scale.x = -1;
  return scene;
}

scene::Scene with_map(const Sheet& sheet) {
  scene::Scene scene = scene_of(sheet);
  scene::Mesh& mesh = scene.meshes[0];
  for (size_t v = 0; v < 4; ++v) {
    mesh.uv[0][v] = sheet.uv * glm::vec3(mesh.positions[v].x, mesh.positions[v].y, 1);
    if (sheet.has_normals) mesh.normals[v] = sheet.back ? -z : z;
  }
  scene.images = {{1, 1, {texel.r, texel.g, texel.b, 255}}};
  scene.textures.resize(1);
  scene.materials[0].texture(scene::Slot::normal) = {
      .texture = 0, .texcoord = 0, .transform = {.offset = {}, .scale = glm::vec2(1), .rotation = sheet.rotation}};
  scene::fill_tangents(scene);
  return scene;
}

scene::Scene with_normals(const Sheet& sheet) {
  scene::Scene scene = scene_of(sheet);
  const glm::vec3 front = sheet.back ? -z : z;
  for (size_t v = 0; v < 4; ++v)
    scene.meshes[0].normals[v] = glm::normalize(sheet.right * tilt().x + sheet.up * tilt().y + front * tilt().z);
  return scene;
}

RenderOptions options() {
  RenderOptions options;
  options.width = options.height = 48;
  options.bounces = 1;
  options.view = {.eye = glm::vec3(-0.8f, 0.2f, 4), .target = glm::vec3(0.4f, 0, 0.4f), .fov_degrees = 50.0f};
  options.lights = {{glm::vec3(0.6f, 1.5f, 2.5f), 8.0f}};
  return options;
}

float largest_difference(const Picture& a, const Picture& b, const std::string& layer) {
  float largest = 0;
  const std::vector<float>&u = a.find(layer)->values, &v = b.find(layer)->values;
  for (size_t i = 0; i < u.size(); ++i) largest = std::max(largest, std::abs(u[i] - v[i]));
  return largest;
}

TEST_CASE("a normal map tilts surfaces as it lies on them, seen directly and in a mirror") {
  for (const Sheet& sheet : sheets()) {
    CAPTURE(sheet.name);
    const Rendered map = render(with_map(sheet), options()), normals = render(with_normals(sheet), options());
    CHECK(rays_of(map.statistics, "reflection", 0).hits > 100);
    CHECK(largest_difference(map.picture, normals.picture, "N") < 1e-3f);
    CHECK(largest_difference(map.picture, normals.picture, "") < 2e-3f);
    CHECK(largest_difference(map.picture, render(scene_of(sheet), options()).picture, "") > 0.05f);
  }
}

}  // namespace
}  // namespace crsh::test
