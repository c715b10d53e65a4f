// Every ray of every preset is traced again by Embree, which shares nothing with this project.

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <numeric>
#include <string>
#include <tuple>

#include "oracle/judge.h"
#include "shared/ray.h"
#include "support/device.h"
#include "support/render.h"

namespace crsh::test {
namespace {

RenderOptions small(uint32_t side = 64) {
  RenderOptions options;
  options.width = options.height = side;
  options.bounces = 2;
  return options;
}

RenderOptions seen_from(RenderOptions options, glm::vec3 eye, glm::vec3 target, float fov, glm::vec3 light) {
  options.view.eye = eye, options.view.target = target, options.view.fov_degrees = fov;
  options.lights = {{light, {}}};
  return options;
}

/// The frame's rays, in an order that does not depend on the algorithm.
RayTable rays_of(const scene::Scene& scene, const RenderOptions& options) {
  RayTable rays;
  Renderer renderer(borrowed(device()), borrowed(scene), options);
  (void)renderer.render(0, {}, &rays);
  std::vector<uint32_t> rows(rays.size());
  std::iota(rows.begin(), rows.end(), 0u);
  const auto place = [&](uint32_t row) {
    return std::tuple(rays.bounce[row], rays.kind[row], rays.light[row], rays.path[row], rays.pixel[row]);
  };
  std::ranges::sort(rows, {}, place);
  return crsh::rows_of(rays, rows);
}

/// Rays and hits, bit for bit.
bool same_rays(const RayTable& a, const RayTable& b) {
  return a.origin == b.origin && a.direction == b.direction && a.tmax == b.tmax && a.pixel == b.pixel &&
         a.hit == b.hit && a.t == b.t && a.transmittance == b.transmittance;
}

void check_verdict(const Verdict& verdict) {
  CAPTURE(verdict.first_wrong);
  CAPTURE(verdict.rays);
  CAPTURE(verdict.disagreed);
  CHECK(verdict.rays > 0);
  CHECK(verdict.wrong == 0);
  CHECK(verdict.exceptions * 10000 <= verdict.rays);
}

bool is_full() {
  const char* full = std::getenv("CRSH_TEST_FULL");
  return full && std::string(full) == "1";
}

/// The default preset's rays are judged, those of all presets are the same without exception: without CRSH_TEST_FULL in
/// a smaller image, because brute force takes its time.
void check_scene(const scene::Scene& scene, RenderOptions options) {
  const std::vector<OracleTriangle> triangles = oracle_triangles(scene);
  CHECK(difference_from_scene(triangles, scene) == "");
  options.algorithm.least_rays = 0;  // nodes of all rays, also where they are as scattered as in small pictures
  RayTable rays = rays_of(scene, options);
  check_verdict(judged(rays, triangles));
  if (!is_full()) {
    options.width = options.height = scene.triangle_count() > 20000 ? 8 : 20;
    rays = rays_of(scene, options);
    check_verdict(judged(rays, triangles));
  }
  for (const std::string& name : preset_names()) {
    CAPTURE(name);
    options.algorithm = preset(name);
    CHECK(same_rays(rays, rays_of(scene, options)));
  }
}

TEST_CASE("Embree agrees on every ray of the project's scenes, and all presets agree with each other") {
  for (const char* name : {"cornell", "glass", "moving", "walking", "morphing", "office", "colonnade"}) {
    CAPTURE(std::string(name));
    check_scene(own_scene(name), small());
  }
}

struct View {
  std::string path;  ///< below the shared scenes
  RenderOptions options;
};

RenderOptions mirrored(RenderOptions options) {
  options.override_mirror = true;
  return options;
}

/// The views that figures are quoted for, with mirrors all over, and what else there is of real data.
std::vector<View> shared_views() {
  return {{"office/office_drafting_objects.glb",
           mirrored(seen_from(small(), {5.7f, 1.9f, -7.6f}, {2.8f, 1, -3.6f}, 60, {4.4f, 2.9f, -4.2f}))},
          {"cornell/cornell_six_mirrors_790.glb",
           mirrored(seen_from(small(), {0, 0.1f, 0.95f}, {0, -0.1545f, -0.017f}, 65, {0.2f, 0.8f, 0.3f}))},
          {"sponza/sponza_whole.glb", mirrored(seen_from(small(), {-12, 3, 0.5f}, {0, 3.5f, 0}, 65, {0, 11, 0}))},
          {"office/office_drafting_instanced.glb", small()},
          {"cornell/cornell_original.glb", small()},
          {"cornell/cornell_mirror_blocks.glb", small()},
          {"models/bunny_69k.glb", small()},
          {"models/dragon_res3.glb", small()},
          {"models/spot.glb", small()},
          {"models/suzanne.glb", small()},
          {"models/teapot.glb", small()},
          {"samples/FlightHelmet/FlightHelmet.gltf", small()},
          {"samples/balloon/scene.gltf", small()},
          {"samples/roughness_scale/scene.gltf", small()},
          {"samples/smallpine/scene.gltf", small()}};
}

TEST_CASE("Embree agrees on every ray of the shared scenes, and all presets agree with each other") {
  for (const View& view : shared_views()) {
    const scene::Scene* scene = shared_scene(view.path);
    if (!scene) {
      MESSAGE("skipped: no shared scenes");
      return;
    }
    CAPTURE(view.path);
    check_scene(*scene, view.options);
  }
}

/// A ray that begins beside the middle of a strip, 11 m long and 15 mm wide, and meets it at `t`.
Verdict verdict_on_strip(float t) {
  const std::vector<OracleTriangle> strip = {{{0.00724005699f, 5.72931147f, 2.50748849f},
                                              {0.00724005699f, 5.72331095f, 2.52148843f},
                                              {-10.9127598f, 5.72331095f, 2.52148795f}}};
  RayTable rays;
  rays.origin = {{-7.69004f, 5.7218595f, 2.521371f}};
  rays.direction = {{0.78596246f, 0.49635667f, -0.3686367f}};
  rays.tmax = {INFINITY};
  rays.kind = {shared::kind_reflection};
  rays.hit = {0};
  rays.t = {t};
  rays.bounce = {0};
  rays.transmittance.resize(1);
  return judged(rays, strip);
}

TEST_CASE("how far along a ray a thin strip is, is known as well as float32 knows the strip's corners") {
  CHECK(verdict_on_strip(0.0044383166f).disagreed == 0);  // in double precision
  CHECK(verdict_on_strip(0.004583468f).wrong == 0);       // as a GPU found it
  CHECK(verdict_on_strip(0.0058f).wrong == 1);
}

/// What the oracle finds while a fault is at work.
uint64_t wrong_under(const std::string& mutation, const std::string& algorithm, const scene::Scene& scene,
                     RenderOptions options) {
  options.algorithm = preset(algorithm);
  options.algorithm.least_rays = 0;
  options.mutation = mutation;
  return judged(rays_of(scene, options), oracle_triangles(scene)).wrong;
}

TEST_CASE("the oracle turns red when cones are too narrow") {
  CHECK(wrong_under("narrow-cones", "rah", own_scene("glass"), small()) > 0);
}

TEST_CASE("the oracle turns red when pairs are dropped") {
  // Few pairs matter, and which are dropped depends on the last bits of bounds: many are needed for one in 10,000 to be
  // among them.
  RenderOptions options = mirrored(small());
  options.width = 160, options.height = 120;
  for (const std::string algorithm : {"rah", "crsh-bvh"}) {
    CAPTURE(algorithm);
    uint64_t wrong = 0;
    for (const char* scene : {"cornell", "glass", "moving"})
      wrong += wrong_under("dropped-pairs", algorithm, own_scene(scene), options);
    CHECK(wrong > 0);
  }
}

}  // namespace
}  // namespace crsh::test
