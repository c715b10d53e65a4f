// The lobes of materials against closed forms of their extensions: what lamps make of one square, seen straight on or
// aslant.

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "images/built_scene.h"
#include "support/render.h"

namespace crsh::test {
namespace {

scene::Material dielectric(glm::vec3 colour, float roughness) {
  scene::Material material = matt(colour);
  material.roughness = roughness;
  return material;
}

/// A square of 2 m on z = 0 with tangents along x, the eye `degrees` off its normal.
struct View {
  double degrees = 0;
  glm::vec3 light{1, 2, 4};
  uint32_t bounces = 0;
};

scene::Scene square_of(const scene::Material& material) {
  Triangles triangles;
  triangles.add_quad({-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0});
  scene::Scene scene = built_scene(triangles, {material});
  scene.meshes[0].tangents.assign(4, glm::vec4(1, 0, 0, 1));
  return scene;
}

/// Light that comes from the middle.
glm::dvec3 seen(const scene::Scene& scene, const View& view) {
  const double angle = view.degrees * M_PI / 180;
  RenderOptions options;
  options.width = options.height = 1;
  options.bounces = view.bounces;
  options.view.eye = {3 * std::sin(angle), 0, 3 * std::cos(angle)};
  options.view.target = glm::vec3(0);
  options.view.up = {0, 1, 0};
  options.view.fov_degrees = 0.1f;
  options.lights = {{view.light, 21}};
  const std::vector<float> pixel = render(scene, options).picture.find("")->values;
  return {pixel[0], pixel[1], pixel[2]};
}

glm::dvec3 seen(const scene::Material& material, const View& view = {}) { return seen(square_of(material), view); }

void check_equal(glm::dvec3 a, glm::dvec3 b, double relative = 1e-4) {
  CAPTURE(a.r);
  CAPTURE(a.g);
  CAPTURE(a.b);
  CAPTURE(b.r);
  CAPTURE(b.g);
  CAPTURE(b.b);
  CHECK(glm::distance(a, b) <= relative * glm::length(b) + 1e-7);
}

/// A material with lobes that do nothing: its pictures come from the whole BSDF.
scene::Material with_lobes(scene::Material material) {
  material.dispersion = 1;
  return material;
}

TEST_CASE("lobes without effect leave the metallic-roughness BRDF" * doctest::test_suite("subset")) {
  for (const float roughness : {0.2f, 0.7f})
    for (const float metallic : {0.0f, 1.0f})
      for (const double degrees : {0.0, 60.0}) {
        scene::Material plain = dielectric({0.8f, 0.4f, 0.2f}, roughness);
        plain.metallic = metallic;
        check_equal(seen(with_lobes(plain), {degrees}), seen(plain, {degrees}));
      }
}

TEST_CASE("specular factor 0 leaves the diffuse part alone; its colour tints F0") {
  scene::Material material = dielectric(glm::vec3(0.5f), 0.6f);
  material.specular.factor = 0;
  const double cosine = 4 / std::sqrt(21.0);
  check_equal(seen(material), glm::dvec3(0.5 / M_PI * cosine));
  scene::Material black = dielectric(glm::vec3(0), 0.6f);
  const glm::dvec3 grey = seen(black, {0, {0, 0.02f, 4.5f}});
  black.specular.colour = {1, 0.5f, 0};
  const glm::dvec3 tinted = seen(black, {0, {0, 0.02f, 4.5f}});
  check_equal(tinted, grey * glm::dvec3(1, 0.5, 0), 1e-3);
}

TEST_CASE("a clear coat takes 0.04 straight on, and nearly all at grazing") {
  const auto left = [](double degrees) {
    scene::Material material = dielectric(glm::vec3(0), 1);
    material.emissive = glm::vec3(1);
    material.clearcoat.factor = 1;
    return seen(material, {degrees, {0, 0, -4}}).g;
  };
  for (const double degrees : {0.0, 45.0, 80.0})
    CHECK(left(degrees) == doctest::Approx(0.96 * (1 - std::pow(1 - std::cos(degrees * M_PI / 180), 5))).epsilon(1e-3));
}

TEST_CASE("a film of no thickness is none, and one of 400 nm colours what is reflected") {
  scene::Material plain = dielectric(glm::vec3(0), 0.5f);
  const View near_mirror{0, {0, 0.02f, 4.5f}};
  scene::Material film = plain;
  film.iridescence = {1, 1.3f, 0, 0};
  check_equal(seen(film, near_mirror), seen(plain, near_mirror), 2e-3);
  film.iridescence = {1, 1.8f, 400, 400};
  const glm::dvec3 coloured = seen(film, near_mirror);
  CHECK(std::max({coloured.r, coloured.g, coloured.b}) > 1.2 * std::min({coloured.r, coloured.g, coloured.b}));
}

TEST_CASE("anisotropy widens the highlight along the tangent alone") {
  scene::Material metal = dielectric(glm::vec3(1), 0.3f);
  metal.metallic = 1;
  const View along{0, {1.5f, 0, 4.3f}}, across{0, {0, 1.5f, 4.3f}};
  check_equal(seen(metal, along), seen(metal, across));
  metal.anisotropy.strength = 0.8f;
  CHECK(seen(metal, along).g > 2 * seen(metal, across).g);
}

TEST_CASE("unlit shows its base colour, whatever the light") {
  scene::Material material = dielectric({0.25f, 0.5f, 0.75f}, 0.1f);
  material.unlit = true;
  material.emissive = glm::vec3(7);
  for (const double degrees : {0.0, 70.0})
    CHECK(seen(material, {degrees, {0, 0, 3}, 2}) == glm::dvec3(0.25, 0.5, 0.75));
}

TEST_CASE("specular-glossiness is its metallic-roughness equivalent") {
  scene::Material plain = dielectric(glm::vec3(0.5f), 0.4f), glossy = plain;
  glossy.base_colour = glm::vec4(glm::vec3(0.5f / 0.96f), 1);
  glossy.specular_glossiness = {glm::vec3(0.04f), 0.6f};
  for (const double degrees : {0.0, 60.0}) check_equal(seen(glossy, {degrees}), seen(plain, {degrees}), 1e-3);
}

TEST_CASE("diffuse transmission shows a lamp behind, and takes that from the front") {
  scene::Material leaf = dielectric({0.5f, 0.5f, 0.5f}, 1);
  leaf.specular.factor = 0;
  leaf.diffuse_transmission = {0.25f, {0.2f, 0.8f, 0.4f}};
  const double cosine = 4 / std::sqrt(21.0);
  check_equal(seen(leaf, {0, {1, 2, -4}}), 0.25 * glm::dvec3(0.2, 0.8, 0.4) / M_PI * cosine);
  check_equal(seen(leaf), glm::dvec3(0.75 * 0.5 / M_PI * cosine));
}

/// Light that a white, rough surface under white sheen sends to the eye from all the half sphere.
double furnace(float roughness, double degrees) {
  scene::Material cloth = dielectric(glm::vec3(1), 1);
  cloth.specular.factor = 0;
  cloth.sheen = {glm::vec3(1), roughness};
  const scene::Scene scene = square_of(cloth);
  constexpr int rows = 6, columns = 10;
  double sum = 0;
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column) {
      const double height = (row + 0.5) / rows, around = (column + 0.5) / columns * M_PI;
      const double wide = std::sqrt(21 * (1 - height * height));
      sum += seen(scene, {degrees, {wide * std::cos(around), wide * std::sin(around), std::sqrt(21.0) * height}}).g;
    }
  return sum * 2 * M_PI / (rows * columns);
}

TEST_CASE("sheen over white neither makes nor loses more than a few hundredths of light") {
  for (const float roughness : {0.5f, 1.0f}) {
    CHECK(furnace(roughness, 20) <= 1.03);
    CHECK(furnace(roughness, 20) >= 0.75);
  }
}

/// A cube of 1 m behind whose faces nothing but a shining wall stands.
glm::dvec3 through_cube(const scene::Attenuation& attenuation) {
  Triangles triangles;
  const auto face = [&](float z, bool front, uint32_t material, float half) {
    if (front) triangles.add_quad({-half, -half, z}, {half, -half, z}, {half, half, z}, {-half, half, z}, material);
    else triangles.add_quad({-half, half, z}, {half, half, z}, {half, -half, z}, {-half, -half, z}, material);
  };
  face(0.5f, true, 0, 0.5f);
  face(-0.5f, false, 0, 0.5f);
  face(-1, true, 1, 2);
  scene::Material solid = dielectric(glm::vec3(1), 0), wall = dielectric(glm::vec3(0), 1);
  solid.double_sided = false;
  solid.transmission = 1;
  solid.thickness = 1;
  solid.attenuation = attenuation;
  wall.emissive = glm::vec3(1);
  wall.specular.factor = 0;
  return seen(built_scene(triangles, {solid, wall}), {0, {0, 40, 30}, 2});
}

TEST_CASE("a solid takes light by Beer's law") {
  const glm::dvec3 clear = through_cube({}), red = through_cube({{1, 0.01f, 0.25f}, 0.5f});
  check_equal(red, clear * glm::dvec3(1, 1e-4, 0.0625), 2e-3);
  CHECK(clear.r == doctest::Approx(0.96 * 0.96).epsilon(0.02));
}

constexpr std::array<uint8_t, 4> texel = {51, 102, 153, 204};

double linear(double coded) { return coded <= 0.04045 ? coded / 12.92 : std::pow((coded + 0.055) / 1.055, 2.4); }

/// What a texture of one texel must be the same as.
struct SlotCase {
  scene::Slot slot;
  void (*factor)(scene::Material& material);
};

const glm::vec3 decoded(float(linear(0.2)), float(linear(0.4)), float(linear(0.6)));

const std::vector<SlotCase> slot_cases = {
    {scene::Slot::specular, [](scene::Material& m) { m.specular.factor *= 0.8f; }},
    {scene::Slot::specular_colour, [](scene::Material& m) { m.specular.colour *= decoded; }},
    {scene::Slot::clearcoat, [](scene::Material& m) { m.clearcoat.factor *= 0.2f; }},
    {scene::Slot::clearcoat_roughness, [](scene::Material& m) { m.clearcoat.roughness *= 0.4f; }},
    {scene::Slot::sheen_colour, [](scene::Material& m) { m.sheen.colour *= decoded; }},
    {scene::Slot::sheen_roughness, [](scene::Material& m) { m.sheen.roughness *= 0.8f; }},
    {scene::Slot::iridescence, [](scene::Material& m) { m.iridescence.factor *= 0.2f; }},
    {scene::Slot::iridescence_thickness, [](scene::Material& m) { m.iridescence.max_thickness = 220; }},
    {scene::Slot::anisotropy,
     [](scene::Material& m) {
       m.anisotropy.strength *= 0.6f;
       m.anisotropy.rotation += std::atan2(-0.2f, -0.6f);
     }},
    {scene::Slot::diffuse_transmission, [](scene::Material& m) { m.diffuse_transmission.factor *= 0.8f; }},
    {scene::Slot::diffuse_transmission_colour, [](scene::Material& m) { m.diffuse_transmission.colour *= decoded; }},
    {scene::Slot::specular_glossiness,
     [](scene::Material& m) {
       m.specular_glossiness->specular *= decoded;
       m.specular_glossiness->glossiness *= 0.8f;
     }},
};

scene::Material with_everything() {
  scene::Material all = dielectric({0.6f, 0.5f, 0.4f}, 0.5f);
  all.specular = {0.9f, {0.9f, 0.8f, 0.7f}};
  all.clearcoat = {0.8f, 0.5f, 1};
  all.sheen = {{0.5f, 0.4f, 0.6f}, 0.7f};
  all.iridescence = {0.5f, 1.6f, 100, 400};
  all.anisotropy = {0.7f, 0.3f};
  all.diffuse_transmission = {0.5f, {0.3f, 0.9f, 0.5f}};
  return all;
}

TEST_CASE("every texture of a lobe is its factor times the right channels of its texel") {
  for (const SlotCase& slot : slot_cases) {
    CAPTURE(uint32_t(slot.slot));
    scene::Material plain = with_everything();
    if (slot.slot == scene::Slot::specular_glossiness) plain.specular_glossiness = {glm::vec3(0.5f), 0.6f};
    scene::Material textured = plain, scaled = plain;
    textured.texture(slot.slot).texture = 0;
    slot.factor(scaled);
    scene::Scene scene = square_of(textured);
    scene.images.push_back({1, 1, std::vector<uint8_t>(texel.begin(), texel.end())});
    scene.textures.push_back({});
    const View front{40, {-2.5f, 0.3f, 3.8f}}, back{40, {1, 2, -4}};
    check_equal(seen(scene, front), seen(scaled, front), 1e-3);
    check_equal(seen(scene, back), seen(scaled, back), 1e-3);
    const bool matters = seen(scaled, front) != seen(plain, front) || seen(scaled, back) != seen(plain, back);
    CHECK(matters);
  }
}

/// What an eye at (4, 0.3, 2.5) sees of the square, straight or, from the other side of x = 3, in a mirror that stands
/// there.
glm::dvec3 seen_at(const scene::Material& material, bool in_mirror) {
  Triangles triangles;
  triangles.add_quad({-1, -1, 0}, {1, -1, 0}, {1, 1, 0}, {-1, 1, 0});
  if (in_mirror) triangles.add_quad({3, -1, 1}, {3, -1, 3}, {3, 1, 3}, {3, 1, 1}, 1);
  scene::Material mirror = dielectric(glm::vec3(1), 0);
  mirror.metallic = 1;
  scene::Scene scene = built_scene(triangles, {material, mirror});
  scene.meshes[0].tangents.assign(scene.meshes[0].positions.size(), glm::vec4(1, 0, 0, 1));
  RenderOptions options;
  options.width = options.height = 1;
  options.bounces = in_mirror ? 2 : 1;
  options.view.eye = {in_mirror ? 2.0f : 4.0f, 0.3f, 2.5f};
  options.view.target = {in_mirror ? 6.0f : 0.0f, 0, 0};
  options.view.fov_degrees = 0.05f;
  options.lights = {{{-2, 1, 3}, 21}};
  const std::vector<float> pixel = render(scene, options).picture.find("")->values;
  return {pixel[0], pixel[1], pixel[2]};
}

TEST_CASE("a lobe looks the same straight and in a mirror") {
  const scene::Material all = with_everything(), none = dielectric({0.6f, 0.5f, 0.4f}, 0.5f);
  std::vector<scene::Material> materials(9, none);
  materials[0].specular = all.specular;
  materials[1].clearcoat = all.clearcoat;
  materials[2].sheen = all.sheen;
  materials[3].iridescence = all.iridescence;
  materials[4].anisotropy = all.anisotropy;
  materials[5].diffuse_transmission = all.diffuse_transmission;
  materials[6].specular_glossiness = scene::SpecularGlossiness{glm::vec3(0.3f, 0.2f, 0.1f), 0.5f};
  materials[7].unlit = true;
  materials[8] = all;
  for (size_t i = 0; i < materials.size(); ++i) {
    CAPTURE(i);
    CHECK(seen_at(materials[i], false).g > 0.01);
    check_equal(seen_at(materials[i], true), seen_at(materials[i], false), 2e-3);
  }
}

TEST_CASE("presets agree bit for bit where materials have lobes") {
  scene::Material paint = dielectric({0.6f, 0.1f, 0.1f}, 0.3f);
  paint.clearcoat = {1, 0, 1};
  paint.iridescence = {1, 1.5f, 100, 400};
  paint.sheen = {glm::vec3(0.3f), 0.4f};
  paint.anisotropy = {0.7f, 0.4f};
  const scene::Scene scene = square_of(paint);
  RenderOptions options;
  options.width = options.height = 16;
  options.view.eye = {1, 0.5f, 2};
  options.view.target = glm::vec3(0);
  options.lights = {{{1, 2, 4}, 21}};
  const Rendered first = render_with("brute", scene, options);
  for (const char* preset : {"bvh", "rah", "crsh-2017", "crsh", "crsh-bvh"})
    CHECK(difference(first.picture, render_with(preset, scene, options).picture) == "");
}

}  // namespace
}  // namespace crsh::test
