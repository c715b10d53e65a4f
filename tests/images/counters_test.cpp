// What the counters mean, checked on whole frames.

#include <doctest/doctest.h>

#include <string>

#include "crsh/kinds.h"
#include "images/built_scene.h"
#include "support/render.h"

namespace crsh::test {
namespace {

RenderOptions small(const std::string& algorithm) {
  RenderOptions options;
  options.width = 20;
  options.height = 15;
  options.bounces = 2;
  options.algorithm = preset(algorithm);
  return options;
}

TEST_CASE("brute force tests every ray of every kind and bounce against every triangle, once") {
  for (const char* name : {"cornell", "glass"}) {
    const Rendered rendered = render(own_scene(name), small("brute"));
    for (const RayStatistics& row : rendered.statistics.rays) {
      CAPTURE(row.kind);
      CAPTURE(row.bounce);
      CHECK(row.triangles == own_scene(name).triangle_count());
      CHECK(row.triangle_tests == row.count * row.triangles);
      CHECK(row.total_tests() == row.triangle_tests);
      CHECK(row.levels.empty());
    }
  }
}

TEST_CASE("rays are cast by the definition: shadow rays at every bounce, the others before the last") {
  const Rendered rendered = render(own_scene("glass"), small("crsh"));
  CHECK(rendered.statistics.rays.size() == 3 * kind_count);
  for (const RayStatistics& row : rendered.statistics.rays) {
    CAPTURE(row.kind);
    CAPTURE(row.bounce);
    const RayKind& kind = ray_kinds[*kind_named(row.kind)];
    CHECK((row.count > 0) == (kind.adds_light && kind.cast_at(row.bounce, 2)));
    CHECK(row.hits <= row.count);
  }
}

/// Nodes over `count` children of `segments` segments, of which each may end in a partial node.
void check_nodes(uint64_t nodes, uint64_t count, uint64_t arity, uint64_t segments) {
  CHECK(nodes >= (count + arity - 1) / arity);
  CHECK(nodes < count / arity + segments + 1);
}

/// Each hit of a node is a test of each of its children: `arity`, or fewer for the last node of a segment.
void check_tests_below(uint64_t tests, uint64_t hits_above, uint64_t arity, uint64_t partial_nodes,
                       uint64_t triangles) {
  CHECK(tests <= arity * hits_above);
  CHECK(tests + (arity - 1) * partial_nodes * triangles >= arity * hits_above);
}

void check_levels(const RayStatistics& row, uint64_t arity, uint64_t segments) {
  uint64_t count = row.count, hits_above = 0;
  for (size_t l = row.levels.size(); l-- > 0; count = row.levels[l].nodes)
    check_nodes(row.levels[l].nodes, count, arity, segments);
  for (const LevelStatistics& level : row.levels) {
    CHECK(level.hits <= level.tests);
    CHECK(level.tests == level.hits + level.misses());
    if (&level != &row.levels.front()) check_tests_below(level.tests, hits_above, arity, segments, row.triangles);
    hits_above = level.hits;
  }
  check_tests_below(row.triangle_tests, hits_above, arity, segments, row.triangles);
}

TEST_CASE("nodes, tests and hits of all levels fit together") {
  for (const uint32_t levels : {1, 2, 3}) {
    RenderOptions options = small("crsh");
    options.algorithm.levels.fill(levels);
    options.algorithm.nodes = NodeCut::fixed;
    const Rendered rendered = render(own_scene("glass"), options);
    for (const RayStatistics& row : rendered.statistics.rays) {
      CAPTURE(row.kind);
      CAPTURE(row.bounce);
      CHECK(row.levels.size() == (row.count ? levels : 0));
      check_levels(row, options.algorithm.arity, row.kind == "shadow" ? own_scene("glass").lights.size() : 1);
    }
  }
}

TEST_CASE("cut nodes are no fewer than full ones, and each hit of one is a test of every child") {
  RenderOptions options = small("crsh");
  const Rendered cut = render(own_scene("glass"), options);
  options.algorithm.nodes = NodeCut::fixed;
  const Rendered fixed = render(own_scene("glass"), options);
  for (size_t r = 0; r < cut.statistics.rays.size(); ++r) {
    const RayStatistics &row = cut.statistics.rays[r], &full = fixed.statistics.rays[r];
    CHECK(row.hits_digest == full.hits_digest);
    REQUIRE(row.levels.size() == full.levels.size());
    if (row.levels.empty()) continue;
    CHECK(row.levels.back().nodes >= full.levels.back().nodes);
    CHECK(row.triangle_tests <= options.algorithm.arity * row.levels.back().hits);
  }
}

TEST_CASE("without mesh culling the top level's nodes are tested against every triangle, and no object is") {
  const Rendered rendered = render(own_scene("cornell"), small("rah"));
  for (const RayStatistics& row : rendered.statistics.rays) {
    CHECK(row.object_tests() == 0);
    if (row.count) CHECK(row.levels.front().tests == row.levels.front().nodes * row.triangles);
  }
}

TEST_CASE("with mesh culling the top level's nodes are tested against every object") {
  const Rendered rendered = render(own_scene("cornell"), small("crsh"));
  for (const RayStatistics& row : rendered.statistics.rays) {
    if (row.count) CHECK(row.mesh_tests == row.levels.front().nodes * own_scene("cornell").instances.size());
    if (row.count) CHECK(row.levels.front().tests <= row.levels.front().nodes * row.triangles);
  }
}

uint64_t tests_of(const Rendered& rendered, const char* kind) {
  return rays_of(rendered.statistics, kind, 0).total_tests();
}

/// What more pixels change: nodes hold rays that are nearer to each other, so that a hierarchy of rays alone gains, and
/// a hierarchy of objects does not. (On Office and Sponza: views_test.cpp.)
TEST_CASE("crsh alone needs more tests a ray than bvh for few rays, and gains on it with each doubling of the image") {
  double last = 1e9;
  for (const uint32_t height : {24, 48, 96, 192}) {
    RenderOptions options;
    options.width = height * 4 / 3, options.height = height, options.bounces = 0;
    const scene::Scene& scene = own_scene("office");
    const double ratio = double(tests_of(render_with("crsh", scene, options), "shadow")) /
                         double(tests_of(render_with("bvh", scene, options), "shadow"));
    CAPTURE(height);
    if (height == 24) CHECK(ratio > 1);
    CHECK(ratio < 0.8 * last);
    last = ratio;
  }
}

/// A floor that fills the view, below a grid of little triangles behind the eye: every pixel casts one shadow ray, and
/// with mirrors one reflection ray.
Rendered floor_under_grid() {
  Triangles triangles;
  triangles.add_quad({-9, 0, 9}, {9, 0, 9}, {9, 0, -9}, {-9, 0, -9});
  for (int i = -3; i <= 3; ++i)
    for (int j = -3; j <= 3; ++j) {
      const glm::vec3 corner(0.5f * float(i), 3, 0.5f * float(j));
      triangles.add_quad(corner, corner + glm::vec3(0.3f, 0, 0), corner + glm::vec3(0.3f, 0.1f, 0.3f),
                         corner + glm::vec3(0, 0, 0.3f));
    }
  RenderOptions options;
  options.width = options.height = 64;
  options.bounces = 1;
  options.override_mirror = true;
  options.view.eye = {0, 2, 0.5f};
  options.view.target = {0, 0, 0};
  options.lights = {{{0.1f, 6, 0.2f}, 30.0f}};
  options.algorithm = preset("crsh");
  options.algorithm.levels.fill(2);
  options.algorithm.nodes = NodeCut::fixed;
  return render(built_scene(triangles, {matt(glm::vec3(0.5f))}), options);
}

TEST_CASE("where all nodes are full, each hit of a node is as many tests below as the arity") {
  const Rendered rendered = floor_under_grid();
  for (const char* kind : {"shadow", "reflection"}) {
    CAPTURE(std::string(kind));
    const RayStatistics& row = rays_of(rendered.statistics, kind, 0);
    CHECK(row.count == 64 * 64);
    CHECK(row.hits > 0);
    REQUIRE(row.levels.size() == 2);
    const LevelStatistics &two = row.levels[0], &one = row.levels[1];
    CHECK(two.nodes == 64);
    CHECK(one.nodes == 512);
    CHECK(one.tests == 8 * two.hits);
    CHECK(row.triangle_tests == 8 * one.hits);
  }
}

}  // namespace
}  // namespace crsh::test
