// No bound ever rejects a ray that hits: whatever the hierarchy, rays find what brute force finds, bit for bit.

#include <doctest/doctest.h>

#include <algorithm>
#include <glm/gtc/matrix_transform.hpp>
#include <string>
#include <vector>

#include "shared/counters.h"
#include "support/cases_trace.h"
#include "support/device.h"
#include "support/kinds.h"

using namespace crsh;
using namespace crsh::test;

namespace {

AlgorithmOptions algorithm(uint32_t arity, uint32_t levels) {
  AlgorithmOptions options;
  options.arity = arity;
  options.levels.fill(levels);
  return options;
}

glm::mat4 placed(Random& random, const glm::vec3& scale) {
  glm::mat4 m = glm::translate(glm::mat4(1), random.point(2));
  m = glm::rotate(m, random.uniform(0, 6), random.unit());
  m = glm::scale(m, scale);
  return glm::rotate(m, random.uniform(0, 6), random.unit());
}

/// Hard triangles and a closed mesh, as they are, scaled, sheared and mirrored; some tinted, some single-sided.
std::vector<Object> hard_objects(Random& random) {
  return {{.triangles = hard_triangles(random, 150)},
          {.triangles = hard_triangles(random, 40), .transmissive = true},
          {.triangles = hard_triangles(random, 40), .single_sided = true},
          {.triangles = closed_mesh(1, random.point(1), 0.7f), .transform = placed(random, glm::vec3(0.3f))},
          {.triangles = closed_mesh(1, glm::vec3(0), 0.5f),
           .transform = placed(random, {3, 0.02f, 1}),
           .transmissive = true},
          {.triangles = hard_triangles(random, 33), .transform = placed(random, {-1, 0.1f, 2}), .single_sided = true},
          {.triangles = {}},
          {.triangles = {{{0, 0, 1}, {1, 0, 1}, {0, 1, 1}}}}};
}

struct World {
  scene::GpuScene scene;
  SortedBatch rays;
};

using Lists = std::vector<std::vector<shared::Ray>>;

/// Two lights, stray shadow rays, two mirrors and stray rays behind them, refraction.
Lists ray_lists(Random& random, const std::vector<Triangle>& triangles, size_t count) {
  Lists lists = {light_rays(random, triangles, count), light_rays(random, triangles, count / 3),
                 stray_rays(random, triangles, count / 2, shared::kind_shadow),
                 mirror_rays(random, triangles, count, shared::kind_reflection)};
  const auto more = mirror_rays(random, triangles, count / 2, shared::kind_reflection);
  lists[3].insert(lists[3].end(), more.begin(), more.end());
  lists.push_back(stray_rays(random, triangles, count, shared::kind_refraction));
  return lists;
}

World make_world(Tracer& tracer, uint32_t seed) {
  Random random(seed);
  World world;
  world.scene = make_scene(tracer.recorder(), hard_objects(random));
  const Lists lists = ray_lists(random, world_triangles(tracer.recorder(), world.scene), 400);
  world.rays = make_batch(tracer.recorder().device(), lists, seed % 2 ? &random : nullptr);
  return world;
}

bool hits_something(const glm::uvec4& hit) { return hit.y != shared::none && hit.x != 0; }

uint32_t count_hits(const Traced& traced) { return uint32_t(std::ranges::count_if(traced.hits, hits_something)); }

}  // namespace

TEST_CASE("no bound rejects a ray that hits, whatever the arity, levels, fit, interval and mesh culling") {
  Tracer tracer(test::device());
  for (uint32_t seed = 1; seed <= 6; ++seed) {
    const World world = make_world(tracer, seed);
    const Traced all = tracer.trace_all(world.scene, world.rays);
    REQUIRE(count_hits(all) > 500);
    for (const auto& [arity, levels] : {std::pair{2u, 1u}, {2u, 5u}, {3u, 4u}, {8u, 1u}, {8u, 2u}, {8u, 3u}, {64u, 2u}})
      for (const uint32_t switches : {0u, 1u, 2u, 4u, 7u, 9u}) {
        TraceOptions options{algorithm(arity, levels)};
        options.algorithm.fit = switches & 1 ? Fit::all : Fit::merged;
        options.algorithm.interval = switches & 2;
        options.algorithm.mesh_culling = switches & 4;
        options.algorithm.cone_test = switches & 8 ? ConeTest::as_printed : ConeTest::with_sign;
        options.submit_work = seed % 2 ? 1 << 26 : 1 << 16;
        const Traced traced = tracer.trace(world.scene, world.rays, options);
        CAPTURE(seed);
        CAPTURE(arity);
        CAPTURE(levels);
        CAPTURE(switches);
        CHECK(different_hits(traced, all).empty());
      }
  }
}

