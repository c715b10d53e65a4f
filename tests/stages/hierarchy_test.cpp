// The hierarchy of ray nodes (section 3.2.4): who holds whom, and how tightly.

#include <doctest/doctest.h>

#include <cmath>
#include <string>
#include <vector>

#include "hierarchy/hierarchy.h"
#include "hierarchy/sample.h"
#include "hierarchy_twin.h"
#include "shared/limits.h"
#include "support/cases_trace.h"
#include "support/device.h"
#include "support/kinds.h"
#include "support/twin_bounds.h"

using namespace crsh;
using namespace crsh::test;
using hierarchy::Hierarchy;

namespace {

/// `count` rays of a kind, coherent enough to have narrow cones.
std::vector<shared::Ray> bundle(Random& random, uint32_t count, uint32_t kind) {
  std::vector<shared::Ray> rays;
  const glm::vec3 from = random.point(3), to = random.point(3);
  const float spread = random.scale(1e-3f, 1);
  for (uint32_t i = 0; i < count; ++i)
    rays.push_back(ray_between(from + random.point(spread), to + random.point(spread), kind, random.uniform(0.5f, 2)));
  return rays;
}

SortedBatch bundles(const std::vector<glm::uvec2>& kinds_and_counts, uint32_t seed = 1) {
  Random random(seed);
  std::vector<std::vector<shared::Ray>> lists;
  for (const glm::uvec2& wanted : kinds_and_counts) lists.push_back(bundle(random, wanted.y, wanted.x));
  SortedBatch batch = make_batch(test::device(), lists);
  for (size_t s = 0; s < lists.size(); ++s) batch.batch.segments[s].kind = kinds_and_counts[s].x;  // also of empty ones
  return batch;
}

AlgorithmOptions options_of(uint32_t arity, const std::vector<uint32_t>& levels, Fit fit = Fit::merged) {
  AlgorithmOptions options;
  options.arity = arity;
  options.levels = in_turn(levels);
  options.fit = fit;
  return options;
}

void build(gpu::Recorder& recorder, const SortedBatch& batch, const AlgorithmOptions& options, Hierarchy& out) {
  hierarchy::build(recorder, {batch.sorted, batch.batch.segments, options}, out);
}

void check_level(gpu::Recorder& recorder, const hierarchy::Level& level, const TwinLevel& twin) {
  REQUIRE(level.count == twin.children.size());
  for (size_t s = 0; s < twin.nodes.size(); ++s) CHECK(level.segments[s].count == twin.nodes[s]);
  CHECK(recorder.read<glm::uvec2>(level.children, level.count) == twin.children);
  CHECK(recorder.read<glm::uvec2>(level.rays, level.count) == twin.rays);
  std::vector<uint32_t> parents = recorder.read<uint32_t>(level.parents, twin.parents.size());
  for (size_t i = 0; i < parents.size(); ++i)
    if (twin.parents[i] == shared::none) parents[i] = shared::none;  // has none: not written
  CHECK(parents == twin.parents);
}

void check_grouping(Hierarchy& out, const SortedBatch& batch, const AlgorithmOptions& options) {
  gpu::Recorder recorder(test::device());
  build(recorder, batch, options, out);
  const std::vector<TwinLevel> twin = twin_levels(batch.batch.segments, options);
  REQUIRE(out.depth == twin.size());
  for (uint32_t l = 0; l < out.depth; ++l) {
    CAPTURE(l);
    check_level(recorder, out.levels[l], twin[l]);
  }
}

struct Read {
  std::vector<std::vector<shared::Node>> nodes;
  std::vector<std::vector<shared::Interval>> intervals;
  std::vector<TwinLevel> levels;
};

Read built(const SortedBatch& batch, const AlgorithmOptions& options) {
  gpu::Recorder recorder(test::device());
  Hierarchy hierarchy;
  build(recorder, batch, options, hierarchy);
  Read read;
  for (uint32_t l = 0; l < hierarchy.depth; ++l) {
    read.nodes.push_back(recorder.read<shared::Node>(hierarchy.levels[l].nodes, hierarchy.levels[l].count));
    read.intervals.push_back(recorder.read<shared::Interval>(hierarchy.levels[l].intervals, hierarchy.levels[l].count));
  }
  read.levels = twin_levels(batch.batch.segments, options);
  return read;
}

/// As far as float may be from double, and outwards.
bool agrees(const Bound& device, const Bound& exact, double size) {
  const double error = 4e-6 * size;
  const bool sphere = glm::distance(device.centre, exact.centre) <= error &&
                      device.radius >= exact.radius * (1 - 1e-6) - error &&
                      device.radius <= exact.radius * (1 + 1e-4) + 10 * error;
  if (exact.angle > 1.5) return sphere;  // beyond the paper's equations
  return sphere && std::abs(device.angle - exact.angle) <= 1e-4 * exact.angle + 1e-5 &&
         angle_between(device.axis, exact.axis) <= 1e-5 + 1e-4 * exact.angle;
}

std::vector<Bound> merged_level(const TwinLevel& level, const std::vector<shared::Ray>& rays,
                                const std::vector<Bound>* below) {
  std::vector<Bound> bounds;
  for (const glm::uvec2& children : level.children) {
    Bound bound = below ? (*below)[children.x] : bound_of(rays[children.x]);
    for (uint32_t i = children.x + 1; i < children.y; ++i)
      bound = below ? merged(bound, (*below)[i]) : merged(bound, rays[i]);
    bounds.push_back(bound);
  }
  return bounds;
}

std::vector<Bound> fitted_level(const TwinLevel& level, const std::vector<shared::Ray>& rays) {
  std::vector<Bound> bounds;
  for (const glm::uvec2& range : level.rays)
    bounds.push_back(fitted(std::span(rays).subspan(range.x, range.y - range.x)));
  return bounds;
}

uint32_t count_disagreeing(const std::vector<shared::Node>& nodes, const std::vector<Bound>& exact) {
  uint32_t count = 0;
  for (size_t i = 0; i < nodes.size(); ++i) count += !agrees(bound_of(nodes[i]), exact[i], 10);
  return count;
}

}  // namespace

