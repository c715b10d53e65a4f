// More lights than one batch holds.

#include <doctest/doctest.h>

#include <cmath>

#include "images/boxes.h"
#include "support/render.h"

namespace crsh::test {
namespace {

BoxScene boxes_under(uint32_t first_light, uint32_t lights) {
  BoxScene scene{.boxes = {{{-2, -0.2, -2}, {2, 0, 2}}, {{-0.5, 0, -0.5}, {0.5, 1, 0.5}}},
                 .lights = {},
                 .eye = {1.9, 2.1, 2.7},
                 .target = {0, 0.3, 0},
                 .placement = {}};
  for (uint32_t i = first_light; i < first_light + lights; ++i)
    scene.lights.emplace_back(1.5 * std::cos(i * 2.4), 1.2 + 0.005 * i, 1.5 * std::sin(i * 2.4));
  return scene;
}

Rendered rendered_under(uint32_t first_light, uint32_t lights) {
  const BoxScene boxes = boxes_under(first_light, lights);
  return render(scene_of(boxes), options_of(boxes, 24));
}

TEST_CASE("300 lights, which take several batches, give the sum of what they give apart") {
  const Rendered all = rendered_under(0, 300);
  std::vector<float> sum(all.picture.find("")->values.size(), 0.0f);
  uint64_t rays = 0, hits = 0;
  for (uint32_t first = 0; first < 300; first += 50) {
    const Rendered part = rendered_under(first, 50);
    for (size_t i = 0; i < sum.size(); ++i) sum[i] += part.picture.find("")->values[i];
    rays += rays_of(part.statistics, "shadow", 0).count;
    hits += rays_of(part.statistics, "shadow", 0).hits;
  }
  CHECK(rays_of(all.statistics, "shadow", 0).count == rays);
  CHECK(rays_of(all.statistics, "shadow", 0).hits == hits);
  for (size_t i = 0; i < sum.size(); ++i)
    if (i % 4 != 3) CHECK(all.picture.find("")->values[i] == doctest::Approx(sum[i]).epsilon(1e-5));
}

TEST_CASE("300 lights give one picture by every algorithm") {
  const BoxScene boxes = boxes_under(0, 300);
  const scene::Scene scene = scene_of(boxes);
  const RenderOptions options = options_of(boxes, 24);
  const Rendered ours = render(scene, options);
  for (const std::string& name : preset_names()) {
    CAPTURE(name);
    CHECK(difference(ours, render_with(name, scene, options)) == "");
  }
}

}  // namespace
}  // namespace crsh::test