TEST_CASE("no bound of the build's rejects a ray that hits, with nodes of one size and cut where coherence ends") {
  Tracer tracer(test::device());
  for (uint32_t seed = 1; seed <= 6; ++seed) {
    const World world = make_world(tracer, seed);
    const Traced all = tracer.trace_all(world.scene, world.rays);
    for (const std::string& bound : hierarchy::bound_names())
      for (const auto& [arity, levels] : {std::pair{2u, 1u}, {2u, 5u}, {8u, 2u}, {64u, 2u}})
        for (const uint32_t switches : {0u, 1u, 3u}) {
          TraceOptions options{algorithm(arity, levels)};
          options.algorithm.bound = bound;
          options.algorithm.interval = switches & 1;
          options.algorithm.nodes = switches & 2 ? NodeCut::cut : NodeCut::fixed;
          options.algorithm.cut_angle = seed % 2 ? 0.3f : 3.0f;
          const Traced traced = tracer.trace(world.scene, world.rays, options);
          CAPTURE(seed);
          CAPTURE(bound);
          CAPTURE(arity);
          CAPTURE(switches);
          CHECK(different_hits(traced, all).empty());
        }
  }
}

/// With nodes that are cut and that are not, on both builds of the kernel.
void check_objects(Tracer& tracer, const World& world, const Traced& all, uint32_t seed) {
  for (const std::string& bound : hierarchy::bound_names())
    for (const auto& [arity, levels] : {std::pair{2u, 1u}, {8u, 2u}, {64u, 2u}})
      for (const bool cut : {false, true}) {
        TraceOptions options{algorithm(arity, levels)};
        options.algorithm.bound = bound;
        options.algorithm.interval = seed % 2;
        options.algorithm.cone_test = seed % 2 ? ConeTest::with_sign : ConeTest::as_printed;
        options.algorithm.nodes = cut ? NodeCut::cut : NodeCut::fixed;
        options.algorithm.cut_angle = 0.3f, options.algorithm.cut_distance = 0.1f, options.extent = 4;
        options.submit_work = seed % 3 ? uint64_t(1) << 26 : 1 << 14;
        CAPTURE(seed);
        CAPTURE(bound);
        CAPTURE(arity);
        CAPTURE(cut);
        CHECK(different_hits(tracer.trace_objects(world.scene, world.rays, options), all).empty());
      }
}

TEST_CASE("no ray that hits is lost by a node in the object hierarchy, where lanes walk together and alone") {
  gpu::DeviceRequest request = test::device().request();
  request.no_shuffles = true;
  gpu::Device alone(request);
  for (gpu::Device* device : {&test::device(), &alone}) {
    Tracer tracer(*device);
    for (uint32_t seed = 1; seed <= (device == &alone ? 1u : 2u); ++seed) {
      const World world = make_world(tracer, seed);
      check_objects(tracer, world, tracer.trace_all(world.scene, world.rays), seed);
    }
  }
}

