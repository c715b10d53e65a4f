// Skins and morph targets on the device, against the host in double precision.

#include <doctest/doctest.h>

#include <algorithm>
#include <bit>
#include <glm/gtc/matrix_inverse.hpp>

#include "scene/deform.h"
#include "small_scene.h"
#include "support/cases.h"

namespace crsh {
namespace {

using test::SmallScene;

constexpr uint32_t joints = 7, targets = 5;

template <class T>
void add_row(scene::Rows<T>& rows, const std::vector<T>& items) {
  if (rows.first.empty()) rows.first.push_back(0);
  rows.items.insert(rows.items.end(), items.begin(), items.end());
  rows.first.push_back(uint32_t(rows.items.size()));
}

std::vector<scene::Influence> random_influences(test::Random& random) {
  std::vector<scene::Influence> out;
  float sum = 0;
  for (uint32_t j = 0; j < joints; ++j)
    if (random.uniform(0, 1) < 0.5f || (out.empty() && j + 1 == joints)) {
      out.push_back({j, random.uniform(0.1f, 1)});
      sum += out.back().weight;
    }
  for (scene::Influence& influence : out) influence.weight /= sum;
  return out;
}

std::vector<scene::Displacement> random_displacements(test::Random& random) {
  std::vector<scene::Displacement> out;
  for (uint32_t t = 0; t < targets; ++t)
    if (random.uniform(0, 1) < 0.5f) out.push_back({t, random.point(0.5f), random.point(0.3f), glm::vec3(0)});
  return out;
}

/// 40 triangles, each vertex with influences and displacements by chance.
uint32_t soft_mesh(SmallScene& small, test::Random& random, uint32_t material) {
  std::vector<glm::vec3> corners;
  for (const test::Triangle& t : test::closed_mesh(1, random.point(1), 1))
    corners.insert(corners.end(), {t.a, t.b, t.c});
  corners.resize(120);
  const uint32_t index = small.mesh(corners, material, glm::normalize(glm::vec3(1, 2, 3)));
  scene::Mesh& mesh = small.scene.meshes[index];
  mesh.target_count = targets;
  for (size_t v = 0; v < corners.size(); ++v) {
    add_row(mesh.influences, random_influences(random));
    add_row(mesh.displacements, random_displacements(random));
  }
  scene::fill_deform_bounds(mesh);
  return index;
}

glm::mat4 random_matrix(test::Random& random) {
  glm::mat4 m = glm::rotate(glm::mat4(1), random.uniform(-3, 3), random.unit());
  m = glm::scale(m, {random.uniform(0.5f, 2), random.uniform(0.5f, 2), random.uniform(0.5f, 2)});
  m[3] = glm::vec4(random.point(5), 1);
  return m;
}

/// Of one soft mesh an instance with a skin, one without, and one of a mesh that does not deform; then the soft mesh
/// once more with another skin.
SmallScene soft(test::Random& random) {
  SmallScene small;
  const uint32_t material = small.material(test::matt(glm::vec3(0.5f)));
  const uint32_t mesh = soft_mesh(small, random, material), hard = small.quad(glm::vec2(0), glm::vec2(1), material);
  small.scene.skins.resize(2);
  for (scene::Skin& skin : small.scene.skins) {
    skin.joints.assign(joints, 0);
    small.pose.joints.emplace_back();
    for (uint32_t j = 0; j < joints; ++j) small.pose.joints.back().push_back(random_matrix(random));
  }
  small.instance(mesh);
  small.instance(hard, random_matrix(random));
  small.instance(mesh, random_matrix(random));
  small.instance(mesh);
  small.scene.instances[0].skin = 0;
  small.scene.instances[3].skin = 1;
  for (const scene::Instance& instance : small.scene.instances) {
    small.pose.weights.emplace_back();
    for (uint32_t t = 0; t < targets && instance.mesh == mesh; ++t)
      small.pose.weights.back().push_back(random.uniform(-1, 2));
  }
  return small;
}

TEST_CASE("the device deforms as the host does" * doctest::test_suite("subset")) {
  test::Random random(1);
  const SmallScene small = soft(random);
  gpu::Recorder recorder(test::device());
  const scene::GpuScene gpu = small.on(recorder);
  CHECK(gpu.posed.vertex_count == 3 * 120);
  const auto positions = recorder.read<glm::vec3>(gpu.positions, gpu.posed.vertex_count, gpu.posed.first_vertex);
  uint32_t next = 0;
  for (const uint32_t instance : {0u, 2u, 3u})
    for (const glm::vec3& wanted : scene::posed_positions(small.scene, small.pose, instance))
      CHECK(glm::distance(positions[next++], wanted) < 1e-4f);
}

/// The normal that the blended joints make of a morphed one.
glm::vec3 wanted_normal(const SmallScene& small, uint32_t instance, uint32_t v) {
  const scene::Mesh& mesh = small.scene.meshes[small.scene.instances[instance].mesh];
  glm::dvec3 normal(mesh.normals[v]);
  for (const scene::Displacement& d : mesh.displacements.of(v))
    normal += glm::dvec3(d.normal) * double(small.pose.weights[instance][d.target]);
  if (!small.scene.instances[instance].skin) return glm::normalize(normal);
  glm::dmat4 blend(0);
  for (const scene::Influence& i : mesh.influences.of(v))
    blend += glm::dmat4(small.pose.joints[*small.scene.instances[instance].skin][i.joint]) * double(i.weight);
  return glm::normalize(glm::inverseTranspose(glm::dmat3(blend)) * normal);
}

TEST_CASE("normals stay normal to what deforms") {
  test::Random random(2);
  const SmallScene small = soft(random);
  gpu::Recorder recorder(test::device());
  const scene::GpuScene gpu = small.on(recorder);
  const auto vertices = recorder.read<shared::Vertex>(gpu.vertices, gpu.posed.vertex_count, gpu.posed.first_vertex);
  uint32_t next = 0;
  for (const uint32_t instance : {0u, 2u, 3u})
    for (uint32_t v = 0; v < 120; ++v)
      CHECK(glm::distance(vertices[next++].normal, wanted_normal(small, instance, v)) < 1e-3f);
}

TEST_CASE("the sphere of what deforms holds all its triangles' spheres, and little more") {
  test::Random random(3);
  for (int round = 0; round < 20; ++round) {
    const SmallScene small = soft(random);
    gpu::Recorder recorder(test::device());
    const scene::GpuScene gpu = small.on(recorder);
    const auto triangles = recorder.read<glm::vec4>(gpu.triangle_spheres, gpu.triangle_count);
    const auto objects = recorder.read<glm::vec4>(gpu.object_spheres, gpu.instance_count);
    const auto owners = recorder.read<glm::vec4>(gpu.corner_b, gpu.triangle_count);
    std::vector<double> reach(objects.size());
    for (uint32_t i = 0; i < triangles.size(); ++i) {
      const uint32_t owner = std::bit_cast<uint32_t>(owners[i].w);
      const glm::dvec4 inner(triangles[i]), outer(objects[owner]);
      const double far_end = glm::distance(glm::dvec3(inner), glm::dvec3(outer)) + inner.w;
      CHECK(far_end <= outer.w);
      reach[owner] = std::max(reach[owner], far_end);
    }
    for (const uint32_t owner : {0u, 2u, 3u}) CHECK(objects[owner].w <= reach[owner] * 1.001);
  }
}

TEST_CASE("the scene's bounds hold what deforms") {
  test::Random random(4);
  const SmallScene small = soft(random);
  gpu::Recorder recorder(test::device());
  const scene::GpuScene gpu = small.on(recorder);
  for (const gpu::Buffer* corners : {&gpu.corner_a, &gpu.corner_b, &gpu.corner_c})
    for (const glm::vec4& corner : recorder.read<glm::vec4>(*corners, gpu.triangle_count)) {
      CHECK(glm::all(glm::lessThanEqual(gpu.bounds.low, glm::vec3(corner))));
      CHECK(glm::all(glm::lessThanEqual(glm::vec3(corner), gpu.bounds.high)));
    }
}

TEST_CASE("what a skin mirrors keeps its front, and a mirror that one joint makes turns nothing") {
  test::Random random(6);
  SmallScene small = soft(random);
  for (const bool mirrored : {false, true}) {
    glm::mat4 m = random_matrix(random);
    if (mirrored) m = glm::scale(m, {1, -1, 1});
    small.pose.joints[0].assign(joints, m);
    small.pose.weights[0].assign(targets, 0.0f);
    gpu::Recorder recorder(test::device());
    const scene::GpuScene gpu = small.on(recorder);
    const auto a = recorder.read<glm::vec4>(gpu.corner_a, 40), b = recorder.read<glm::vec4>(gpu.corner_b, 40),
               c = recorder.read<glm::vec4>(gpu.corner_c, 40);
    const scene::Mesh& mesh = small.scene.meshes[small.scene.instances[0].mesh];
    for (size_t t = 0; t < 40; ++t) {
      const glm::uvec3 corner = mesh.triangles[t];
      const glm::vec3 &p = mesh.positions[corner.x], &q = mesh.positions[corner.y], &r = mesh.positions[corner.z];
      const glm::vec3 front = glm::inverseTranspose(glm::mat3(m)) * glm::cross(q - p, r - p);
      const glm::vec3 ab(b[t] - a[t]), ac(c[t] - a[t]);
      CHECK(glm::dot(glm::cross(ab, ac), front) > 0);
    }
  }
}

TEST_CASE("a mesh that nothing deforms is stored once, and no table of what deforms is made") {
  SmallScene small;
  const uint32_t quad = small.quad(glm::vec2(0), glm::vec2(1), small.material(test::matt(glm::vec3(1))));
  for (int i = 0; i < 3; ++i) small.instance(quad);
  gpu::Recorder recorder(test::device());
  const scene::GpuScene gpu = small.on(recorder);
  CHECK(gpu.positions.bytes() == 6 * sizeof(glm::vec3));
  CHECK(gpu.posed.vertex_count == 0);
  CHECK(gpu.posed.vertices.bytes() == 0);
}

TEST_CASE("a mesh that every instance deforms is not stored at rest among the drawn ones") {
  test::Random random(5);
  SmallScene small = soft(random);
  const scene::Storage storage = scene::storage_of(small.scene);
  CHECK(storage.first_own == 1);
  CHECK(storage.vertices == 6 + 3 * 120);
}

}  // namespace
}  // namespace crsh
