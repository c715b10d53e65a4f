// The traversal (section 3.2.5) against a walk in plain C++, and under forced trouble.

#include <doctest/doctest.h>

#include <algorithm>
#include <cstdlib>
#include <set>
#include <string_view>
#include <vector>

#include "shared/counters.h"
#include "support/cases_trace.h"
#include "support/device.h"
#include "support/kinds.h"
#include "traversal_twin.h"

using namespace crsh;
using namespace crsh::test;

namespace {

AlgorithmOptions algorithm(uint32_t arity, const std::vector<uint32_t>& levels) {
  AlgorithmOptions options;
  options.arity = arity;
  options.levels = in_turn(levels);
  return options;
}

/// Several objects, about 1,700 triangles.
std::vector<Object> objects() {
  Random random(11);
  return {{.triangles = hard_triangles(random, 100)},
          {.triangles = closed_mesh(2, {1, 0, 0}, 0.5f)},
          {.triangles = closed_mesh(2, {-1, 0, 0.5f}, 0.3f), .transmissive = true},
          {.triangles = wall(22)}};
}

std::vector<std::vector<shared::Ray>> ray_lists(const std::vector<Triangle>& triangles) {
  Random random(12);
  return {light_rays(random, triangles, 517), light_rays(random, triangles, 64),
          mirror_rays(random, triangles, 700, shared::kind_reflection),
          stray_rays(random, triangles, 129, shared::kind_refraction)};
}

/// Scene and rays on a device of their own.
struct Place {
  explicit Place(gpu::Device& device) : tracer(device), scene(make_scene(tracer.recorder(), objects())) {
    rays = make_batch(device, ray_lists(world_triangles(tracer.recorder(), scene)));
  }
  Tracer tracer;
  scene::GpuScene scene;
  SortedBatch rays;
};

/// Expected pairs and counters, by the twin.
Traced twin_of(Place& place, const AlgorithmOptions& options) {
  const WalkIn in = read_for_walk(place.tracer.recorder(), place.tracer.hierarchy(), place.scene, options);
  Traced expected;
  expected.counters.resize(kind_count * shared::counters_per_row);
  for (size_t s = 0; s < place.rays.batch.segments.size(); ++s) {
    const uint32_t kind = place.rays.batch.segments[s].kind, depth = options.levels[kind];
    const Walk found = walk(in, depth, place.tracer.hierarchy().levels[depth - 1].segments[s]);
    uint64_t* row = &expected.counters[kind * shared::counters_per_row];
    row[shared::counter_mesh_tests] += found.mesh_tests;
    for (uint32_t l = 0; l < depth; ++l) {
      row[shared::counter_level_tests + l] += found.levels[l].tests;
      row[shared::counter_level_hits + l] += found.levels[l].hits;
    }
    for (const shared::HitPair& pair : found.pairs) {
      const glm::uvec2 rays = in.children[0][pair.node];
      row[shared::counter_triangle_tests] += rays.y - rays.x;
    }
    expected.pairs.insert(expected.pairs.end(), found.pairs.begin(), found.pairs.end());
  }
  return expected;
}

/// Node-major also where small batches of triangles come one after another.
std::vector<shared::HitPair> by_node(std::vector<shared::HitPair> pairs) {
  std::ranges::stable_sort(pairs, {}, &shared::HitPair::node);
  return pairs;
}

gpu::DeviceRequest request() {
  gpu::DeviceRequest wanted = device().request();
  wanted.selector = std::to_string(device().info().index);
  return wanted;
}

std::vector<AlgorithmOptions> several_algorithms() {
  std::vector<AlgorithmOptions> all = {algorithm(8, {2}), algorithm(8, {1, 3, 2}), algorithm(2, {5, 4, 1}),
                                       algorithm(64, {2, 1, 2}), algorithm(3, {2, 5, 3})};
  all[1].fit = Fit::merged;
  all[2].interval = false;
  all[3].mesh_culling = false;
  all[4].cone_test = ConeTest::as_printed;
  return all;
}

void check_same(const Traced& traced, const Traced& expected) {
  CHECK(same_pairs(traced.pairs, expected.pairs));
  CHECK(traced.counters == expected.counters);
}

}  // namespace

TEST_CASE("pairs and counters of every level are those of a walk on the CPU") {
  Place place(device());
  for (const AlgorithmOptions& options : several_algorithms()) {
    const Traced traced = place.tracer.trace(place.scene, place.rays, {options});
    CAPTURE(options.arity);
    CHECK(traced.pairs.size() > 1000);
    check_same(traced, twin_of(place, options));
  }
}

TEST_CASE("equation 9 as printed keeps every pair that the signed test keeps, and what lies behind a node besides") {
  Place place(device());
  AlgorithmOptions options = algorithm(8, {2, 2, 2});
  options.interval = false;
  const auto pairs_of = [&](ConeTest test) {
    options.cone_test = test;
    std::set<std::pair<uint32_t, uint32_t>> pairs;
    for (const shared::HitPair& pair : place.tracer.trace(place.scene, place.rays, {options}).pairs)
      pairs.emplace(pair.node, pair.triangle);
    return pairs;
  };
  const auto with_sign = pairs_of(ConeTest::with_sign), as_printed = pairs_of(ConeTest::as_printed);
  CHECK(std::ranges::includes(as_printed, with_sign));
  CHECK(as_printed.size() > with_sign.size());
}

