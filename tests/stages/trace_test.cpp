// How a batch is said to have been traced: which tracer each segment had, and whether rays were sorted and bundled.

#include "trace/trace.h"

#include <doctest/doctest.h>

#include <algorithm>
#include <numeric>

#include "shared/limits.h"
#include "stages/batches.h"
#include "support/cases.h"
#include "support/cases_trace.h"
#include "support/device.h"

namespace crsh::test {
namespace {

constexpr uint32_t rays_a_segment = 512;

/// Side by side, from above the ball straight down through it, or up.
std::vector<shared::Ray> parallel_rays(uint32_t kind, float end = -4) {
  std::vector<shared::Ray> rays;
  for (uint32_t i = 0; i < rays_a_segment; ++i) {
    const float x = 0.9f * float(i) / rays_a_segment;
    rays.push_back(ray_between({x, 0.1f, 4}, {x, 0.1f, end}, kind));
  }
  return rays;
}

/// Shadow rays of one light, parallel reflection rays, and refraction rays from anywhere to anywhere.
rays::Batch mixed_batch(const std::vector<Triangle>& triangles) {
  Random random(5);
  std::vector<shared::Ray> rays = light_rays(random, triangles, rays_a_segment);
  for (const auto& more :
       {parallel_rays(shared::kind_reflection), stray_rays(random, triangles, rays_a_segment, shared::kind_refraction)})
    rays.insert(rays.end(), more.begin(), more.end());
  return make_batch(rays, {{shared::kind_shadow, 0, 0, rays_a_segment},
                           {shared::kind_reflection, 0, 0, rays_a_segment},
                           {shared::kind_refraction, 0, 0, rays_a_segment}});
}

/// A ball of triangles, and what a renderer would keep to trace rays to it.
struct Place {
  explicit Place(uint32_t splits = 3) : triangles(closed_mesh(splits, glm::vec3(0), 1)) {
    scene = make_scene(recorder, {{.triangles = triangles, .transmissive = true}});
  }

  trace::Traced trace(const rays::Batch& batch, const std::string& algorithm) {
    options.algorithm = preset(algorithm);
    trace::place(recorder, {scene, {}, options.submit_work}, trace::tracer_of(options.algorithm).needs, structures);
    return trace::trace(recorder, {.scene = scene,
                                   .structures = structures,
                                   .batch = batch,
                                   .names = {batch.rays, batch.rays},
                                   .options = options,
                                   .counters = counters,
                                   .workspace = workspace});
  }
  std::vector<glm::uvec4> hits(const rays::Batch& batch) {
    return recorder.read<glm::uvec4>(workspace.hits, batch.count);
  }

  std::vector<Triangle> triangles;
  gpu::Recorder recorder{device()};
  scene::GpuScene scene;
  trace::Counters counters{device(), 0};
  trace::Structures structures;
  trace::Workspace workspace;
  RenderOptions options;
};

std::vector<std::string> names_of(const trace::Traced& traced) {
  std::vector<std::string> names;
  for (const trace::Tracer* tracer : traced.tracers) names.emplace_back(tracer->name);
  return names;
}

TEST_CASE("a segment of scattered rays goes one by one, beside others that are sorted and bundled") {
  Place place;
  const rays::Batch batch = mixed_batch(place.triangles);
  const trace::Traced traced = place.trace(batch, "crsh-bvh");
  CHECK(names_of(traced) == std::vector<std::string>{"object-nodes", "object-nodes", "single-rays"});
  CHECK(traced.sorted());
  REQUIRE(traced.depth() == 2);
  CHECK(traced.hierarchy().levels[0].segments[1].count > 0);
  CHECK(traced.hierarchy().levels[0].segments[2].count == 0);
  const std::vector<glm::uvec4> hits = place.hits(batch);
  const trace::Traced brute = place.trace(batch, "brute");
  CHECK(names_of(brute) == std::vector<std::string>(3, "brute"));
  CHECK(brute.depth() == 0);
  CHECK(place.hits(batch) == hits);
}

TEST_CASE("where all rays are scattered none are sorted, whatever the batch before was like") {
  Place place;
  const rays::Batch mixed = mixed_batch(place.triangles);
  CHECK(place.trace(mixed, "crsh-bvh").depth() == 2);
  Random random(6);
  const rays::Batch batch = make_batch(stray_rays(random, place.triangles, rays_a_segment, shared::kind_reflection),
                                       {{shared::kind_reflection, 0, 0, rays_a_segment}, {shared::kind_refraction}});
  const trace::Traced traced = place.trace(batch, "crsh-bvh");
  CHECK(names_of(traced)[0] == "single-rays");
  CHECK(traced.bundle == nullptr);
  CHECK_FALSE(traced.sorted());
  CHECK(traced.depth() == 0);
  CHECK(traced.hierarchy().depth == 0);
}

TEST_CASE("a scene of few triangles is met by single rays, however coherent they are") {
  Place small(0);
  const trace::Traced traced = small.trace(mixed_batch(small.triangles), "crsh-bvh");
  CHECK(names_of(traced) == std::vector<std::string>(3, "single-rays"));
  CHECK(traced.bundle == nullptr);
}

TEST_CASE("hits of the batch before are gone, whoever traces") {
  Place place;
  const std::vector<rays::Segment> one = {{shared::kind_reflection, 0, 0, rays_a_segment}};
  const rays::Batch down = make_batch(parallel_rays(shared::kind_reflection), one),
                    up = make_batch(parallel_rays(shared::kind_reflection, 8), one);
  const auto misses = [](const glm::uvec4& hit) { return hit.y == shared::none; };
  for (const std::string& algorithm : preset_names()) {
    CAPTURE(algorithm);
    CHECK(place.trace(down, algorithm).tracers.size() == 1);
    CHECK(std::ranges::none_of(place.hits(down), misses));
    CHECK(place.trace(up, algorithm).tracers.size() == 1);
    CHECK(std::ranges::all_of(place.hits(up), misses));
  }
}

TEST_CASE("rays without keys are bundled as they were created, and not called sorted") {
  Place place;
  const rays::Batch batch = mixed_batch(place.triangles);
  const trace::Traced traced = place.trace(batch, "rah");
  CHECK(names_of(traced) == std::vector<std::string>(3, "mesh-nodes"));
  REQUIRE(traced.bundle != nullptr);
  CHECK_FALSE(traced.sorted());
  CHECK(traced.depth() == 2);
  const auto order = place.recorder.read<uint32_t>(traced.bundle->order.order, batch.count);
  std::vector<uint32_t> as_created(batch.count);
  std::iota(as_created.begin(), as_created.end(), 0u);
  CHECK(order == as_created);
}

}  // namespace
}  // namespace crsh::test
