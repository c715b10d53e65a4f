// Shading against its definitions in double: order of pixels, direct light, gathering, film.

#include <doctest/doctest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <numeric>

#include "raster/raster.h"
#include "shading/direct.h"
#include "shading/film.h"
#include "shading/gather.h"
#include "shared/ray.h"
#include "small_scene.h"
#include "surfaces_by_hand.h"

namespace crsh {
namespace {

using test::Point;

std::vector<uint32_t> pixels_in_order(raster::ImageSize size, RayOrder order, uint32_t first, uint32_t count) {
  gpu::Recorder recorder(test::device());
  test::SmallScene small;
  small.material(test::matt(glm::vec3(1)));
  const scene::GpuScene gpu = small.on(recorder);
  raster::GBuffer gbuffer;
  const raster::CameraView view;
  raster::rasterise(recorder, {gpu, view, size}, gbuffer);
  test::HandMade made;
  surfaces::from_raster(recorder, {gbuffer, gpu, view, size, order, first, count}, made.surfaces, made.generation);
  std::vector<uint32_t> pixels;
  for (const glm::vec4& d : recorder.read<glm::vec4>(made.surfaces.diffuse, count))
    pixels.push_back(std::bit_cast<uint32_t>(d.w));
  return pixels;
}

std::vector<uint32_t> tiled(raster::ImageSize size) {
  std::vector<uint32_t> pixels;
  for (uint32_t row = 0; row < size.height; row += 8)
    for (uint32_t column = 0; column < size.width; column += 8)
      for (uint32_t y = row; y < std::min(row + 8, size.height); ++y)
        for (uint32_t x = column; x < std::min(column + 8, size.width); ++x) pixels.push_back(y * size.width + x);
  return pixels;
}

TEST_CASE("tiles of 8x8 take every pixel once, also where the size is no multiple of 8" *
          doctest::test_suite("subset")) {
  for (const raster::ImageSize size : {raster::ImageSize{16, 8}, {13, 9}, {5, 3}, {1, 17}, {24, 23}})
    CHECK(pixels_in_order(size, RayOrder::tiles, 0, size.width * size.height) == tiled(size));
}

TEST_CASE("scanlines are in image order, and a portion is a part of the whole") {
  std::vector<uint32_t> all(13 * 9);
  std::iota(all.begin(), all.end(), 0u);
  CHECK(pixels_in_order({13, 9}, RayOrder::scanline, 0, 117) == all);
  const std::vector<uint32_t> whole = tiled({13, 9});
  CHECK(pixels_in_order({13, 9}, RayOrder::tiles, 40, 50) ==
        std::vector<uint32_t>(whole.begin() + 40, whole.begin() + 90));
}

/// glTF's BRDF times cosine, specification appendix B, in double.
glm::dvec3 brdf(const Point& p, glm::dvec3 light) {
  const glm::dvec3 n = glm::normalize(glm::dvec3(p.normal)), v = -glm::normalize(glm::dvec3(p.incoming)),
                   h = glm::normalize(v + light);
  const double nl = glm::dot(n, light), nv = std::max(glm::dot(n, v), 1e-4), nh = glm::dot(n, h);
  if (nl <= 0) return glm::dvec3(0);
  const double rough = std::max(double(p.roughness), 0.045), a2 = std::pow(rough, 4);
  const double d = a2 / (M_PI * std::pow(nh * nh * (a2 - 1) + 1, 2));
  const double vis = 0.5 / (nl * std::sqrt(nv * nv * (1 - a2) + a2) + nv * std::sqrt(nl * nl * (1 - a2) + a2));
  const glm::dvec3 f = glm::dvec3(p.specular) + (1.0 - glm::dvec3(p.specular)) * std::pow(1 - glm::dot(v, h), 5);
  return ((1.0 - f) * glm::dvec3(p.diffuse) * (1 - double(p.transmission)) / M_PI + f * (d * vis)) * nl;
}

/// Two lights; every third surface has no ray to the second; hits tint, pass or block.
TEST_CASE("direct light is glTF's BRDF times inverse square times what the ray lets through" *
          doctest::test_suite("subset")) {
  test::Random random(21);
  std::vector<Point> points = test::random_points(random, 1000);
  for (Point& p : points) p.position = random.point(2), p.triangle = 1;
  const float endless = std::numeric_limits<float>::infinity();
  const std::vector<shared::Light> lights = {
      {glm::vec4(3, 4, 5, 0), glm::vec4(0, 0, -1, endless), glm::vec4(10, 20, 30, 0), glm::vec4(0, 1, 0, 0)},
      {glm::vec4(-3, 1, 4, 0), glm::vec4(0, 0, -1, 6), glm::vec4(40, 40, 40, 0), glm::vec4(0, 1, 0, 0)}};
  std::vector<uint32_t> ends;
  std::vector<shared::Hit> hits;
  for (uint32_t slot = 0; slot < 2000; ++slot) {
    if (slot < 1000 || slot % 3)
      hits.push_back(
          {slot % 5 == 0 ? glm::uvec4(0xFFFFFFFFu) : glm::uvec4(0, 65536, slot % 2 ? 0xFFFFFFFFu : 98304, 0)});
    ends.push_back(uint32_t(hits.size()));
  }
  gpu::Recorder recorder(test::device());
  test::HandMade made = test::upload_points(points);
  test::SmallScene small;
  small.material(test::matt(glm::vec3(1)));
  const scene::GpuScene gpu = small.on(recorder, {lights, {}});
  const gpu::Buffer gpu_ends = gpu::upload(test::device(), ends, "ends"),
                    gpu_hits = gpu::upload(test::device(), hits, "hits");
  shading::add_direct(recorder, {made.surfaces, gpu, {{{0, 0}, {0, 1}}, 0, 1000}, gpu_ends, gpu_hits}, made.generation);
  const auto direct = recorder.read<glm::vec4>(made.generation.direct, 1000);
  for (uint32_t i = 0; i < 1000; ++i) {
    glm::dvec3 sum(0);
    for (uint32_t l = 0; l < 2; ++l) {
      const uint32_t slot = l * 1000 + i;
      if ((l == 1 && slot % 3 == 0) || slot % 5 == 0) continue;
      const glm::dvec3 through(1, 0.5, slot % 2 ? 0 : std::exp2(-1.5));
      const glm::dvec3 way = glm::dvec3(lights[l].position) - glm::dvec3(points[i].position);
      const double squared = glm::dot(way, way), relative = l == 1 ? squared / 36 : 0;
      const double window = std::clamp(1 - relative * relative, 0.0, 1.0);
      sum += glm::dvec3(lights[l].colour) * through * (window / squared) * brdf(points[i], glm::normalize(way));
    }
    CHECK(glm::distance(glm::dvec3(direct[i]), sum) <= 2e-3 * glm::length(sum) + 1e-5);
  }
}

TEST_CASE("nothing degenerate makes light infinite or undefined") {
  std::vector<Point> points(4);
  points[0].position = {0, 0, 0};                            // at the light
  points[1].normal = points[1].geometric = {0, 0, 0};        // no normal
  points[2].incoming = {1, 0, 0};                            // grazing
  points[3].roughness = 0, points[3].position = {0, 0, -1};  // mirror right below the light
  const std::vector<shared::Light> lights = {
      {glm::vec4(0, 0, 0, 0), glm::vec4(0, 0, -1, INFINITY), glm::vec4(1e6f), glm::vec4(0, 1, 0, 0)}};
  gpu::Recorder recorder(test::device());
  test::HandMade made = test::upload_points(points);
  test::SmallScene small;
  small.material(test::matt(glm::vec3(1)));
  const scene::GpuScene gpu = small.on(recorder, {lights, {}});
  const gpu::Buffer ends = gpu::upload(test::device(), std::vector<uint32_t>{1, 2, 3, 4}, "ends");
  const gpu::Buffer hits = gpu::upload(test::device(), std::vector<shared::Hit>(4, shared::Hit{glm::uvec4(0)}), "hits");
  shading::add_direct(recorder, {made.surfaces, gpu, {{{0, 0}}, 0, 4}, ends, hits}, made.generation);
  for (const glm::vec4& d : recorder.read<glm::vec4>(made.generation.direct, 4)) CHECK(std::isfinite(d.r + d.g + d.b));
}

/// Parents 0..2; the batch's slots: reflection of each, then refraction of each. Rays in creation order after 5 others.
TEST_CASE("gathering follows slots to rays to children, by kind, and takes the background where nothing was met") {
  std::vector<Point> points(3);
  points[0].emission = {1, 0, 0};
  points[2].triangle = shared::none;
  gpu::Recorder recorder(test::device());
  test::HandMade made = test::upload_points(points);
  gpu::Device& device = test::device();
  const std::vector<glm::vec4> light = {glm::vec4(0.5f), glm::vec4(0.25f), glm::vec4(9)};
  gpu::upload_bytes(device, made.generation.direct, 0, light.data(), 48);
  made.generation.weights[shared::kind_reflection] =
      gpu::upload(device, std::vector<glm::vec4>(3, {0.5f, 0.5f, 0.5f, 0}), "weights");
  made.generation.weights[shared::kind_refraction] =
      gpu::upload(device, std::vector<glm::vec4>(3, {0.25f, 0.25f, 0.25f, 7.25f}), "weights");  // solid 7; .25 beside
  surfaces::Children children;
  children.ends = gpu::upload(device, std::vector<uint32_t>{5, 5, 5, 6, 7, 7, 7, 8, 8}, "ends");  // slots 0-2: shadow
  children.surfaces = 3;
  children.of_kind[shared::kind_reflection] = {3, 5, 2, 1};
  children.of_kind[shared::kind_refraction] = {6, 7, 1, 3};
  const gpu::Buffer totals =
      gpu::upload(device, std::vector<glm::vec4>{glm::vec4(100), glm::vec4(2), glm::vec4(4), {8, 8, 8, 0}}, "totals");
  children.totals = &totals;
  made.generation.children.push_back(std::move(children));
  shading::Gathered gathered;
  shading::gather(recorder, made.generation, {0.125f, 0, 0}, gathered, shading::Parts::wanted);
  const auto total = recorder.read<glm::vec4>(gathered.total, 3),
             reflected = recorder.read<glm::vec4>(gathered.brought[shared::kind_reflection], 3);
  CHECK(total[0] == glm::vec4(2.5f, 1.5f, 1.5f, 1));  // 1 emitted (red), 0.5 direct, half of child 1
  // 0.25 direct, half of child 2, a quarter of child 3, which met nothing where it passed beside
  CHECK(total[1] == glm::vec4(4.25f, 4.25f, 4.25f, 0.75f));
  CHECK(total[2] == glm::vec4(0.125f, 0, 0, 0));
  CHECK(glm::vec3(reflected[1]) == glm::vec3(2));
  CHECK(recorder.read<glm::vec4>(gathered.brought[shared::kind_refraction], 3)[1].r == 2);
}

TEST_CASE("in a batch the rays of two closest-hit kinds need not follow each other") {
  gpu::Recorder recorder(test::device());
  gpu::Device& device = test::device();
  test::HandMade made = test::upload_points(std::vector<Point>(2));
  for (const uint32_t kind : {shared::kind_reflection, shared::kind_refraction})
    made.generation.weights[kind] = gpu::upload(device, std::vector<glm::vec4>(2, glm::vec4(1)), "weights");
  const gpu::Buffer totals =
      gpu::upload(device, std::vector<glm::vec4>{glm::vec4(2), glm::vec4(3), glm::vec4(5)}, "totals");
  surfaces::Children children;
  children.ends =
      gpu::upload(device, std::vector<uint32_t>{1, 2, 3, 4, 4, 5}, "ends");  // slots 2 and 3: another kind's
  children.surfaces = 2;
  children.of_kind[shared::kind_reflection] = {0, 0, 2, 0};
  children.of_kind[shared::kind_refraction] = {4, 4, 1, 2};
  children.totals = &totals;
  made.generation.children.push_back(std::move(children));
  shading::Gathered gathered;
  shading::gather(recorder, made.generation, glm::vec3(0), gathered);
  const auto total = recorder.read<glm::vec4>(gathered.total, 2);
  CHECK(total[0].r == 2);
  CHECK(total[1].r == 8);
}

TEST_CASE("what rays of one any-hit kind saw is added to its pixels alone, wherever its segments lie") {
  gpu::Recorder recorder(test::device());
  gpu::Device& device = test::device();
  std::vector<Point> points(2);
  points[1].pixel = 1;
  const test::HandMade made = test::upload_points(points);
  test::SmallScene small;
  small.material(test::matt(glm::vec3(1)));
  const scene::GpuScene gpu = small.on(recorder);
  const rays::BatchPlan plan{{{shared::kind_reflection, 0}, {shared::kind_shadow, 0}, {shared::kind_shadow, 1}}, 0, 2};
  const gpu::Buffer ends = gpu::upload(device, std::vector<uint32_t>{1, 2, 3, 4, 4, 5}, "ends");
  std::vector<shared::Hit> found(5, shared::Hit{glm::uvec4(UINT32_MAX)});
  found[4].words = glm::uvec4(0);  // the second light, from the second surface
  const gpu::Buffer hits = gpu::upload(device, found, "hits");
  const gpu::Buffer pixels = gpu::upload(device, std::vector<glm::vec4>(2, glm::vec4(0)), "pixels");
  shading::add_visibility(recorder, {made.surfaces, gpu, plan, ends, hits}, shared::kind_shadow, pixels);
  const auto sums = recorder.read<glm::vec4>(pixels, 2);
  CHECK(glm::vec2(sums[0]) == glm::vec2(0, 1));
  CHECK(glm::vec2(sums[1]) == glm::vec2(1, 2));
}

TEST_CASE("kinds in batches of their own gather the same") {
  gpu::Recorder recorder(test::device());
  gpu::Device& device = test::device();
  test::HandMade made = test::upload_points(std::vector<Point>(2));
  made.generation.weights[shared::kind_reflection] =
      gpu::upload(device, std::vector<glm::vec4>(2, glm::vec4(1)), "weights");
  made.generation.weights[shared::kind_refraction] =
      gpu::upload(device, std::vector<glm::vec4>(2, glm::vec4(1)), "weights");
  const gpu::Buffer totals =
      gpu::upload(device, std::vector<glm::vec4>{glm::vec4(2), glm::vec4(3), glm::vec4(5)}, "totals");
  for (const uint32_t kind : {shared::kind_reflection, shared::kind_refraction}) {
    surfaces::Children children;
    children.ends = gpu::upload(
        device, kind == shared::kind_reflection ? std::vector<uint32_t>{1, 2} : std::vector<uint32_t>{0, 1}, "ends");
    children.surfaces = 2;
    children.of_kind[kind] = {0, 0, kind == shared::kind_reflection ? 2u : 1u,
                              kind == shared::kind_reflection ? 0u : 2u};
    children.totals = &totals;
    made.generation.children.push_back(std::move(children));
  }
  shading::Gathered gathered;
  shading::gather(recorder, made.generation, glm::vec3(0), gathered);
  const auto total = recorder.read<glm::vec4>(gathered.total, 2);
  CHECK(total[0].r == 2);
  CHECK(total[1].r == 8);
}

TEST_CASE("the film averages samples, keeps the first one's geometry, and knows coverage") {
  gpu::Recorder recorder(test::device());
  test::SmallScene small;
  small.material(test::matt(glm::vec3(1)));
  small.quad({-1, -1}, {1, 1}, 0);
  small.instance(0);
  const scene::GpuScene gpu = small.on(recorder);
  std::vector<Point> points(2);
  points[0].pixel = 1, points[0].position = {0, 0, -3}, points[0].specular = glm::vec3(0.04f);
  points[1].triangle = shared::none;
  for (const bool opaque : {true, false}) {
    shading::Film film;
    shading::begin_frame(recorder, film, {2, 1}, LayerSet::all());
    for (int sample = 0; sample < 2; ++sample) {
      if (sample == 1) points[0].triangle = shared::none;
      else points[0].triangle = 0;
      const test::HandMade made = test::upload_points(points);
      shading::Gathered gathered;
      gathered.total = gpu::upload(
          test::device(), std::vector<glm::vec4>{glm::vec4(2, 4, 6, sample ? 0 : 1), glm::vec4(1, 1, 1, 0)}, "totals");
      gathered.brought[shared::kind_reflection] =
          gpu::upload(test::device(), std::vector<glm::vec4>{glm::vec4(1), glm::vec4(0)}, "reflected");
      gathered.brought[shared::kind_refraction] =
          gpu::upload(test::device(), std::vector<glm::vec4>{glm::vec4(0), glm::vec4(0)}, "refracted");
      shading::begin_sample(film);
      shading::add_sample(recorder, {made.surfaces, made.generation, gathered, gpu, raster::CameraView{}}, film);
      recorder.submit();
    }
    const std::optional<glm::vec3> background = opaque ? std::optional(glm::vec3(1)) : std::nullopt;
    const Picture picture = shading::take_picture(recorder, film, raster::CameraView{}, glm::dvec3(0), background);
    CHECK(picture.find("")->values == std::vector<float>{1, 1, 1, opaque ? 1.0f : 0.0f, 2, 4, 6, opaque ? 1.0f : 0.5f});
    CHECK(picture.find("Z")->values == std::vector<float>{1e10f, 3});
    CHECK(picture.find("N")->values == std::vector<float>{0, 0, 0, 0, 0, 1});
    CHECK(picture.find("Albedo")->values[3] == doctest::Approx(0.25));
    CHECK(picture.find("Object")->ids == std::vector<uint32_t>{0, 1});
    CHECK(picture.find("Material")->ids == std::vector<uint32_t>{0, 1});
    CHECK(picture.find("Reflection")->values == std::vector<float>{0, 0, 0, 1, 1, 1});
    CHECK(picture.find("Background")->values ==
          (opaque ? std::vector<float>{1, 1, 1, 0.5f, 0.5f, 0.5f} : std::vector<float>(6, 0.0f)));
    CHECK(picture.find("F0")->values[3] == doctest::Approx(0.02));
    CHECK(picture.find("P")->values == std::vector<float>{0, 0, 0, 0, 0, -3});
  }
}

}  // namespace
}  // namespace crsh
