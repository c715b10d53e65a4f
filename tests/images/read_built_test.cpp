// What the viewer looks at: refined pictures, other options for the same scene, nodes and boxes off the device.

#include <doctest/doctest.h>

#include <cmath>

#include "hierarchy/hierarchy.h"
#include "support/device.h"
#include "support/kinds.h"
#include "support/render.h"

namespace crsh::test {
namespace {

RenderOptions small(const std::string& algorithm = "crsh") {
  RenderOptions options;
  options.width = 24;
  options.height = 16;
  options.bounces = 1;
  options.layers = LayerSet::all();
  options.algorithm = preset(algorithm);
  return options;
}

TEST_SUITE_BEGIN("subset");

TEST_CASE("a picture refined sample by sample is that of all samples at once") {
  RenderOptions options = small();
  Renderer renderer(borrowed(device()), borrowed(own_scene("cornell")), options);
  Picture refined = renderer.render(0);
  for (int sample = 1; sample < 3; ++sample) refined = renderer.refine(0);
  options.samples = 3;
  CHECK(difference(refined, render(own_scene("cornell"), options).picture) == "");
}

TEST_CASE("a renderer with changed options renders as a new one") {
  Renderer renderer(borrowed(device()), borrowed(own_scene("moving")), small());
  (void)renderer.render(0);
  RenderOptions options = small("rah");
  options.width = 30, options.bounces = 2;
  options.view.eye = glm::vec3(1, 2, 6);
  options.lights = {{.position = {1, 3, 2}, .candela = 50}};
  renderer.change(options);
  const Picture picture = renderer.render(0.5);
  const Rendered fresh = render(own_scene("moving"), options, 0.5);
  CHECK(difference(picture, fresh.picture) == "");
  CHECK(difference_of_counters(renderer.statistics(), fresh.statistics) == "");
}

TEST_CASE("a renderer whose kinds of rays change renders as a new one") {
  Renderer renderer(borrowed(device()), borrowed(own_scene("cornell")), small());
  (void)renderer.render(0);
  for (const std::vector<bool>& rays : {std::vector{true, false, true}, {true}, {false, true}, {true, false, false}}) {
    RenderOptions options = small();
    options.rays = in_turn(rays);
    renderer.change(options);
    CHECK(difference(renderer.render(0), render(own_scene("cornell"), options).picture) == "");
  }
}

TEST_CASE("options that are wrong change nothing") {
  Renderer renderer(borrowed(device()), borrowed(own_scene("cornell")), small());
  const Picture before = renderer.render(0);
  RenderOptions wrong = small();
  wrong.camera = "no such camera";
  CHECK_THROWS((void)renderer.change(wrong));
  CHECK(difference(before, renderer.render(0)) == "");
}

TEST_CASE("a frame that is cancelled at any submit leaves nothing behind") {
  struct Cancelled {};
  for (const char* algorithm : {"crsh", "bvh"}) {
    const Rendered whole = render(own_scene("moving"), small(algorithm), 0.25);
    Renderer renderer(borrowed(device()), borrowed(own_scene("moving")), small(algorithm));
    for (int left = 0; left < 40; left += 3) {
      int submits = left;
      renderer.on_submit([&] {
        if (submits-- == 0) throw Cancelled{};
      });
      try {
        (void)renderer.render(0.25);
      } catch (const Cancelled&) {
      }
    }
    renderer.on_submit({});
    renderer.change(small(algorithm));  // for the statistics
    CHECK(difference(whole.picture, renderer.render(0.25)) == "");
    CHECK(difference_of_counters(whole.statistics, renderer.statistics()) == "");
  }
}

/// Each node's ball holds its rays' origins and its cone their directions, and each level holds every ray once.
void check_nodes(const RenderOptions& options) {
  Renderer renderer(borrowed(device()), borrowed(own_scene("cornell")), options);
  std::vector<RayNode> nodes;
  RayTable rays;
  renderer.watch_nodes(&nodes);
  (void)renderer.render(0, {}, &rays);
  std::vector<uint32_t> row_of(rays.size());
  for (uint32_t row = 0; row < rays.size(); ++row) row_of[rays.sorted[row]] = row;
  REQUIRE(!nodes.empty());
  std::vector<uint32_t> times(rays.size());
  for (const RayNode& node : nodes)
    for (uint32_t place = node.first; place < node.end; ++place) {
      const uint32_t row = row_of[place];
      times[row] += node.level == 1;
      REQUIRE(rays.kind[row] == node.kind);
      REQUIRE(rays.bounce[row] == node.bounce);
      REQUIRE(glm::distance(rays.origin[row], node.centre) <= node.radius * 1.0001f + 1e-4f);
      REQUIRE(std::acos(glm::clamp(glm::dot(rays.direction[row], node.axis), -1.0f, 1.0f)) <= node.half_angle + 2e-3f);
    }
  for (const uint32_t count : times) REQUIRE(count == 1);
}

TEST_CASE("nodes off the device hold their rays, whatever the bound") {
  for (const std::string algorithm : {"crsh", "crsh-2017", "rah"}) {
    CAPTURE(algorithm);
    check_nodes(small(algorithm));
  }
  for (const std::string& bound : hierarchy::bound_names()) {
    CAPTURE(bound);
    RenderOptions options = small("crsh");
    options.algorithm.bound = bound;
    check_nodes(options);
  }
}

TEST_CASE("boxes of the object hierarchy lie in each other's, and brute force has none") {
  Renderer renderer(borrowed(device()), borrowed(own_scene("cornell")), small("bvh"));
  (void)renderer.render(0);
  const std::vector<ObjectBox> boxes = renderer.object_boxes(4);
  REQUIRE(boxes.size() > 4);
  const scene::Bounds bounds = own_scene("cornell").bounds(own_scene("cornell").pose(0, {}));
  for (const ObjectBox& box : boxes) {
    CHECK(box.depth <= 4);
    for (int axis = 0; axis < 3; ++axis) {
      CHECK(box.low[axis] <= box.high[axis]);
      CHECK(box.low[axis] >= bounds.low[axis] - 1e-3f);
      CHECK(box.high[axis] <= bounds.high[axis] + 1e-3f);
    }
  }
  renderer.change(small("brute"));
  CHECK(renderer.object_boxes(4).empty());
}

}  // namespace
}  // namespace crsh::test
