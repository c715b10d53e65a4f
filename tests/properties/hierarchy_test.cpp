// A parent's bound contains its children's, in exact arithmetic.

#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "hierarchy/hierarchy.h"
#include "support/cases_trace.h"
#include "support/device.h"
#include "support/twin_bounds.h"

using namespace crsh;
using namespace crsh::test;

namespace {

using Lists = std::vector<std::vector<shared::Ray>>;

/// Nodes whose directions are nearly opposite to their neighbours', so that merged cones are about right angles.
std::vector<shared::Ray> wide_rays(Random& random, size_t count) {
  std::vector<shared::Ray> rays;
  while (rays.size() < count) {
    const glm::vec3 axis = random.unit(), origin = random.point(10);
    const glm::vec3 beside = glm::normalize(glm::cross(axis, random.unit()));
    const float lift = random.scale(1e-6f, 1e-1f);
    const glm::vec3 one = beside + axis * lift, other = axis * lift * random.uniform(0, 2) - beside;
    for (uint32_t i = 0; i < 16; ++i)  // nodes of 8 that are narrow, and about opposite to the next
      rays.push_back(ray_between(origin, origin + (i < 8 ? one : other), shared::kind_reflection));
  }
  return rays;
}

/// All in (or next to) one point and one direction, up to the last places of float.
std::vector<shared::Ray> nearly_equal_rays(Random& random, size_t count) {
  const glm::vec3 from = random.point(100), to = random.point(100);
  std::vector<shared::Ray> rays;
  while (rays.size() < count)
    rays.push_back(ray_between(from + random.point(1e-6f), to + random.point(1e-4f), shared::kind_shadow));
  return rays;
}

Lists ray_lists(uint32_t seed) {
  Random random(seed);
  const std::vector<Triangle> targets = hard_triangles(random, 100);
  return {light_rays(random, targets, 400), nearly_equal_rays(random, 200), wide_rays(random, 400),
          mirror_rays(random, targets, 400, shared::kind_reflection),
          stray_rays(random, targets, 400, shared::kind_refraction)};
}

struct Built {
  SortedBatch rays;
  std::vector<std::vector<Bound>> bounds;                ///< a level, a node
  std::vector<std::vector<glm::uvec2>> children, under;  ///< a level, a node: children, and rays
};

/// Nodes are read as the balls and cones that they are, or that stand around them.
Built build(const Lists& lists, uint32_t arity, Fit fit, const std::string& name = "sphere-cone", bool narrow = false) {
  Built built{make_batch(test::device(), lists), {}, {}, {}};
  AlgorithmOptions options;
  options.arity = arity;
  options.levels.fill(4);
  options.fit = fit;
  options.bound = name;
  gpu::Recorder recorder(test::device());
  hierarchy::Hierarchy hierarchy;
  hierarchy::build(recorder, {built.rays.sorted, built.rays.batch.segments, options, narrow}, hierarchy);
  for (uint32_t l = 0; l < hierarchy.depth; ++l) {
    const hierarchy::Level& level = hierarchy.levels[l];
    std::vector<Bound> bounds;
    for (const shared::Node& node : hierarchy::outlines(recorder, hierarchy, l)) bounds.push_back(bound_of(node));
    built.bounds.push_back(std::move(bounds));
    built.children.push_back(recorder.read<glm::uvec2>(level.children, level.count));
    built.under.push_back(recorder.read<glm::uvec2>(level.rays, level.count));
  }
  return built;
}

uint32_t count_rays_outside(const Built& built) {
  uint32_t outside = 0;
  for (size_t l = 0; l < built.bounds.size(); ++l)
    for (size_t i = 0; i < built.bounds[l].size(); ++i)
      for (uint32_t ray = built.under[l][i].x; ray < built.under[l][i].y; ++ray)
        outside += !holds(built.bounds[l][i], bound_of(built.rays.sorted_rays[ray]));
  return outside;
}

uint32_t count_children_outside(const Built& built) {
  uint32_t outside = 0;
  for (size_t l = 1; l < built.bounds.size(); ++l)
    for (size_t i = 0; i < built.bounds[l].size(); ++i)
      for (uint32_t child = built.children[l][i].x; child < built.children[l][i].y; ++child)
        outside += !holds(built.bounds[l][i], built.bounds[l - 1][child]);
  return outside;
}

}  // namespace

TEST_CASE("a node's ball and cone contain all of its rays, merged and fitted, whatever its bound") {
  for (const std::string& name : hierarchy::bound_names())
    for (uint32_t seed = 1; seed <= (name == "sphere-cone" ? 10u : 4u); ++seed)
      for (const uint32_t arity : {2u, 3u, 8u})
        for (const Fit fit : {Fit::merged, Fit::all}) {
          CAPTURE(name);
          CAPTURE(seed);
          CAPTURE(arity);
          CAPTURE(int(fit));
          CHECK(count_rays_outside(build(ray_lists(seed), arity, fit, name)) == 0);
        }
}

TEST_CASE("a merged ball and cone contain their children's, also next to a right angle") {
  for (uint32_t seed = 1; seed <= 20; ++seed)
    for (const uint32_t arity : {2u, 8u}) {
      CAPTURE(seed);
      CAPTURE(arity);
      CHECK(count_children_outside(build(ray_lists(seed), arity, Fit::merged)) == 0);
    }
}

TEST_CASE("with cones 1% too narrow rays lie outside of their nodes") {
  for (const Fit fit : {Fit::merged, Fit::all})
    CHECK(count_rays_outside(build(ray_lists(1), 8, fit, "sphere-cone", true)) > 0);
}