TEST_CASE("whole nodes below two levels: level-1 tests are arity times level-2 hits") {
  Place place(device());
  const auto lists = ray_lists(world_triangles(place.tracer.recorder(), place.scene));
  place.rays = make_batch(device(), {{lists[0].begin(), lists[0].begin() + 512}});
  const Traced traced = place.tracer.trace(place.scene, place.rays, {algorithm(8, {2})});
  const uint64_t hits = traced.counter(shared::kind_shadow, shared::counter_level_hits + 1);
  CHECK(hits > 0);
  CHECK(traced.counter(shared::kind_shadow, shared::counter_level_tests) == 8 * hits);
  CHECK(traced.counter(shared::kind_shadow, shared::counter_triangle_tests) ==
        8 * traced.counter(shared::kind_shadow, shared::counter_level_hits));
}

TEST_CASE("buffers that begin with 1 or 64 bytes give the same pairs, counters and hits") {
  Place place(device());
  for (const uint64_t capacity : {1, 64}) {
    gpu::DeviceRequest wanted = request();
    wanted.first_capacity = capacity;
    gpu::Device other(wanted);
    Place there(other);
    for (const AlgorithmOptions& options : several_algorithms()) {
      const Traced expected = place.tracer.trace(place.scene, place.rays, {options});
      const Traced traced = there.tracer.trace(there.scene, there.rays, {options});
      CAPTURE(capacity);
      CAPTURE(options.arity);
      check_same(traced, expected);
      CHECK(different_hits(traced, expected).empty());
    }
    CHECK(other.validation_messages() == 0);
  }
}

TEST_CASE("the table's tracer of nodes over meshes takes the same steps") {
  Place place(device());
  TraceOptions options{preset("crsh-2017")};
  options.submit_work = 1 << 16;
  const Traced steps = place.tracer.trace(place.scene, place.rays, options),
               row = place.tracer.trace_by_table(place.scene, place.rays, options);
  CHECK(steps.hits == row.hits);
  CHECK(steps.counters == row.counters);
}

TEST_CASE("lanes that walk alone give the same pairs, counters and hits as those that walk together") {
  Place place(device());
  gpu::DeviceRequest wanted = request();
  wanted.no_shuffles = true;
  gpu::Device other(wanted);
  Place there(other);
  for (const AlgorithmOptions& options : several_algorithms())
    for (const uint64_t submit_work : {1 << 26, 1 << 16}) {
      const Traced expected = place.tracer.trace(place.scene, place.rays, {options, submit_work});
      const Traced traced = there.tracer.trace(there.scene, there.rays, {options, submit_work});
      CAPTURE(options.arity);
      CAPTURE(submit_work);
      check_same(traced, expected);
      CHECK(different_hits(traced, expected).empty());
    }
  CHECK(other.validation_messages() == 0);
}

TEST_CASE("submits of 2^16 tests give the same pairs a node, counters and hits") {
  Place place(device());
  for (const AlgorithmOptions& options : several_algorithms()) {
    const Traced expected = place.tracer.trace(place.scene, place.rays, {options});
    const Traced traced = place.tracer.trace(place.scene, place.rays, {options, 1 << 16});
    CAPTURE(options.arity);
    CHECK(traced.slices > expected.slices);
    CHECK(same_pairs(by_node(traced.pairs), by_node(expected.pairs)));
    CHECK(traced.counters == expected.counters);
    CHECK(different_hits(traced, expected).empty());
  }
}

TEST_CASE("little memory gives the same pairs in the same order, counters and hits, in more slices") {
  Place place(device());
  gpu::DeviceRequest wanted = request();
  wanted.memory_budget = 2'000'000;
  gpu::Device other(wanted);
  Place there(other);
  uint32_t slices = 0, expected_slices = 0;
  for (const AlgorithmOptions& options : several_algorithms()) {
    const Traced expected = place.tracer.trace(place.scene, place.rays, {options});
    const Traced traced = there.tracer.trace(there.scene, there.rays, {options});
    slices += traced.slices, expected_slices += expected.slices;
    CAPTURE(options.arity);
    check_same(traced, expected);
    CHECK(different_hits(traced, expected).empty());
  }
  CHECK(slices > expected_slices);
  CHECK(other.validation_messages() == 0);
}

TEST_CASE("a node that may hit over 65,535 triangles loses none of them") {
  Tracer tracer(device());
  const scene::GpuScene scene = make_scene(tracer.recorder(), {{.triangles = wall(188)}});
  REQUIRE(scene.triangle_count > 70'000);
  const std::vector<Triangle> triangles = world_triangles(tracer.recorder(), scene);
  std::vector<shared::Ray> rays;
  for (uint32_t i = 0; i < 64; ++i) {
    const Triangle& aim = triangles[i * (triangles.size() - 1) / 63];
    rays.push_back(ray_between({0, 0, 0.1f}, (aim.a + aim.b + aim.c) / 3.0f, shared::kind_reflection));
  }
  const SortedBatch batch = make_batch(device(), {rays});
  const Traced all = tracer.trace_all(scene, batch);
  const Traced traced = tracer.trace(scene, batch, {algorithm(64, {2})});
  CHECK(all.counter(shared::kind_reflection, shared::counter_triangle_tests) == 64ull * scene.triangle_count);
  CHECK(all.hits.back().y == scene.triangle_count - 1);
  CHECK(traced.pairs.size() > 65'535);
  CHECK(different_hits(traced, all).empty());
}