TEST_CASE("nodes group neighbours of one segment, for every number of rays, arity and number of levels") {
  Hierarchy kept;  // buffers serve larger and smaller batches in turn
  for (const uint32_t n : {4097u, 0u, 1u, 7u, 8u, 9u, 64u, 65u}) {
    const SortedBatch batch = bundles({{shared::kind_reflection, n}});
    for (const uint32_t arity : {2u, 3u, 8u, 64u})
      for (const uint32_t levels : {1u, 2u, 5u}) {
        CAPTURE(n);
        CAPTURE(arity);
        CAPTURE(levels);
        check_grouping(kept, batch, options_of(arity, {1, levels, 1}));
      }
  }
}

TEST_CASE("no node holds rays of two segments, and each kind has as many levels as it asks for") {
  const SortedBatch batch = bundles({{0, 65}, {0, 0}, {0, 9}, {1, 4097}, {2, 7}, {2, 64}, {2, 0}});
  Hierarchy kept;
  for (const std::vector<uint32_t>& levels :
       std::vector<std::vector<uint32_t>>{{2, 2, 2}, {1, 5, 3}, {4, 1, 2}, {3, 2, 5}})
    for (const uint32_t arity : {2u, 3u, 8u}) {
      CAPTURE(levels[0]);
      CAPTURE(arity);
      check_grouping(kept, batch, options_of(arity, levels));
    }
}

TEST_CASE("the children of a run of nodes are those of its nodes together") {
  const SortedBatch batch = bundles({{0, 65}, {1, 100}, {2, 7}});
  gpu::Recorder recorder(test::device());
  Hierarchy hierarchy;
  build(recorder, batch, options_of(3, {3}), hierarchy);
  const std::vector<TwinLevel> twin = twin_levels(batch.batch.segments, options_of(3, {3}));
  for (uint32_t l = 0; l < 3; ++l)
    for (uint32_t first = 0; first < hierarchy.levels[l].count; ++first)
      for (uint32_t end = first + 1; end <= hierarchy.levels[l].count; ++end) {
        const hierarchy::Range children = hierarchy.levels[l].children_of({first, end - first});
        REQUIRE(glm::uvec2(children.first, children.end()) ==
                glm::uvec2(twin[l].children[first].x, twin[l].children[end - 1].y));
      }
}

TEST_CASE("merged bounds are those of equations 1 to 8, and no smaller") {
  for (uint32_t seed = 1; seed <= 8; ++seed) {
    const SortedBatch batch = bundles({{0, 300}, {1, 517}}, seed);
    const Read read = built(batch, options_of(8, {3}));
    std::vector<Bound> below;
    for (size_t l = 0; l < read.levels.size(); ++l) {
      below = merged_level(read.levels[l], batch.sorted_rays, l ? &below : nullptr);
      CAPTURE(seed);
      CAPTURE(l);
      CHECK(count_disagreeing(read.nodes[l], below) == 0);
    }
  }
}

