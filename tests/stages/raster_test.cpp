// The raster pass (section 3.1) against rays through pixels, and our texture sampler against its twin in double.

#include <doctest/doctest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <limits>
#include <optional>

#include "raster/raster.h"
#include "shared/limits.h"
#include "small_scene.h"
#include "support/cases.h"
#include "surfaces/surfaces.h"

namespace crsh {
namespace {

using test::SmallScene;

/// What surfaces_from_raster makes of a scene, in image order.
struct Seen {
  std::vector<glm::vec4> position, normal, geometric, incoming, diffuse, specular, emission;
  [[nodiscard]] uint32_t triangle(size_t i) const { return std::bit_cast<uint32_t>(position[i].w); }
};

Seen see(const SmallScene& small, const raster::CameraView& view, raster::ImageSize size, glm::vec2 jitter = {}) {
  gpu::Recorder recorder(test::device());
  const scene::GpuScene gpu = small.on(recorder);
  raster::GBuffer gbuffer;
  raster::rasterise(recorder, {gpu, view, size, jitter}, gbuffer);
  surfaces::Surfaces s;
  surfaces::Generation g;
  const uint32_t n = size.width * size.height;
  surfaces::from_raster(recorder, {gbuffer, gpu, view, size, RayOrder::scanline, 0, n}, s, g);
  const auto read = [&](const gpu::Buffer& buffer) { return recorder.read<glm::vec4>(buffer, n); };
  return {read(s.position), read(s.normal),   read(s.geometric), read(s.incoming),
          read(s.diffuse),  read(s.specular), read(g.emission)};
}

raster::CameraView front_view(bool orthographic, float half, raster::ImageSize size) {
  raster::CameraView view;
  view.eye = {0, 0, 5};
  view.orthographic = orthographic;
  view.half_height = half;
  view.half_width = half * float(size.width) / float(size.height);
  view.far_plane = 20;
  return view;
}

struct DoubleRay {
  glm::dvec3 origin, direction;
};

DoubleRay pixel_ray(const raster::CameraView& view, raster::ImageSize size, double x, double y) {
  const double across = (2 * x / size.width - 1) * view.half_width,
               above = (1 - 2 * y / size.height) * view.half_height;
  const glm::dvec3 side = glm::dvec3(view.right) * across + glm::dvec3(view.up) * above;
  if (view.orthographic) return {glm::dvec3(view.eye) + side, glm::dvec3(view.forward)};
  return {glm::dvec3(view.eye), glm::normalize(glm::dvec3(view.forward) + side)};
}

struct DoubleHit {
  uint32_t triangle = shared::none;
  double t = std::numeric_limits<double>::infinity();
};

DoubleHit nearest(const SmallScene& small, const DoubleRay& ray) {
  DoubleHit best;
  const scene::Mesh& mesh = small.scene.meshes[0];
  for (uint32_t i = 0; i < mesh.triangles.size(); ++i) {
    const glm::dvec3 a(mesh.positions[3 * i]), ab = glm::dvec3(mesh.positions[3 * i + 1]) - a,
                                               ac = glm::dvec3(mesh.positions[3 * i + 2]) - a;
    const glm::dvec3 p = glm::cross(ray.direction, ac), s = ray.origin - a, q = glm::cross(s, ab);
    const double determinant = glm::dot(ab, p);
    const double u = glm::dot(s, p) / determinant, v = glm::dot(ray.direction, q) / determinant,
                 t = glm::dot(ac, q) / determinant;
    const bool back = determinant < 0, passes = back && !small.scene.materials[mesh.materials[i]].double_sided;
    if (u >= 0 && v >= 0 && u + v <= 1 && t > 0 && t < best.t && !passes) best = {i, t};
  }
  return best;
}

/// The triangle that all rays a 50th of a pixel around this place meet; none where they disagree.
std::optional<DoubleHit> agreed(const SmallScene& small, const raster::CameraView& view, raster::ImageSize size,
                                double x, double y) {
  const DoubleHit middle = nearest(small, pixel_ray(view, size, x, y));
  for (int corner = 0; corner < 4; ++corner) {
    const double dx = corner % 2 ? 0.02 : -0.02, dy = corner / 2 ? 0.02 : -0.02;
    if (nearest(small, pixel_ray(view, size, x + dx, y + dy)).triangle != middle.triangle) return std::nullopt;
  }
  return middle;
}

void compare_with_rays(const SmallScene& small, const raster::CameraView& view, raster::ImageSize size,
                       glm::vec2 jitter) {
  const Seen seen = see(small, view, size, jitter);
  uint32_t compared = 0, met = 0;
  for (uint32_t i = 0; i < size.width * size.height; ++i) {
    const double x = i % size.width + 0.5 + jitter.x, y = i / size.width + 0.5 + jitter.y;
    const auto hit = agreed(small, view, size, x, y);
    if (!hit) continue;
    ++compared;
    CHECK(seen.triangle(i) == hit->triangle);
    if (hit->triangle == shared::none || seen.triangle(i) != hit->triangle) continue;
    ++met;
    const DoubleRay ray = pixel_ray(view, size, x, y);
    // A pixel's sample is placed to 1/256 of it; slopes make more of that.
    const double off = glm::length(glm::cross(glm::dvec3(seen.position[i]) - ray.origin, ray.direction));
    CHECK(off < 0.01 * 2 * view.half_height / size.height * (view.orthographic ? 1 : hit->t));
    CHECK(glm::dot(glm::vec3(seen.geometric[i]), glm::vec3(seen.incoming[i])) <= 0);
    CHECK(glm::distance(glm::dvec3(seen.incoming[i]), ray.direction) < 1e-3);
  }
  CHECK(compared > size.width * size.height / 2);
  CHECK(met > 100);
}

SmallScene clutter(bool double_sided) {
  test::Random random(7);
  SmallScene small;
  scene::Material material = test::matt(glm::vec3(0.5f));
  material.double_sided = double_sided;
  small.material(material);
  std::vector<glm::vec3> corners;
  for (int i = 0; i < 60; ++i) {
    const glm::vec3 middle = random.point(2.5f);
    for (int corner = 0; corner < 3; ++corner) corners.push_back(middle + random.point(1));
  }
  small.mesh(corners, 0);
  small.instance(0);
  return small;
}

TEST_CASE("each pixel shows the triangle that a ray through it meets first" * doctest::test_suite("subset")) {
  const raster::ImageSize size{61, 43};
  for (const bool orthographic : {false, true})
    for (const bool double_sided : {false, true})
      compare_with_rays(clutter(double_sided), front_view(orthographic, orthographic ? 3.0f : 0.6f, size), size,
                        {0, 0});
}

TEST_CASE("a sample off the pixel's centre shows what a ray through it meets") {
  const raster::ImageSize size{61, 43};
  compare_with_rays(clutter(true), front_view(false, 0.6f, size), size, {0.4f, -0.3f});
  compare_with_rays(clutter(true), front_view(true, 3.0f, size), size, {-0.45f, 0.2f});
}

TEST_CASE("a mirrored instance shows its front; single-sided backs let the eye through") {
  SmallScene small;
  small.material(test::matt(glm::vec3(1)));
  small.quad({-1, -1}, {1, 1}, 0);
  const raster::ImageSize size{4, 4};
  const raster::CameraView view = front_view(false, 0.1f, size);
  small.instance(0, glm::scale(glm::mat4(1), glm::vec3(-1, 1, 1)));
  CHECK(see(small, view, size).triangle(5) != shared::none);
  small.pose.instances[0] = glm::rotate(glm::mat4(1), float(M_PI), glm::vec3(0, 1, 0));
  CHECK(see(small, view, size).triangle(5) == shared::none);
  small.scene.materials[0].double_sided = true;
  const Seen back = see(small, view, size);
  CHECK(back.triangle(5) != shared::none);
  CHECK(back.normal[5].z > 0.99f);
}

TEST_CASE("an empty scene leaves every pixel empty") {
  SmallScene small;
  small.material(test::matt(glm::vec3(1)));
  const raster::ImageSize size{9, 7};
  const Seen seen = see(small, front_view(false, 1, size), size);
  for (size_t i = 0; i < 63; ++i) {
    CHECK(seen.triangle(i) == shared::none);
    CHECK(seen.emission[i].w == -1);
    CHECK(std::bit_cast<uint32_t>(seen.diffuse[i].w) == i);
  }
}

TEST_CASE(
    "materials: diffuse, F0, roughness, transmission and emission come from factors, textures and vertex colours") {
  SmallScene small;
  scene::Material material = test::matt(glm::vec3(0.8f, 0.4f, 0.2f));
  material.metallic = 0.5f;
  material.roughness = 0.6f;
  material.transmission = 0.25f;
  material.emissive = glm::vec3(3, 2, 1);
  small.scene.images = {{1, 1, {255, 128, 64, 255}}, {1, 1, {255, 255, 0, 255}}};
  small.scene.textures = {{0, {}, {}, true}, {1}};
  material.texture(scene::Slot::metallic_roughness).texture = 0;
  material.texture(scene::Slot::emissive).texture = 1;
  small.material(material);
  small.quad({-2, -2}, {2, 2}, 0);
  small.scene.meshes[0].colours.assign(6, scene::packed_colour({1, 0, 0, 1}));
  small.instance(0);
  const Seen seen = see(small, front_view(false, 0.1f, {2, 2}), {2, 2});
  const float metallic = 0.5f * 64 / 255, f0 = 0.04f * (1 - metallic);
  CHECK(glm::distance(glm::vec3(seen.diffuse[0]), glm::vec3(0.8f * (1 - metallic), 0, 0)) < 1e-5f);
  CHECK(glm::distance(glm::vec3(seen.specular[0]), glm::vec3(0.8f * metallic + f0, f0, f0)) < 1e-5f);
  CHECK(seen.geometric[0].w == doctest::Approx(0.6f * 128 / 255));
  CHECK(seen.normal[0].w == 0.25f);
  CHECK(glm::distance(glm::vec3(seen.emission[0]), glm::vec3(3, 2, 0)) < 1e-5f);
  CHECK(seen.emission[0].w == doctest::Approx(f0));
}

double decoded(uint8_t value) {
  const double c = value / 255.0;
  return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
}

int wrapped(long i, int size, scene::Wrap wrap) {
  const auto modulo = [](long a, long n) { return int(((a % n) + n) % n); };
  if (wrap == scene::Wrap::clamp) return int(std::clamp(i, 0l, long(size) - 1));
  if (wrap == scene::Wrap::repeat) return modulo(i, size);
  const int twice = modulo(i, 2 * size);
  return twice < size ? twice : 2 * size - 1 - twice;
}

double sampled(const scene::Image& image, const scene::Texture& texture, double u, double v) {
  const double x = u * image.width - (texture.nearest ? 0 : 0.5), y = v * image.height - (texture.nearest ? 0 : 0.5);
  double sum = 0;
  for (int corner = 0; corner < (texture.nearest ? 1 : 4); ++corner) {
    const long i = long(std::floor(x)) + corner % 2, j = long(std::floor(y)) + corner / 2;
    const double share_x = corner % 2 ? x - std::floor(x) : 1 - (x - std::floor(x));
    const double share_y = corner / 2 ? y - std::floor(y) : 1 - (y - std::floor(y));
    const size_t at = size_t(wrapped(j, int(image.height), texture.wrap_t)) * image.width +
                      size_t(wrapped(i, int(image.width), texture.wrap_s));
    sum += decoded(image.rgba[at * 4]) * (texture.nearest ? 1 : share_x * share_y);
  }
  return sum;
}

TEST_CASE("the texture sampler wraps, filters and decodes as its twin does") {
  test::Random random(9);
  scene::Image image{5, 3, {}};
  for (int i = 0; i < 60; ++i) image.rgba.push_back(uint8_t(random.below(256)));
  const raster::ImageSize size{37, 41};
  const raster::CameraView view = front_view(true, 2.3f, size);
  using scene::Wrap;
  for (const bool nearest : {false, true})
    for (const auto& [s, t] :
         {std::pair(Wrap::repeat, Wrap::mirror), {Wrap::mirror, Wrap::clamp}, {Wrap::clamp, Wrap::repeat}}) {
      SmallScene small;
      scene::Material material = test::matt(glm::vec3(1));
      material.texture(scene::Slot::base_colour) = {0u, 0};
      small.scene.images = {image};
      small.scene.textures = {{0, s, t, nearest}};
      small.material(material);
      small.quad({-3, -3}, {3, 3}, 0);
      small.instance(0);
      const Seen seen = see(small, view, size);
      for (size_t i = 0; i < seen.diffuse.size(); ++i) {
        const glm::vec4 at = seen.position[i];
        const double x = double(at.x) * image.width, y = double(at.y) * image.height;
        if (nearest && (std::abs(x - std::round(x)) < 1e-3 || std::abs(y - std::round(y)) < 1e-3)) continue;
        CHECK(seen.diffuse[i].r == doctest::Approx(sampled(image, small.scene.textures[0], at.x, at.y)).epsilon(2e-3));
      }
    }
}

}  // namespace
}  // namespace crsh
