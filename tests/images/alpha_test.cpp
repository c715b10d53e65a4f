// alphaMode MASK and BLEND: what is cut away or half there is so for the eye, in shadows, in mirrors and behind glass,
// in every preset alike.

#include <doctest/doctest.h>

#include <string>
#include <utility>

#include "images/built_scene.h"
#include "support/device.h"
#include "support/render.h"

namespace crsh::test {
namespace {

/// 4x4 texels, nearest: the left half is not there, the right half is there to `alpha`.
scene::Scene with_half_texture(scene::Scene scene, uint8_t alpha) {
  scene::Image image{4, 4, std::vector<uint8_t>(64, 255)};
  for (size_t i = 0; i < 16; ++i) image.rgba[4 * i + 3] = i % 4 < 2 ? 0 : alpha;
  scene.images = {image};
  scene.textures = {{.image = 0, .nearest = true, .mips = scene::Mips::none}};
  return scene;
}

scene::Material leaf(scene::AlphaMode mode) {
  scene::Material material = matt({0.2f, 0.8f, 0.3f});
  material.alpha_mode = mode;
  material.texture(scene::Slot::base_colour).texture = 0;
  return material;
}

/// Two leaves before a wall, of materials 0 and 1, seen along -z; the wall is of material 2. Pane and mirror: 3 and 4.
scene::Scene leaves(bool pane_and_mirror) {
  Triangles all;
  all.add_quad({-1.2f, -0.5f, 1}, {-0.2f, -0.5f, 1}, {-0.2f, 0.5f, 1}, {-1.2f, 0.5f, 1}, 0);
  all.add_quad({0.2f, -0.5f, 1}, {1.2f, -0.5f, 1}, {1.2f, 0.5f, 1}, {0.2f, 0.5f, 1}, 1);
  all.add_quad({-4, -4, 0}, {4, -4, 0}, {4, 4, 0}, {-4, 4, 0}, 2);
  if (pane_and_mirror) {
    all.add_quad({-1, -1, 1.5f}, {1, -1, 1.5f}, {1, 1, 1.5f}, {-1, 1, 1.5f}, 3);
    all.add_quad({-2, -1, 3}, {2, -1, 3}, {2, -1, 0.2f}, {-2, -1, 0.2f}, 4);
  }
  scene::Material glass = matt(glm::vec3(0.9f, 0.7f, 0.8f)), mirror = matt(glm::vec3(0.9f));
  glass.transmission = 0.9f, glass.roughness = 0;
  mirror.metallic = 1, mirror.roughness = 0;
  scene::Scene scene = built_scene(
      all, {leaf(scene::AlphaMode::mask), leaf(scene::AlphaMode::blend), matt(glm::vec3(0.5f)), glass, mirror});
  for (size_t corner = 0; corner < 8; ++corner)
    scene.meshes[0].uv[0][corner] = {corner % 4 == 1 || corner % 4 == 2 ? 1 : 0, corner % 4 >= 2 ? 1 : 0};
  return with_half_texture(std::move(scene), 128);
}

RenderOptions seen_from_ahead(uint32_t bounces) {
  RenderOptions options;
  options.width = 48;
  options.height = 32;
  options.bounces = bounces;
  options.view.eye = glm::vec3(0, 0, 5);
  options.view.target = glm::vec3(0);
  options.lights = {{.position = glm::vec3(0.6f, 0.8f, 4), .candela = 40.0f}};
  return options;
}

const std::vector<float>& beauty(const Rendered& rendered) { return rendered.picture.find("")->values; }

TEST_SUITE_BEGIN("subset");

TEST_CASE("every preset sees the same leaves, through glass and in mirrors, on both kinds of device") {
  const scene::Scene scene = leaves(true);
  const Rendered expected = render_with("brute", scene, seen_from_ahead(3));
  CHECK(rays_of(expected.statistics, "shadow", 0).alpha_tests > 0);
  CHECK(rays_of(expected.statistics, "reflection", 0).alpha_tests > 0);
  CHECK(rays_of(expected.statistics, "refraction", 1).alpha_tests > 0);
  gpu::DeviceRequest request = device_request();
  request.no_shuffles = true;
  gpu::Device alone(request);
  for (const std::string& name : preset_names()) {
    CAPTURE(name);
    CHECK(difference(expected, render_with(name, scene, seen_from_ahead(3))) == "");
    RenderOptions options = seen_from_ahead(3);
    options.algorithm = preset(name);
    CHECK(difference(expected, render(alone, scene, options)) == "");
  }
  CHECK(device().validation_messages() == 0);
}

TEST_CASE("a leaf that is whole in its texture is drawn as one without alpha, and asks for none") {
  const scene::Scene half = leaves(false);
  scene::Scene whole = with_half_texture(half, 255), opaque = whole;
  for (size_t i = 0; i < 16; ++i) whole.images[0].rgba[4 * i + 3] = opaque.images[0].rgba[4 * i + 3] = 255;
  opaque.materials[0].alpha_mode = opaque.materials[1].alpha_mode = scene::AlphaMode::opaque;
  const Rendered is = render(whole, seen_from_ahead(1)), should = render(opaque, seen_from_ahead(1));
  CHECK(difference(is, should) == "");
  CHECK(difference_of_counters(is.statistics, should.statistics) == "");
  CHECK(rays_of(is.statistics, "shadow", 0).alpha_tests == 0);
  CHECK(beauty(is) != beauty(render(half, seen_from_ahead(1))));
}

TEST_SUITE_END();

}  // namespace
}  // namespace crsh::test