TEST_CASE("fitted bounds are the smallest about the middle of their rays' boxes, and no smaller") {
  for (uint32_t seed = 1; seed <= 8; ++seed) {
    const SortedBatch batch = bundles({{0, 300}, {1, 517}}, seed);
    const Read read = built(batch, options_of(8, {3}, Fit::all));
    for (size_t l = 0; l < read.levels.size(); ++l) {
      CAPTURE(seed);
      CAPTURE(l);
      CHECK(count_disagreeing(read.nodes[l], fitted_level(read.levels[l], batch.sorted_rays)) == 0);
    }
  }
}

TEST_CASE("a node's interval ends with its longest ray") {
  const SortedBatch batch = bundles({{0, 300}, {1, 65}});
  for (const Fit fit : {Fit::merged, Fit::all}) {
    const Read read = built(batch, options_of(8, {3, 2, 2}, fit));
    for (size_t l = 0; l < read.levels.size(); ++l)
      for (size_t i = 0; i < read.nodes[l].size(); ++i) {
        float far_end = 0;
        for (uint32_t ray = read.levels[l].rays[i].x; ray < read.levels[l].rays[i].y; ++ray)
          far_end = std::max(far_end, batch.sorted_rays[ray].origin.w);
        REQUIRE(read.intervals[l][i].far_end == far_end);
      }
  }
}

TEST_CASE("bounds of more rays than a lane may walk are merged from below") {
  const SortedBatch batch = bundles({{0, 70'000}});  // lavapipe 22.3 ends loops after 65,535 iterations
  const Read read = built(batch, options_of(64, {3}, Fit::all));
  REQUIRE(read.nodes[2].size() == 1);
  uint32_t outside = 0;
  for (const shared::Ray& ray : batch.sorted_rays) outside += !holds(bound_of(read.nodes[2][0]), bound_of(ray));
  CHECK(outside == 0);
}

/// Rays in `bunches` of one direction each, opposite to the one before.
std::vector<shared::Ray> bunched(uint32_t count, uint32_t bunch, uint32_t kind) {
  std::vector<shared::Ray> rays;
  for (uint32_t i = 0; i < count; ++i) {
    const float side = i / bunch % 2 ? -1.0f : 1.0f;
    rays.push_back(ray_between(glm::vec3(0), side * glm::vec3(1, 2, 3), kind, 1));
  }
  return rays;
}

/// Nodes of the runs of rays that are looked at, and those rays.
double expected_mean(uint32_t count, uint32_t bunch, uint32_t arity) {
  const uint32_t runs = (count + shared::cut_run - 1) / shared::cut_run, stride = (runs + 255) / 256;
  uint32_t rays = 0, nodes = 0;
  for (uint32_t begin = 0; begin < count; begin += stride * shared::cut_run) {
    const uint32_t end = std::min(begin + shared::cut_run, count);
    for (uint32_t i = begin, head = begin; i < end; ++i, ++rays) {
      const bool ends = i > begin && (i - head == arity || i % bunch == 0);
      if (i == begin || ends) head = i, ++nodes;
    }
  }
  return double(rays) / nodes;
}

TEST_CASE("how many rays nodes would hold is found from a sample of the rays as they were created") {
  gpu::Recorder recorder(test::device());
  gpu::Buffer sums;
  AlgorithmOptions options = options_of(8, {2});
  options.cut_angle = 0.1f;
  for (const uint32_t count : {1u, 127u, 128u, 129u, 5'000u, 100'000u})
    for (const uint32_t bunch : {1u, 3u, 5u, 1'000u}) {
      CAPTURE(count);
      CAPTURE(bunch);
      const SortedBatch batch =
          make_batch(test::device(),
                     {bunched(count, bunch, shared::kind_shadow), {}, bunched(count, bunch, shared::kind_reflection)});
      const std::vector<float> means = hierarchy::rays_a_node(recorder, {batch.batch, options, 1}, sums);
      CHECK(std::isinf(means[0]));
      CHECK(std::isinf(means[1]));
      CHECK(means[2] == doctest::Approx(expected_mean(count, bunch, 8)));
    }
}