TEST_CASE("rays of nodes that need very many tests go one by one, and lose no hit") {
  Tracer tracer(test::device());
  Random random(11);
  const std::vector<Triangle> triangles = closed_mesh(5, glm::vec3(0), 1);
  if (test::device().limits().max_texels < 9 * triangles.size()) {  // three vertices of three texels
    MESSAGE("skipped: so many vertices are more than this device's texel buffers hold");
    return;
  }
  const scene::GpuScene scene = make_scene(tracer.recorder(), {{.triangles = triangles, .transmissive = true}});
  const SortedBatch rays = make_batch(test::device(),
                                      {stray_rays(random, triangles, 3000, shared::kind_shadow),
                                       stray_rays(random, triangles, 3000, shared::kind_reflection)},
                                      &random);
  TraceOptions options{algorithm(64, 2)};
  options.algorithm.bound = "slab";
  const Traced traced = tracer.trace_objects(scene, rays, options);
  CHECK(different_hits(traced, tracer.trace_all(scene, rays)).empty());
  // Each ray by itself makes so many box tests; those of the nodes that gave up come on top.
  const Traced single = tracer.trace_single(scene, rays);
  for (const uint32_t kind : {shared::kind_shadow, shared::kind_reflection})
    CHECK(traced.counter(kind, shared::counter_box_tests) >= single.counter(kind, shared::counter_box_tests));
}

TEST_CASE("lanes that walk together and alone make the same tests") {
  gpu::DeviceRequest request = test::device().request();
  request.no_shuffles = true;
  gpu::Device no_shuffle_device(request);
  Tracer together(test::device()), alone(no_shuffle_device);
  const World one = make_world(together, 4), other = make_world(alone, 4);
  TraceOptions options{algorithm(8, 2)};
  options.algorithm.bound = "slab-edges", options.algorithm.nodes = NodeCut::cut;
  const Traced a = together.trace_objects(one.scene, one.rays, options),
               b = alone.trace_objects(other.scene, other.rays, options);
  for (size_t i = 0; i < a.hits.size(); ++i) CHECK(a.hits[i] == b.hits[i]);
  // The frontier's entries, and the triangles of its leaves, are tested side by side: so many of them as lanes.
  CHECK(double(a.counter(0, shared::counter_box_tests)) ==
        doctest::Approx(double(b.counter(0, shared::counter_box_tests))).epsilon(0.2));
}

TEST_CASE("edges tell the halves of a wall apart: a coherent node is left with the triangle that its rays hit") {
  Tracer tracer(test::device());
  const scene::GpuScene scene = make_scene(
      tracer.recorder(), {{.triangles = {{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}}, {{0, 0, 0}, {1, 1, 0}, {0, 1, 0}}}}});
  Random random(3);
  std::vector<shared::Ray> rays;
  for (uint32_t i = 0; i < 8; ++i)
    rays.push_back(
        ray_between({0.7f, 0.2f, 1}, glm::vec3(0.8f, 0.3f, 0) + random.point(0.02f), shared::kind_reflection));
  const SortedBatch batch = make_batch(test::device(), {rays});
  for (const auto& [bound, pairs] : {std::pair{"slab", 2u}, {"slab-edges", 1u}}) {
    TraceOptions options{algorithm(8, 1)};
    options.algorithm.bound = bound;
    CHECK(tracer.trace(scene, batch, options).pairs.size() == pairs);
  }
}

TEST_CASE("an object's sphere holds its triangles' spheres, also where a mesh is modelled far from where it stands") {
  gpu::Recorder recorder(test::device());
  for (uint32_t seed = 1; seed <= 200; ++seed) {
    Random random(seed);
    const glm::vec3 modelled = random.unit() * random.scale(1, 1e5f);
    glm::mat4 transform = placed(random, seed % 2 ? glm::vec3(1) : glm::vec3(-1, 0.3f, 2));
    if (seed % 4 < 2)
      transform[3] = glm::vec4(-glm::vec3(transform * glm::vec4(modelled, 0)), 1);  // back to the origin
    const std::vector<Triangle> triangle = {{modelled, modelled + random.unit(), modelled + random.unit()}};
    const scene::GpuScene scene =
        make_scene(recorder, {{seed % 3 ? triangle : closed_mesh(0, modelled, 0.5f), transform}});
    const glm::vec4 object = recorder.read<glm::vec4>(scene.object_spheres, 1)[0];
    double outside = 0;
    for (const glm::vec4& own : recorder.read<glm::vec4>(scene.triangle_spheres, scene.triangle_count))
      outside = std::max(outside, glm::distance(glm::dvec3(object), glm::dvec3(own)) + own.w - object.w);
    CAPTURE(seed);
    CHECK(outside == 0);
  }
}

