// Each fault that can be switched on turns a comparison red; the names are those of tests/README.md.

#include <doctest/doctest.h>

#include <string>

#include "images/boxes.h"
#include "support/render.h"

namespace crsh::test {
namespace {

/// Boxes in a room, all mirrors: of few triangles most pairs matter, and 10,000 are soon there.
RenderOptions mirrored_boxes(BoxScene& boxes) {
  boxes.boxes = {
      {{-2.5, -0.3, -2.5}, {2.5, 2.5, 2.5}}, {{-0.5, -0.3, -0.5}, {0.5, 1, 0.5}}, {{0.9, -0.1, 0.2}, {1.4, 0.5, 0.9}}};
  boxes.lights = {{1.2, 2.3, 1.5}};
  boxes.eye = {1.9, 2.1, 2.2};
  boxes.placement.turned = true;
  RenderOptions options = options_of(boxes, 160);
  options.bounces = 4;
  options.override_mirror = true;
  return options;
}

/// What a preset's picture and hits differ in from the true ones while `mutation` is at work.
std::string difference_under(const std::string& mutation, const std::string& algorithm, const scene::Scene& scene,
                             RenderOptions options) {
  const Rendered truth = render(scene, options);
  options.mutation = mutation;
  return difference(truth, render_with(algorithm, scene, options));
}

TEST_CASE("the comparison of algorithms turns red when cones are too narrow") {
  RenderOptions options;  // many triangles that are small beside a cone
  options.width = 64;
  options.height = 48;
  options.bounces = 2;
  CHECK(difference_under("narrow-cones", "crsh", own_scene("glass"), options) != "");
  CHECK(difference_under("narrow-cones", "crsh-bvh", own_scene("glass"), options) != "");
  CHECK(difference_under("narrow-cones", "rah", own_scene("glass"), options) != "");
}

RenderOptions options_of_many() {
  RenderOptions options;
  options.width = options.height = 256;
  options.bounces = 2;
  return options;
}

TEST_CASE("the comparison of algorithms turns red when pairs are dropped") {
  BoxScene boxes;
  const RenderOptions options = mirrored_boxes(boxes);
  CHECK(difference_under("dropped-pairs", "crsh", scene_of(boxes), options) != "");
  CHECK(difference_under("dropped-pairs", "crsh-bvh", own_scene("glass"), options_of_many()) != "");
  CHECK(difference_under("dropped-pairs", "rah", scene_of(boxes), options) != "");
}

/// Hits do not depend on the order of rays; tests/stages/sort_test.cpp and coherence_test.cpp turn red.
TEST_CASE("the comparison of counters turns red when the sort is unstable, and no hit or pixel changes") {
  RenderOptions options;
  options.width = 64;
  options.height = 48;
  options.bounces = 0;
  const Rendered stable = render_with("crsh-2017", own_scene("cornell"), options);
  options.mutation = "unstable-sort";
  const Rendered unstable = render_with("crsh-2017", own_scene("cornell"), options);
  CHECK(difference(stable, unstable) == "");
  CHECK(difference_of_counters(stable.statistics, unstable.statistics) != "");
}

}  // namespace
}  // namespace crsh::test
