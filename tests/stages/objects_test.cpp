// The object hierarchy: its build, its refits, and single rays through it.

#include <doctest/doctest.h>

#include <cstdlib>
#include <cstring>
#include <string>
#include <vector>

#include "bench/binned_sah.h"
#include "objects/hierarchy.h"
#include "scene/deform.h"
#include "shared/counters.h"
#include "shared/object.h"
#include "support/cases_trace.h"
#include "support/device.h"
#include "support/objects_twin.h"
#include "support/render.h"

using namespace crsh;
using namespace crsh::test;

namespace {

using Triangles = std::vector<Triangle>;

constexpr uint64_t plenty = uint64_t(1) << 26;

/// A hierarchy over triangles that may move.
struct Built {
  gpu::Recorder recorder{test::device()};
  std::vector<Object> objects;
  scene::GpuScene scene;
  objects::Hierarchy hierarchy;
  uint64_t submit_work = plenty;

  explicit Built(std::vector<Object> all, uint64_t work = plenty) : objects(std::move(all)), submit_work(work) {
    update();
  }
  explicit Built(const Triangles& triangles, uint64_t work = plenty) : Built(std::vector<Object>{{triangles}}, work) {}

  void update() {
    scene = make_scene(recorder, objects);
    scene::GeometryPose pose;
    for (const Object& object : objects) pose.instances.push_back(object.transform);
    objects::update(recorder, {scene, pose, submit_work}, hierarchy);
  }
  Tree tree() { return tree_of(recorder, hierarchy); }
  std::string fault() { return fault_of(tree(), world_triangles(recorder, scene)); }
};

double binned_cost(const Triangles& triangles) {
  std::vector<bench::SahBox> boxes;
  for (const Triangle& triangle : triangles) {
    const TreeBox box = padded_box(triangle);
    boxes.push_back({box.low, box.high});
  }
  return bench::binned_sah_cost(std::move(boxes));
}

/// Bits, because flags and numbers look like any float.
bool same_bits(const std::vector<glm::vec4>& a, const std::vector<glm::vec4>& b) {
  return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(glm::vec4)) == 0;
}

bool same_bits(const Tree& a, const Tree& b) {
  return same_bits(a.box_low, b.box_low) && same_bits(a.box_high, b.box_high) && same_bits(a.leaf_a, b.leaf_a) &&
         same_bits(a.leaf_b, b.leaf_b) && same_bits(a.leaf_c, b.leaf_c) && same_bits(a.root, b.root);
}

Triangles hard(uint32_t count) {
  Random random(count + 1);
  return hard_triangles(random, count);
}

/// One within the other around one point: each is nearest to the next smaller one.
Triangles concentric(uint32_t count) {
  Triangles triangles;
  for (uint32_t i = 0; i < count; ++i) {
    const float size = 1 + float(i);
    triangles.push_back({{-size, -size, 0}, {size, -size, 0}, {0, size, 0}});
  }
  return triangles;
}

Triangles drawn_triangles(const scene::Scene& scene) {
  const scene::Pose pose = scene.pose(0, {});
  Triangles triangles;
  for (uint32_t i = 0; i < scene.instances.size(); ++i) {
    const scene::Mesh& mesh = scene.meshes[scene.instances[i].mesh];
    const std::vector<glm::vec3> positions = scene::posed_positions(scene, pose, i);
    const auto corner = [&](uint32_t v) { return glm::vec3(pose.instances[i] * glm::vec4(positions[v], 1)); };
    for (const glm::uvec3& t : mesh.triangles) triangles.push_back({corner(t.x), corner(t.y), corner(t.z)});
  }
  return triangles;
}

}  // namespace