TEST_CASE("ray kinds mixed in one batch find the same hits and count the same as each in a batch of its own") {
  Tracer tracer(test::device());
  Random random(21);
  const scene::GpuScene scene = make_scene(tracer.recorder(), hard_objects(random));
  const Lists lists = ray_lists(random, world_triangles(tracer.recorder(), scene), 300);
  for (const PerKind<uint32_t>& levels : {test::in_turn<uint32_t>({2}), test::in_turn<uint32_t>({3, 1, 5})}) {
    TraceOptions options{algorithm(8, 2)};
    options.algorithm.levels = levels;
    const Traced mixed = tracer.trace(scene, make_batch(test::device(), lists), options);
    Traced separate;
    separate.counters.resize(mixed.counters.size());
    for (const std::vector<shared::Ray>& list : lists) {
      const Traced part = tracer.trace(scene, make_batch(test::device(), {list}), options);
      separate.hits.insert(separate.hits.end(), part.hits.begin(), part.hits.end());
      for (size_t i = 0; i < part.counters.size(); ++i) separate.counters[i] += part.counters[i];
    }
    CHECK(mixed.hits == separate.hits);
    CHECK(mixed.counters == separate.counters);
  }
}

TEST_CASE("two runs give the same pairs in the same order, and the same counters") {
  Tracer tracer(test::device());
  const World world = make_world(tracer, 5);
  for (const uint32_t levels : {1u, 3u}) {
    const TraceOptions options{algorithm(8, levels)};
    const Traced first = tracer.trace(world.scene, world.rays, options),
                 second = tracer.trace(world.scene, world.rays, options);
    CHECK(same_pairs(first.pairs, second.pairs));
    CHECK(first.counters == second.counters);
    CHECK(first.hits == second.hits);
  }
}

TEST_CASE("with cones or slabs 1% too narrow a ray is lost") {
  Tracer tracer(test::device());
  const World world = make_world(tracer, 1);
  const Traced all = tracer.trace_all(world.scene, world.rays);
  for (const std::string& bound : hierarchy::bound_names())
    for (const Fit fit : {Fit::merged, Fit::all}) {
      CAPTURE(bound);
      TraceOptions options{algorithm(8, 2)};
      options.algorithm.fit = fit;
      options.algorithm.bound = bound;
      CHECK(different_hits(tracer.trace(world.scene, world.rays, options), all).empty());
      options.mutation = "narrow-cones";
      CHECK(!different_hits(tracer.trace(world.scene, world.rays, options), all).empty());
    }
}

TEST_CASE("with every 10,000th pair dropped a hit is lost") {
  Tracer tracer(test::device());
  Random random(8);
  std::vector<Triangle> apart;  // so that nearly every pair is a hit
  for (uint32_t i = 0; i < 64; ++i) {
    const glm::vec3 corner(i % 8, i / 8, 0);
    apart.push_back({corner, corner + glm::vec3(0.1f, 0, 0), corner + glm::vec3(0, 0.1f, 0)});
  }
  std::vector<shared::Ray> rays;
  for (uint32_t i = 0; i < 80'000; ++i) {
    const glm::vec3 inside = apart[i / 2 % 64].a + glm::vec3(0.02f);
    rays.push_back(ray_between(inside + glm::vec3(0, 0, random.uniform(0.5f, 1)), inside - glm::vec3(0, 0, 1),
                               shared::kind_reflection));
  }
  const scene::GpuScene scene = make_scene(tracer.recorder(), {{.triangles = apart}});
  const SortedBatch batch = make_batch(test::device(), {rays});
  TraceOptions options{algorithm(2, 1)};
  const Traced whole = tracer.trace(scene, batch, options);
  CHECK(whole.pairs.size() >= 40'000);
  CHECK(count_hits(whole) == rays.size());
  options.mutation = "dropped-pairs";
  CHECK(!different_hits(tracer.trace(scene, batch, options), whole).empty());
}
