// The final intersection (section 3.2.6): the hit test itself, its order-free sums, and brute force.

#include <doctest/doctest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <optional>
#include <vector>

#include "crsh/kinds.h"
#include "intersection/intersection.h"
#include "shared/counters.h"
#include "shared/limits.h"
#include "support/arithmetic.h"
#include "support/cases_trace.h"
#include "support/device.h"

using namespace crsh;
using namespace crsh::test;

namespace {

constexpr uint32_t rays_a_triangle = 1024;  // 16 KiB of hits: a binding may begin there

/// Rays at one triangle after another, all closest-hit; each triangle's rays are tested against it alone.
std::vector<shared::Ray> aimed_rays(Random& random, const Triangle& triangle) {
  std::vector<shared::Ray> rays = stray_rays(random, {triangle}, rays_a_triangle / 2, shared::kind_reflection);
  const auto more = mirror_rays(random, {triangle}, rays_a_triangle - rays.size(), shared::kind_refraction);
  rays.insert(rays.end(), more.begin(), more.end());
  return rays;
}

struct Trial {
  Triangle triangle;
  bool cull_back = false;
  std::vector<shared::Ray> rays;
  std::vector<glm::uvec4> hits;  ///< as the device found them
};

/// The device's word on every ray with its triangle: a dispatch a triangle.
std::vector<Trial> trials(uint32_t seed, uint32_t count) {
  Random random(seed);
  gpu::Recorder recorder(device());
  const std::vector<Triangle> all = hard_triangles(random, count);
  const auto middle = all.begin() + count / 2;
  const scene::GpuScene scene = make_scene(
      recorder, {{.triangles = {all.begin(), middle}}, {.triangles = {middle, all.end()}, .single_sided = true}});
  const std::vector<Triangle> triangles = world_triangles(recorder, scene);
  std::vector<Trial> trials;
  const gpu::Buffer counters(device(), 16, "counters");
  for (uint32_t i = 0; i < count; ++i) {
    Trial trial{triangles[i], i >= count / 2, aimed_rays(random, triangles[i]), {}};
    const gpu::Buffer rays = gpu::upload(device(), trial.rays, "rays");
    const gpu::Buffer hits = gpu::upload(
        device(), std::vector<glm::uvec4>(rays_a_triangle, {std::bit_cast<uint32_t>(INFINITY), shared::none, 0, 0}),
        "hits");
    const struct {
      uint32_t first_ray, ray_count, first_triangle, triangle_count, counter, first_account;
    } push{0, rays_a_triangle, i, 1, 0, 0};
    recorder.dispatch("intersection/brute", rays_a_triangle, push,
                      {scene.sheer_tables,
                       {"corner_a", scene.corner_a},
                       {"corner_b", scene.corner_b},
                       {"corner_c", scene.corner_c},
                       {"materials", scene.materials},
                       {"hits", hits},
                       {"rays", rays},
                       {"counters", counters},
                       {"account", counters}});
    trial.hits = recorder.read<glm::uvec4>(hits, rays_a_triangle);
    trials.push_back(std::move(trial));
  }
  return trials;
}

/// In double precision, where the case is clear: the triangle fat and seen well, nothing near an edge or an end.
std::optional<Meeting> clear_meeting(const shared::Ray& ray, const Triangle& triangle) {
  const glm::dvec3 origin(ray.origin), direction(ray.direction), a(triangle.a);
  const glm::dvec3 ab = glm::dvec3(triangle.b) - a, ac = glm::dvec3(triangle.c) - a, normal = glm::cross(ab, ac);
  const double area = glm::length(normal), size = std::max(glm::length(ab), glm::length(ac));
  const double reach = glm::distance(origin, a) + size, towards = glm::dot(direction, normal);
  if (area < 1e-2 * size * size || std::abs(towards) < 0.05 * area || size < 1e-2 * (reach + glm::length(a))) return {};
  const double t = glm::dot(a - origin, normal) / towards;
  const glm::dvec3 from_a = origin + direction * t - a;
  const double u = glm::dot(glm::cross(from_a, ac), normal) / (area * area);
  const double v = glm::dot(glm::cross(ab, from_a), normal) / (area * area);
  constexpr double margin = 1e-3;
  const bool near_edge = std::min({std::abs(u), std::abs(v), std::abs(1 - u - v)}) < margin;
  if (near_edge || std::abs(t) < margin * reach || std::abs(t - ray.origin.w) < margin * reach) return {};
  return Meeting{u > 0 && v > 0 && u + v < 1 && t > 0 && t < ray.origin.w, float(t)};
}

/// The closest hit or the sum of transmittances, as shaders/intersection/meet.glsl has them.
glm::uvec4 twin_hit(const shared::Ray& ray, const std::vector<Triangle>& triangles, uint32_t opaque,
                    const glm::uvec4& tint) {
  const bool shadow = ray_kinds[uint32_t(ray.direction.w)].any_hit;
  glm::uvec4 hit = shadow ? glm::uvec4(0) : glm::uvec4(std::bit_cast<uint32_t>(INFINITY), shared::none, 0, 0);
  for (uint32_t i = 0; i < triangles.size(); ++i) {
    const Meeting met = hit_triangle(ray, triangles[i], false);
    if (!met.hit) continue;
    if (shadow)
      for (int c = 0; c < 3; ++c)
        hit[c] = uint32_t(std::min<uint64_t>(uint64_t(hit[c]) + (i < opaque ? UINT32_MAX : tint[c]), UINT32_MAX));
    else if (met.t < std::bit_cast<float>(hit.x)) hit = {std::bit_cast<uint32_t>(met.t), i, 0, 0};
  }
  return hit;
}

}  // namespace