TEST_CASE("every triangle stands in one leaf, subtrees' triangles are neighbours, and boxes hold what is below them") {
  for (const uint32_t count : {0, 1, 2, 3, 4, 5, 8, 9, 33, 1000, 20'000}) {
    CAPTURE(count);
    Built built(hard(count));
    CHECK(built.fault() == "");
    CHECK(built.hierarchy.triangle_count == count);
    CHECK(built.hierarchy.node_count >= 1);
    CHECK(built.hierarchy.cost == doctest::Approx(sah_cost(built.tree())).epsilon(1e-4));
  }
}

TEST_CASE("triangles that are all alike, or points, or around one centre, make a tree that is not too deep") {
  const Triangle one{{1, 2, 3}, {2, 2, 3}, {1, 3, 3}}, point{{5, 5, 5}, {5, 5, 5}, {5, 5, 5}};
  for (const uint32_t count : {2u, 3u, 17u, 5000u}) {
    CAPTURE(count);
    CHECK(Built(Triangles(count, one)).fault() == "");
    CHECK(Built(Triangles(count, point)).fault() == "");
    CHECK(Built(concentric(count)).fault() == "");
  }
}

TEST_CASE("triangles that are all alike pair up by twos, so that rounds are few") {
  const Built built(Triangles(4096, Triangle{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}));
  CHECK(built.hierarchy.ranks.size() <= 12);
}

TEST_CASE("the same triangles give the same tree, bit for bit, whatever a submit may carry") {
  const Triangles triangles = hard(3000);
  const Tree tree = Built(triangles).tree();
  CHECK(same_bits(tree, Built(triangles).tree()));
  CHECK(same_bits(tree, Built(triangles, 1000).tree()));
}

/// 1.15 times what a binned SAH build costs at most.
void check_cost(const scene::Scene& scene) {
  const Triangles triangles = drawn_triangles(scene);
  const double cost = sah_cost(Built(triangles).tree()), binned = binned_cost(triangles);
  MESSAGE(scene.path.filename().string(), ": ", cost, " against ", binned, " (", cost / binned, ")");
  CHECK(cost <= 1.15 * binned);
}

TEST_CASE("the tree costs little more than that of a binned SAH build, on the project's scenes") {
  for (const char* name : {"cornell", "office", "colonnade", "glass", "moving", "walking", "morphing"}) {
    CAPTURE(name);
    check_cost(own_scene(name));
  }
}

TEST_CASE("the tree costs little more than that of a binned SAH build, on real scenes") {
  for (const char* path : {"sponza/sponza_whole.glb", "office/office_drafting_objects.glb",
                           "cornell/cornell_six_mirrors_790.glb", "models/bunny_69k.glb"}) {
    const scene::Scene* scene = shared_scene(path);
    if (!scene) {
      MESSAGE("skipped: ", path, " is not here (CRSH_SHARED_SCENES, ../shared/scenes)");
      continue;
    }
    CAPTURE(path);
    check_cost(*scene);
  }
}

/// A hundred boxes of triangles in a row.
std::vector<Object> crowd() {
  std::vector<Object> objects;
  for (uint32_t i = 0; i < 100; ++i) {
    objects.push_back({closed_mesh(1, glm::vec3(0), 0.4f)});
    objects.back().transform[3] = glm::vec4(float(i % 10), 0, float(i / 10), 1);
  }
  return objects;
}

TEST_CASE("where nothing moves nothing is done, and where something moves a little boxes are refitted") {
  Built built(crowd());
  const Tree start = built.tree();
  built.update();
  CHECK(built.hierarchy.builds == 1);
  CHECK(built.hierarchy.refits == 0);
  for (Object& object : built.objects) object.transform[3].y += 0.01f * object.transform[3].x;
  built.update();
  CHECK(built.fault() == "");
  CHECK(built.hierarchy.builds == 1);
  CHECK(built.hierarchy.refits == 1);
  CHECK(built.hierarchy.cost == doctest::Approx(sah_cost(built.tree())).epsilon(1e-4));
  for (Object& object : built.objects) object.transform[3].y = 0;
  built.update();
  CHECK(built.hierarchy.refits == 2);
  CHECK(same_bits(built.tree(), start));
}

TEST_CASE("a tree that refitting has made loose is built anew") {
  Built built(crowd());
  const double before = built.hierarchy.cost;
  Random random(3);
  for (Object& object : built.objects) object.transform[3] = glm::vec4(random.point(5), 1);
  built.update();
  CHECK(built.fault() == "");
  CHECK(built.hierarchy.builds == 2);
  CHECK(built.hierarchy.refits == 1);
  CHECK(built.hierarchy.cost < 2 * before);
  CHECK(same_bits(built.tree(), Built(built.objects).tree()));
}

TEST_CASE("a million triangles that all move are refitted, and built anew where that has made them loose" *
          doctest::test_suite("full") * doctest::skip(!std::getenv("CRSH_TEST_FULL"))) {
  std::vector<Object> objects;
  const Triangles mesh = closed_mesh(3, glm::vec3(0), 0.4f);  // 1280
  for (uint32_t i = 0; i < 800; ++i) {
    objects.push_back({mesh});
    objects.back().transform[3] = glm::vec4(float(i % 10), float(i / 10 % 10), float(i / 100), 1);
  }
  Built built(objects);
  CHECK(built.hierarchy.triangle_count == 1'024'000);
  CHECK(built.fault() == "");
  for (Object& object : built.objects) object.transform[3].y += 0.02f * object.transform[3].x;
  built.update();
  CHECK(built.fault() == "");
  CHECK(built.hierarchy.refits == 1);
  CHECK(built.hierarchy.builds == 1);
  Random random(9);
  for (Object& object : built.objects) object.transform[3] = glm::vec4(random.point(5), 1);
  built.update();
  CHECK(built.fault() == "");
  CHECK(built.hierarchy.refits == 2);
  CHECK(built.hierarchy.builds == 2);
}

TEST_CASE("rays one by one meet what brute force does, and count what they test") {
  Random random(11);
  const Triangles triangles = hard(1500);
  Tracer tracer(test::device());
  const scene::GpuScene scene =
      make_scene(tracer.recorder(),
                 {{.triangles = triangles}, {.triangles = hard(500), .transmissive = true, .single_sided = true}});
  const SortedBatch rays = make_batch(test::device(), {light_rays(random, triangles, 2000),
                                                       mirror_rays(random, triangles, 2000, shared::kind_reflection),
                                                       stray_rays(random, triangles, 2000, shared::kind_refraction)});
  const Traced brute = tracer.trace_all(scene, rays), single = tracer.trace_single(scene, rays);
  CHECK(different_hits(brute, single).empty());
  for (uint32_t kind = 0; kind < 3; ++kind) {
    CHECK(single.counter(kind, shared::counter_box_tests) > 2 * 2000);
    CHECK(single.counter(kind, shared::counter_triangle_tests) <
          brute.counter(kind, shared::counter_triangle_tests) / 4);
  }
  const Traced small = tracer.trace_single(scene, rays, 5000);
  CHECK(different_hits(single, small).empty());
  CHECK(single.counters == small.counters);
}

TEST_CASE("rays that need very many tests go on from dispatch to dispatch" * doctest::test_suite("subset")) {
  const uint32_t count = 9000;
  const Triangles triangles(count, Triangle{{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}});
  Tracer tracer(test::device());
  for (const bool transmissive : {false, true}) {
    const scene::GpuScene scene =
        make_scene(tracer.recorder(), {{.triangles = triangles, .transmissive = transmissive}});
    std::vector<shared::Ray> shadow, reflection;
    for (int i = 0; i < 40; ++i) {
      const glm::vec3 from(0.01f * float(i), 0, 2), to(0.005f * float(i), 0.1f, -2);
      shadow.push_back(ray_between(from, to, shared::kind_shadow, 1));
      reflection.push_back(ray_between(from, to, shared::kind_reflection));
    }
    const SortedBatch rays = make_batch(test::device(), {shadow, reflection});
    const Traced brute = tracer.trace_all(scene, rays), single = tracer.trace_single(scene, rays);
    CHECK(different_hits(brute, single).empty());
    CHECK(single.counter(shared::kind_reflection, shared::counter_triangle_tests) == 40 * count);
    if (!transmissive) CHECK(single.counter(shared::kind_shadow, shared::counter_triangle_tests) <= 40 * 4);
  }
}

TEST_CASE("rays over one triangle, or none") {
  Tracer tracer(test::device());
  const Triangle one{{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}};
  for (const uint32_t count : {0u, 1u}) {
    const scene::GpuScene scene = make_scene(tracer.recorder(), {{.triangles = Triangles(count, one)}});
    const SortedBatch rays = make_batch(test::device(), {{ray_between({0, 0, 1}, {0, 0, -1}, shared::kind_reflection),
                                                          ray_between({9, 0, 1}, {9, 0, 2}, shared::kind_reflection)}});
    const Traced single = tracer.trace_single(scene, rays);
    CHECK(different_hits(tracer.trace_all(scene, rays), single).empty());
    CHECK(single.counter(shared::kind_reflection, shared::counter_triangle_tests) == count);
  }
}
