// The scene on the device: instances expanded, moved, and bounded (section 3.2.1); materials, textures and lights.

#include <doctest/doctest.h>

#include <bit>
#include <cmath>

#include "crsh/error.h"
#include "scene/device/device_materials.h"
#include "scene/device/texel_pages.h"
#include "scene/device/world_lights.h"
#include "shared/limits.h"
#include "small_scene.h"
#include "support/cases.h"

namespace crsh {
namespace {

using test::SmallScene;

glm::mat4 random_affine(test::Random& random, bool mirrored) {
  glm::mat4 m = glm::rotate(glm::mat4(1), random.uniform(-3, 3), random.unit());
  m = glm::scale(
      m, {random.uniform(0.2f, 5), random.uniform(0.2f, 5), random.uniform(0.2f, 5) * (mirrored ? -1.0f : 1.0f)});
  m[3] = glm::vec4(random.point(50), 1);
  return m;
}

/// Three meshes of 40 triangles, five instances, two of them mirrored.
SmallScene scattered(test::Random& random) {
  SmallScene small;
  const uint32_t material = small.material(test::matt(glm::vec3(0.5f)));
  for (uint32_t i = 0; i < 3; ++i) {
    std::vector<glm::vec3> corners;
    for (const test::Triangle& t : test::closed_mesh(1, random.point(1), 1))
      corners.insert(corners.end(), {t.a, t.b, t.c});
    corners.resize(120);
    small.mesh(corners, material);
  }
  for (const uint32_t mesh : {0u, 1u, 0u, 2u, 1u})
    small.instance(mesh, random_affine(random, small.scene.instances.size() % 2 == 1));
  return small;
}

glm::dvec3 moved(const glm::mat4& m, glm::vec3 p) { return glm::dvec3(glm::dmat4(m) * glm::dvec4(p, 1)); }

TEST_CASE("drawn triangles are the instances' triangles, and mirrored ones keep their front" *
          doctest::test_suite("subset")) {
  test::Random random(1);
  const SmallScene small = scattered(random);
  gpu::Recorder recorder(test::device());
  const scene::GpuScene gpu = small.on(recorder);
  REQUIRE(gpu.triangle_count == 200);
  const auto a = recorder.read<glm::vec4>(gpu.corner_a, 200), b = recorder.read<glm::vec4>(gpu.corner_b, 200),
             c = recorder.read<glm::vec4>(gpu.corner_c, 200);
  for (uint32_t i = 0; i < 200; ++i) {
    const uint32_t instance = i / 40;
    const scene::Mesh& mesh = small.scene.meshes[small.scene.instances[instance].mesh];
    const glm::mat4& m = small.pose.instances[instance];
    const bool mirrored = instance % 2 == 1;
    const glm::uvec3 corner = mesh.triangles[i % 40];
    CHECK(std::bit_cast<uint32_t>(b[i].w) == instance);
    CHECK(std::bit_cast<uint32_t>(c[i].w) == small.scene.instances[instance].mesh * 40 + i % 40);
    CHECK(glm::distance(glm::dvec3(a[i]), moved(m, mesh.positions[corner.x])) < 1e-4);
    CHECK(glm::distance(glm::dvec3(b[i]), moved(m, mesh.positions[mirrored ? corner.z : corner.y])) < 1e-4);
    CHECK(glm::distance(glm::dvec3(c[i]), moved(m, mesh.positions[mirrored ? corner.y : corner.z])) < 1e-4);
  }
}

TEST_CASE("an object's sphere holds all its triangles' spheres") {
  test::Random random(2);
  for (int round = 0; round < 20; ++round) {
    const SmallScene small = scattered(random);
    gpu::Recorder recorder(test::device());
    const scene::GpuScene gpu = small.on(recorder);
    const auto triangles = recorder.read<glm::vec4>(gpu.triangle_spheres, 200);
    const auto objects = recorder.read<glm::vec4>(gpu.object_spheres, 5);
    for (uint32_t i = 0; i < 200; ++i) {
      const glm::dvec4 inner(triangles[i]), outer(objects[i / 40]);
      CHECK(glm::distance(glm::dvec3(inner), glm::dvec3(outer)) + inner.w <= outer.w);
    }
  }
}

TEST_CASE("blocks hold up to 32 triangles of one instance, and all of them once") {
  test::Random random(3);
  const SmallScene small = scattered(random);
  gpu::Recorder recorder(test::device());
  const scene::GpuScene gpu = small.on(recorder);
  const auto blocks = recorder.read<glm::uvec4>(gpu.blocks, gpu.block_count);
  uint32_t next = 0;
  for (const glm::uvec4& block : blocks) {
    CHECK(block.y == next);
    CHECK(block.x == block.y / 40);
    CHECK(block.x == (block.y + block.z - 1) / 40);
    CHECK(block.z <= shared::block_triangles);
    next += block.z;
  }
  CHECK(next == 200);
}

TEST_CASE("a scene without triangles, textures and lights can be uploaded and bound") {
  SmallScene empty;
  empty.material(test::matt(glm::vec3(1)));
  gpu::Recorder recorder(test::device());
  const scene::GpuScene gpu = empty.on(recorder);
  CHECK(gpu.triangle_count == 0);
  CHECK(gpu.light_count == 0);
  CHECK(gpu.corner_a.bytes() > 0);
  CHECK(gpu.texels[3].bytes() > 0);
  CHECK(gpu.lights.bytes() > 0);
}

TEST_CASE("pages are cut to what a texel buffer holds, and more drawn triangles than that are refused by name") {
  gpu::DeviceRequest request;
  request.max_texels = 24;
  gpu::Device device(request);
  SmallScene small;
  scene::Material textured = test::matt(glm::vec3(1));
  textured.texture(scene::Slot::base_colour).texture = 0;
  small.scene.images.push_back({8, 8, std::vector<uint8_t>(8 * 8 * 4, 7)});
  small.scene.textures.push_back({.image = 0});
  const uint32_t quad = small.quad(glm::vec2(0), glm::vec2(1), small.material(textured));
  for (int i = 0; i < 12; ++i) small.instance(quad);
  const scene::GpuScene gpu = scene::upload(device, small.scene);
  REQUIRE(gpu.notes.size() == 1);
  CHECK(gpu.texels[0].bytes() == (16 + 4 + 1) * sizeof(uint32_t));  // of 4 x 4 and below
  small.instance(quad);
  CHECK_THROWS_WITH_AS((void)scene::upload(device, small.scene), doctest::Contains("26 drawn triangles"), UserError);
}

TEST_CASE("a light without intensity gets pi d2 over their number, and says so") {
  const scene::Bounds bounds{glm::vec3(-1), glm::vec3(3)};
  const std::vector<LightOption> options = {{glm::vec3(1, 5, 1), {}}, {glm::vec3(0), 7.0f}};
  const scene::LightRig rig = scene::resolve_lights({}, options, bounds, {});
  REQUIRE(rig.fixed.size() == 2);
  CHECK(rig.fixed[0].colour.r == doctest::Approx(M_PI * 16 / 2));
  CHECK(rig.fixed[1].colour.g == 7.0f);
  REQUIRE(rig.chosen.size() == 1);
  CHECK(rig.chosen[0].position == glm::dvec3(1, 5, 1));
  CHECK_FALSE(rig.chosen[0].past_backs);
  CHECK(rig.chosen[0].candela == rig.fixed[0].colour.r);
}

TEST_CASE("a scene without lights gets one beside the eye; a scene with lights keeps its own") {
  const scene::Bounds bounds{glm::vec3(-1), glm::vec3(1)};
  scene::Scene scene;
  const scene::LightRig rig = scene::resolve_lights(scene, {}, bounds, {glm::vec3(0, 0, 10)});
  REQUIRE(rig.fixed.size() == 1);
  CHECK(rig.fixed[0].position.x > 0);
  CHECK(rig.fixed[0].position.y > 0);
  CHECK(rig.chosen.at(0) == LightOption{scene.in_file(glm::vec3(rig.fixed[0].position)), rig.fixed[0].colour.r, true});
  scene.lights.emplace_back();
  CHECK(scene::resolve_lights(scene, {}, bounds, {}).fixed.empty());
}

TEST_CASE("lights follow their nodes, and a directional one's plane lies outside the scene") {
  scene::Scene scene;
  scene::Light sun, spot;
  sun.type = scene::LightType::directional;
  spot.type = scene::LightType::spot;
  spot.inner_cone = 0.2f;
  spot.outer_cone = 0.4f;
  scene.lights = {sun, spot};
  scene::Pose pose;
  pose.lights = {glm::rotate(glm::mat4(1), -float(M_PI) / 2, glm::vec3(1, 0, 0)),
                 glm::scale(glm::translate(glm::mat4(1), glm::vec3(1, 2, 3)), glm::vec3(4))};
  const scene::Bounds bounds{glm::vec3(-1, -2, -1), glm::vec3(1, 2, 1)};
  const auto lights = scene::world_lights(scene, pose, {}, bounds);
  CHECK(glm::distance(glm::vec3(lights[0].direction), glm::vec3(0, -1, 0)) < 1e-6f);
  CHECK(lights[0].position.y > 2);
  CHECK(glm::vec3(lights[1].position) == glm::vec3(1, 2, 3));
  CHECK(glm::vec3(lights[1].direction) == glm::vec3(0, 0, -1));
  const auto angular = [&](float angle) { return lights[1].cone.x * std::cos(angle) + lights[1].cone.y; };
  CHECK(angular(0.2f) == doctest::Approx(1));
  CHECK(angular(0.4f) == doctest::Approx(0).epsilon(1e-5));
}

TEST_CASE("tint: clear glass takes what Fresnel reflects, a missing colour blocks, opaque materials block all") {
  scene::Scene scene;
  scene::Material glass = test::matt(glm::vec3(1, 0.5f, 0));
  CHECK(scene::tint_of(scene, glass) == glm::uvec4(0xFFFFFFFFu, 0xFFFFFFFFu, 0xFFFFFFFFu, 0));
  glass.transmission = 1;
  const glm::uvec4 tint = scene::tint_of(scene, glass);
  CHECK(tint.r == uint32_t(std::lround(-std::log2(0.96) * 65536)));
  CHECK(tint.g == uint32_t(std::lround(-std::log2(0.48) * 65536)));
  CHECK(tint.b == 0xFFFFFFFFu);
  glass.metallic = 1;
  CHECK(scene::tint_of(scene, glass).r == 0xFFFFFFFFu);
}

TEST_CASE("tint takes the mean of the base colour's texture in linear light") {
  scene::Scene scene;
  scene.images.push_back({2, 1, {255, 255, 255, 255, 0, 188, 255, 255}});
  scene.textures.emplace_back();
  scene::Material glass = test::matt(glm::vec3(1));
  glass.transmission = 1;
  glass.texture(scene::Slot::base_colour).texture = 0;
  const glm::uvec4 tint = scene::tint_of(scene, glass);
  const double green = (1 + std::pow((188 / 255.0 + 0.055) / 1.055, 2.4)) / 2;
  CHECK(tint.r == uint32_t(std::lround(-std::log2(0.96 / 2) * 65536)));
  CHECK(tint.g == uint32_t(std::lround(-std::log2(0.96 * green) * 65536)));
}

TEST_CASE("flags: single-sided materials are culled from behind, but solids that bend are not; glass transmits") {
  scene::Scene scene;
  scene::Material plain, both, glass, solid;
  both.double_sided = true;
  glass.transmission = solid.transmission = 1;
  glass.metallic = solid.metallic = 0;
  solid.thickness = 0.1f;
  scene.materials = {plain, both, glass, solid};
  CHECK(scene::flagged_material(scene, 0) == (0 | shared::triangle_cull_back));
  CHECK(scene::flagged_material(scene, 1) == 1);
  CHECK(scene::flagged_material(scene, 2) == (2 | shared::triangle_cull_back | shared::triangle_transmissive));
  CHECK(scene::flagged_material(scene, 3) == (3 | shared::triangle_transmissive));
}

TEST_CASE("images are packed into pages, unused ones left out, and halved only where they must be") {
  const auto flat = [](uint32_t w, uint32_t h, uint8_t value) {
    return scene::Image{w, h, std::vector<uint8_t>(size_t(w) * h * 4, value)};
  };
  const std::vector<scene::Image> images = {flat(8, 8, 1), flat(4, 4, 2), flat(64, 64, 3), flat(8, 8, 4)};
  const std::vector<scene::Picture> some = {{0}, {1}, {3}}, all = {{0}, {1}, {2}, {3}};
  const scene::TexelPages roomy = scene::pack_texels(images, some, 100);
  CHECK(roomy.notes.empty());
  REQUIRE(roomy.placements.size() == 3);
  CHECK(roomy.placements[0][0].page != roomy.placements[2][0].page);
  CHECK(roomy.pages[roomy.placements[1][0].page][roomy.placements[1][0].first + 15] == 0x02020202u);
  const scene::TexelPages tight = scene::pack_texels(images, all, 100);
  CHECK(tight.notes.size() == 1);
  CHECK(tight.placements[2][0].width == 8);
  CHECK(tight.pages[tight.placements[2][0].page][tight.placements[2][0].first] == 0x03030303u);
}

TEST_CASE("a picture with mip levels has them behind it, each the mean in linear light of what it covers") {
  scene::Image image{3, 2, {}};
  for (const uint8_t grey : {0, 255, 255, 255, 0, 255}) image.rgba.insert(image.rgba.end(), {grey, grey, grey, grey});
  const std::vector<scene::Image> images = {image};
  const std::vector<scene::Picture> pictures = {{0, true, true}, {0, false, true}};
  const scene::TexelPages pages = scene::pack_texels(images, pictures, 100);
  for (size_t i = 0; i < 2; ++i) {
    const std::vector<scene::Placement>& levels = pages.placements[i];
    REQUIRE(levels.size() == 2);
    CHECK(levels[0].width == 3);
    CHECK(levels[1].width == 1);
    CHECK(levels[1].height == 1);
    CHECK(levels[1].first == levels[0].first + 6);
    const uint32_t mean = pages.pages[levels[1].page][levels[1].first];
    const uint32_t two_thirds_of_white = i == 0 ? 213 : 170;  // in sRGB, and linear
    CHECK((mean & 255) == two_thirds_of_white);
    CHECK((mean >> 24) == 170);  // alpha is linear in both
  }
}

}  // namespace
}  // namespace crsh
