// Rays as data: what a frame dumps, replayed, is counted and hit as in the frame.

#include <doctest/doctest.h>

#include <string>
#include <tuple>
#include <vector>

#include "images/built_scene.h"
#include "shared/limits.h"
#include "support/device.h"
#include "support/render.h"

namespace crsh::test {
namespace {

struct Dumped {
  Statistics statistics;
  RayTable rays;
};

/// Two samples; sides that are no multiple of a tile's.
RenderOptions small(const std::string& algorithm) {
  RenderOptions options;
  options.width = 13;
  options.height = 10;
  options.bounces = 2;
  options.samples = 2;
  options.algorithm = preset(algorithm);
  return options;
}

Dumped dumped(const scene::Scene& scene, const RenderOptions& options) {
  Renderer renderer(borrowed(device()), borrowed(scene), options);
  Dumped result;
  (void)renderer.render(0, {}, &result.rays);
  result.statistics = renderer.statistics();
  return result;
}

Dumped replayed(const scene::Scene& scene, const RenderOptions& options, const RayTable& rays) {
  Renderer renderer(borrowed(device()), borrowed(scene), options);
  Dumped result;
  renderer.replay(rays, 0, &result.rays);
  result.statistics = renderer.statistics();
  return result;
}

/// The first column that differs, by its number.
int different_column(const RayTable& a, const RayTable& b) {
  int column = 0, found = -1;
  std::vector<const void*> others;
  for_columns(b, [&](const auto& values) { others.push_back(&values); });
  for_columns(a, [&](const auto& values) {
    if (values != *static_cast<decltype(&values)>(others[column]) && found < 0) found = column;
    ++column;
  });
  return found;
}

TEST_SUITE_BEGIN("subset");

TEST_CASE("a frame's rays, replayed with the same algorithm, have the frame's counters, keys, places and hits") {
  for (const std::string& algorithm : preset_names()) {
    CAPTURE(algorithm);
    const Dumped frame = dumped(own_scene("glass"), small(algorithm));
    const Dumped replay = replayed(own_scene("glass"), small(algorithm), frame.rays);
    CHECK(difference_of_counters(frame.statistics, replay.statistics) == "");
    CHECK(different_column(frame.rays, replay.rays) == -1);
  }
}

TEST_SUITE_END();

TEST_CASE("one frame's rays, replayed with any algorithm, have the counters of a frame rendered with it") {
  const Dumped frame = dumped(own_scene("office"), small("crsh"));
  for (const std::string& algorithm : preset_names()) {
    CAPTURE(algorithm);
    const Dumped replay = replayed(own_scene("office"), small(algorithm), frame.rays);
    CHECK(difference_of_counters(dumped(own_scene("office"), small(algorithm)).statistics, replay.statistics) == "");
    CHECK(replay.rays.hit == frame.rays.hit);
    CHECK(replay.rays.t == frame.rays.t);
    CHECK(replay.rays.transmittance == frame.rays.transmittance);
  }
}

TEST_CASE("in a scene too small to sort rays for, they stay where they were created, and are replayed alike") {
  Triangles triangles;
  triangles.add_quad({-1, 0, 1}, {1, 0, 1}, {1, 0, -1}, {-1, 0, -1});
  triangles.add_quad({-1, -0.5f, 0.5f}, {1, -0.5f, 0.5f}, {1, 0.8f, 0.5f}, {-1, 0.8f, 0.5f});
  const scene::Scene scene = built_scene(triangles, {matt(glm::vec3(0.5f))});
  RenderOptions options = small("crsh-bvh");
  options.override_mirror = true;
  const Dumped frame = dumped(scene, options);
  REQUIRE(frame.rays.size() > 0);
  for (uint32_t row = 0; row < frame.rays.size(); ++row) CHECK(frame.rays.sorted[row] == row);
  CHECK(different_column(frame.rays, replayed(scene, options, frame.rays).rays) == -1);
}

TEST_CASE("a dump sums up to the counters, and its places are those of a sort by batch, kind, light and key") {
  const Dumped frame = dumped(own_scene("glass"), small("crsh"));
  const RayTable& rays = frame.rays;
  uint64_t counted = 0;
  for (const RayStatistics& row : frame.statistics.rays) counted += row.count;
  CHECK(counted == rays.size());
  std::vector<uint32_t> row_at(rays.size(), shared::none);
  for (uint32_t row = 0; row < rays.size(); ++row) row_at.at(rays.sorted[row]) = row;
  const auto place = [&](uint32_t row) {
    return std::tuple(rays.batch[row], rays.kind[row], rays.light[row], rays.key[row], row);
  };
  size_t misplaced = 0;
  for (uint32_t i = 1; i < rays.size(); ++i) misplaced += !(place(row_at[i - 1]) < place(row_at[i]));
  CHECK(misplaced == 0);
}

}  // namespace
}  // namespace crsh::test
