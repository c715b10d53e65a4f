// The project's scenes against their baselines, and all algorithms against each other, bit for bit. A line an image.

#include <doctest/doctest.h>

#include "images/baseline.h"
#include "support/render.h"

namespace crsh::test {
namespace {

struct ImageTest {
  const char* name;   ///< of its baseline
  const char* scene;  ///< below scenes/
  uint32_t width = 64, height = 48, bounces = 2;
  const char* camera = "";
  double seconds = 0;
  uint32_t brute_width = 12;  ///< of the picture that is small enough for `brute`, three quarters as high
};

RenderOptions options_of(const ImageTest& test) {
  RenderOptions options;
  options.width = test.width;
  options.height = test.height;
  options.bounces = test.bounces;
  options.camera = test.camera;
  return options;
}

void check_image(const ImageTest& test) {
  const scene::Scene& scene = own_scene(test.scene);
  RenderOptions options = options_of(test);
  const Rendered ours = render_with("crsh", scene, options, test.seconds);
  CHECK(difference_to_baseline(test.name, ours.picture) == "");
  CHECK(difference(ours, render_with("crsh-2017", scene, options, test.seconds)) == "");
  CHECK(difference(ours, render_with("rah", scene, options, test.seconds)) == "");
  options.width = test.brute_width;
  options.height = test.brute_width * 3 / 4;
  CHECK(difference(render_with("crsh", scene, options, test.seconds),
                   render_with("brute", scene, options, test.seconds)) == "");
}

// clang-format off
#define IMAGE(name, ...) \
  TEST_CASE(name " is as blessed, the same by every algorithm") { check_image({name, __VA_ARGS__}); }

IMAGE("cornell", "cornell", 128, 96, 4)
IMAGE("cornell-two-bounces", "cornell", 64, 48, 2)
IMAGE("cornell-no-bounces", "cornell", 64, 48, 0)
IMAGE("office", "office", 64, 48, 1, "", 0, 8)
IMAGE("colonnade", "colonnade", 64, 48, 1, "", 0, 8)
IMAGE("glass", "glass", 96, 72, 4)
IMAGE("moving-start", "moving", 64, 48, 1)
IMAGE("moving-later", "moving", 64, 48, 1, "", 1.3)
IMAGE("moving-rider", "moving", 64, 48, 1, "rider", 2.7)
IMAGE("walking-start", "walking", 64, 48, 1)
IMAGE("walking-later", "walking", 64, 48, 2, "", 1.7)
IMAGE("morphing-start", "morphing", 64, 48, 2)
IMAGE("morphing-later", "morphing", 64, 48, 1, "", 0.8)
// clang-format on

}  // namespace
}  // namespace crsh::test
