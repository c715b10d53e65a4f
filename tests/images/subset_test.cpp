// What tools/test also runs with the validation layers and under the sanitisers: every pipeline, in little time.

#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "hierarchy/hierarchy.h"
#include "rays/hash.h"
#include "support/device.h"
#include "support/kinds.h"
#include "support/render.h"

namespace crsh::test {
namespace {

RenderOptions tiny(uint32_t bounces) {
  RenderOptions options;
  options.width = 12;
  options.height = 9;
  options.bounces = bounces;
  return options;
}

TEST_SUITE_BEGIN("subset");

TEST_CASE("every preset renders mirrors, glass and textures alike, without a validation message") {
  const scene::Scene& glass = own_scene("glass");
  const Rendered ours = render_with("crsh", glass, tiny(2));
  for (const std::string& name : preset_names()) {
    CAPTURE(name);
    CHECK(difference(ours, render_with(name, glass, tiny(2))) == "");
  }
  CHECK(rays_of(ours.statistics, "refraction", 1).count > 0);
  CHECK(device().validation_messages() == 0);
}

TEST_CASE("every key, with compression, and every way to build levels give the same, without a validation message") {
  const scene::Scene& glass = own_scene("glass");
  RenderOptions options = tiny(1);
  options.algorithm = preset("crsh");
  const Rendered ours = render(glass, options);
  for (const std::string& key : rays::key_names())
    for (const Fit fit : {Fit::merged, Fit::all}) {
      CAPTURE(key);
      options.algorithm.keys.fill(key);
      options.algorithm.compression = true;
      options.algorithm.fit = fit;
      options.algorithm.levels = in_turn<uint32_t>({3, 2, 1});
      CHECK(difference(ours, render(glass, options)) == "");
    }
  CHECK(device().validation_messages() == 0);
}

/// On both kinds of device: where lanes read lists together, and where each walks alone.
void check_bound(const std::string& algorithm, const std::string& bound, gpu::Device& alone, const Rendered& expected) {
  CAPTURE(algorithm);
  CAPTURE(bound);
  RenderOptions options = tiny(1);
  options.algorithm = preset(algorithm);
  options.algorithm.bound = bound;
  options.algorithm.nodes = NodeCut::fixed;
  CHECK(difference(expected, render(own_scene("glass"), options)) == "");
  options.algorithm.fit = Fit::merged;
  options.algorithm.keys = in_turn<std::string>({"creation", "hilbert", "creation"});
  CHECK(difference(expected, render(alone, own_scene("glass"), options)) == "");
}

TEST_CASE("every bound gives the same, and so do lanes that walk alone, without a validation message") {
  gpu::DeviceRequest request = device_request();
  request.no_shuffles = true;
  gpu::Device alone(request);
  const Rendered expected = render(own_scene("glass"), tiny(1));
  for (const std::string& bound : hierarchy::bound_names())
    for (const char* algorithm : {"crsh", "crsh-bvh"}) check_bound(algorithm, bound, alone, expected);
  RenderOptions brute = tiny(1);
  brute.algorithm = preset("brute");
  CHECK(difference(expected, render(alone, own_scene("glass"), brute)) == "");
  CHECK(alone.validation_messages() == 0);
  CHECK(device().validation_messages() == 0);
}

TEST_CASE("an animated scene renders from frame to frame without a validation message") {
  Renderer renderer(borrowed(device()), borrowed(own_scene("moving")), tiny(0));
  const Picture start = renderer.render(0);
  CHECK(difference(start, renderer.render(1)) != "");
  CHECK(device().validation_messages() == 0);
}

TEST_CASE("deforming scenes render from frame to frame without a validation message") {
  for (const char* name : {"walking", "morphing"}) {
    Renderer renderer(borrowed(device()), borrowed(own_scene(name)), tiny(0));
    const Picture start = renderer.render(0);
    CHECK(difference(start, renderer.render(0.6)) != "");
  }
  CHECK(device().validation_messages() == 0);
}

TEST_CASE("memory that must be shared out gives the same, without a validation message") {
  RenderOptions options = tiny(1);
  options.algorithm = preset("rah");
  const Rendered usual = render(own_scene("cornell"), options);
  gpu::DeviceRequest request = device_request();
  request.first_capacity = 1;
  gpu::Device device(request);
  options.submit_work = 1 << 16;
  CHECK(difference(usual, render(device, own_scene("cornell"), options)) == "");
  CHECK(device.validation_messages() == 0);
}

TEST_SUITE_END();

}  // namespace
}  // namespace crsh::test