/// Where divisions are off by a unit or two in the last place, so are a ray's slopes and its distances: on slivers and
/// at grazing incidence that grows, and near an edge it decides. So some hits may differ, but few.
bool about_as_twin(bool hit, float t, const Meeting& twin) {
  return hit == twin.hit && (!hit || std::abs(t - twin.t) <= 1e-5f * twin.t);
}

TEST_CASE("the hit test agrees with its twin bit for bit, and finds hits on every kind of triangle") {
  uint32_t hits = 0, different = 0, far = 0;
  for (const Trial& trial : trials(1, 200))
    for (uint32_t i = 0; i < rays_a_triangle; ++i) {
      const Meeting twin = hit_triangle(trial.rays[i], trial.triangle, trial.cull_back);
      const bool hit = trial.hits[i].y != shared::none;
      hits += hit;
      different += hit != twin.hit || (hit && trial.hits[i].x != std::bit_cast<uint32_t>(twin.t));
      far += !about_as_twin(hit, std::bit_cast<float>(trial.hits[i].x), twin);
    }
  CHECK(hits > 20'000);
  if (arithmetic().is_ieee()) {
    CHECK(different == 0);
  } else {
    MESSAGE("compared to 1e-5 only, but for 1 in 50: ", arithmetic().text(), "; ", different, " differ, so far ", far);
    CHECK(far * 50 <= 200 * rays_a_triangle);
  }
}

TEST_CASE("the hit test is right wherever the case is clear") {
  uint32_t clear = 0, clear_hits = 0, wrong = 0;
  for (const Trial& trial : trials(2, 200))
    for (uint32_t i = 0; i < rays_a_triangle; ++i) {
      const std::optional<Meeting> exact = clear_meeting(trial.rays[i], trial.triangle);
      if (!exact || trial.cull_back) continue;
      const bool hit = trial.hits[i].y != shared::none;
      const float t = std::bit_cast<float>(trial.hits[i].x);
      ++clear;
      clear_hits += hit;
      wrong += hit != exact->hit || (hit && std::abs(t - exact->t) > 2e-5f * exact->t);
    }
  CHECK(wrong == 0);
  CHECK(clear > 5'000);
  CHECK(clear_hits > 2'000);
}

/// Triangles and transmittances are the same on every device; distances to the bit where its arithmetic is IEEE's.
bool is_as_expected(const glm::uvec4& hit, const glm::uvec4& expected, bool shadow) {
  if (shadow || arithmetic().is_ieee()) return hit == expected;
  const float t = std::bit_cast<float>(hit.x), wanted = std::bit_cast<float>(expected.x);
  return hit.y == expected.y && (t == wanted || std::abs(t - wanted) <= 1e-5f * wanted);
}

TEST_CASE("a closest hit goes to the lower triangle on a tie, and shadows add up whatever the order") {
  Random random(3);
  const std::vector<Triangle> opaque = {{{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}}, {{-1, -1, 0}, {1, -1, 0}, {0, 1, 0}}};
  const std::vector<Triangle> glass = {{{-2, -2, 1}, {2, -2, 1}, {0, 2, 1}}, {{-2, -2, 2}, {2, -2, 2}, {0, 2, 2}}};
  Tracer tracer(device());
  const scene::GpuScene scene =
      make_scene(tracer.recorder(), {{.triangles = opaque}, {.triangles = glass, .transmissive = true}});
  const std::vector<Triangle> triangles = world_triangles(tracer.recorder(), scene);
  const glm::uvec4 tint = tracer.recorder().read<shared::Material>(scene.materials, 2)[1].tint;
  REQUIRE(tint.x > 0);
  const SortedBatch rays =
      make_batch(device(), {light_rays(random, triangles, 500), stray_rays(random, triangles, 500, shared::kind_shadow),
                            stray_rays(random, triangles, 500, shared::kind_reflection)});
  const Traced all = tracer.trace_all(scene, rays);
  uint32_t different = 0, tinted = 0;
  if (!arithmetic().is_ieee()) MESSAGE("distances are compared to 1e-5 only: ", arithmetic().text());
  for (uint32_t i = 0; i < rays.batch.count; ++i) {
    const glm::uvec4 expected = twin_hit(rays.sorted_rays[i], triangles, uint32_t(opaque.size()), tint);
    different += !is_as_expected(all.hits[i], expected, i < 1000);
    tinted += i < 1000 && expected.x > 0 && expected.x < UINT32_MAX;
  }
  CHECK(different == 0);
  CHECK(tinted > 10);
}

TEST_CASE("a ray of each kind begins as its row says: all light comes through, or nothing is hit") {
  Random random(6);
  std::vector<std::vector<shared::Ray>> lists;
  for (uint32_t kind = 0; kind < kind_count; ++kind) lists.push_back(stray_rays(random, {Triangle{}}, 1, kind));
  const SortedBatch rays = make_batch(device(), lists);
  const gpu::Buffer hits = gpu::upload(device(), std::vector<glm::uvec4>(kind_count, glm::uvec4(7)), "hits");
  gpu::Recorder recorder(device());
  intersection::clear(recorder, rays.batch, hits);
  const std::vector<glm::uvec4> begun = recorder.read<glm::uvec4>(hits, kind_count);
  for (uint32_t kind = 0; kind < kind_count; ++kind) {
    CAPTURE(ray_kinds[kind].name);
    CHECK(begun[kind] == (ray_kinds[kind].any_hit ? glm::uvec4(0) : glm::uvec4(0x7F800000, shared::none, 0, 0)));
  }
}

TEST_CASE("brute force counts rays times triangles, also past 65,535 triangles and in small submits") {
  Tracer tracer(device());
  const scene::GpuScene scene = make_scene(tracer.recorder(), {{.triangles = wall(188)}});
  Random random(4);
  const SortedBatch rays =
      make_batch(device(), {mirror_rays(random, {{{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}}}, 50, shared::kind_reflection),
                            {},
                            stray_rays(random, {{{-1, -1, 0}, {1, -1, 0}, {1, 1, 0}}}, 7, shared::kind_refraction)});
  const Traced large = tracer.trace_all(scene, rays), small = tracer.trace_all(scene, rays, 1 << 16);
  for (const Traced* traced : {&large, &small}) {
    CHECK(traced->counter(shared::kind_reflection, shared::counter_triangle_tests) == 50ull * scene.triangle_count);
    CHECK(traced->counter(shared::kind_refraction, shared::counter_triangle_tests) == 7ull * scene.triangle_count);
  }
  CHECK(different_hits(large, small).empty());
}

TEST_CASE("a digest depends on what was hit, not on where in the batch the ray lies") {
  Random random(5);
  gpu::Recorder recorder(device());
  const scene::GpuScene scene = make_scene(recorder, {{.triangles = wall(2)}});
  const gpu::Buffer zeros = gpu::upload(device(), std::vector<glm::vec4>(64, glm::vec4(0)), "pixels and paths");
  const auto digest_of = [&](bool reversed, uint32_t changed) {
    std::vector<glm::uvec4> hits;
    std::vector<uint32_t> slots;
    for (uint32_t i = 0; i < 64; ++i) hits.push_back({i * 77 + changed * (i == 9), i % 5 ? i : shared::none, 0, 0});
    for (uint32_t i = 0; i < 64; ++i) slots.push_back(i);
    if (reversed) std::ranges::reverse(hits);
    SortedBatch rays = make_batch(device(), {stray_rays(random, {Triangle{}}, 64, shared::kind_reflection)});
    rays.batch.slots = gpu::upload(device(), slots, "slots");
    rays.batch.surfaces = 64;
    const gpu::Buffer hit_buffer = gpu::upload(device(), hits, "hits"), counters(device(), 64 * 8, "counters");
    recorder.fill(counters, 0, 128);
    intersection::digest(recorder, {scene, rays.batch, hit_buffer, counters}, rays.batch.segments[0], 0, zeros, zeros);
    return recorder.read<uint64_t>(counters, shared::counters_per_row);
  };
  const std::vector<uint64_t> plain = digest_of(false, 0);
  CHECK(plain[shared::counter_ray_hits] == 51);
  CHECK(plain[shared::counter_digest] != 0);
  CHECK(digest_of(true, 0) == plain);
  CHECK(digest_of(false, 1)[shared::counter_digest] != plain[shared::counter_digest]);
}
