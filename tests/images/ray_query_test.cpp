// The device's own ray queries: near the others' picture where it has them, one line that says so where it has not.

#include <doctest/doctest.h>

#include <cmath>

#include "crsh/error.h"
#include "support/device.h"
#include "support/render.h"

namespace crsh::test {
namespace {

RenderOptions small() {
  RenderOptions options;
  options.width = 40;
  options.height = 30;
  options.bounces = 2;
  options.algorithm = preset(ray_query_preset);
  return options;
}

/// The share of values of the beauty that differ by more than a hundredth.
double share_of_differences(const Picture& a, const Picture& b) {
  const std::vector<float>&one = a.find("")->values, &other = b.find("")->values;
  size_t different = 0;
  for (size_t i = 0; i < one.size(); ++i)
    different += std::abs(one[i] - other[i]) > 0.01f * std::max({std::abs(one[i]), std::abs(other[i]), 0.01f});
  return double(different) / double(one.size());
}

TEST_CASE("a device without ray queries says so in one line") {
  gpu::DeviceRequest request = device_request();
  request.no_ray_queries = true;
  gpu::Device without(request);
  CHECK_THROWS_WITH_AS((void)render(without, own_scene("cornell"), small()), doctest::Contains("VK_KHR_ray_query"),
                       UserError);
}

TEST_CASE("ray queries give nearly the same picture as brute force, also of what moves, tints or has one side") {
  if (!device().info().ray_queries) {
    MESSAGE("skipped: ", device().info().name, " has no ray queries");
    return;
  }
  for (const char* name : {"cornell", "glass", "moving", "walking", "morphing"})
    for (const double seconds : {0.0, 1.1}) {
      CAPTURE(name);
      CAPTURE(seconds);
      const Rendered queried = render(own_scene(name), small(), seconds);
      CHECK(share_of_differences(queried.picture, render_with("brute", own_scene(name), small(), seconds).picture) <
            0.02);
      CHECK(queried.statistics.object_hierarchy.builds == 1);
    }
  CHECK(device().validation_messages() == 0);
}

}  // namespace
}  // namespace crsh::test
