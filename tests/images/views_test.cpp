// The three views that figures are quoted for (README of the shared scenes). The test suite "full", with
// CRSH_TEST_FULL=1, takes them in the sizes that figures are about.

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <cstdlib>
#include <string>

#include "crsh/kinds.h"
#include "shared/ray.h"
#include "support/render.h"

namespace crsh::test {
namespace {

struct View {
  const char* name;
  const char* scene;
  glm::vec3 eye, target;
  float fov;
  glm::vec3 light;
  uint64_t shadow_rays, mirror_rays;  ///< of k = 0 at 512x512, as counted by a prototype
};

// clang-format off
const View views[] = {
    {"office", "office/office_drafting_objects.glb",
     {5.7f, 1.9f, -7.6f}, {2.8f, 1.0f, -3.6f}, 60, {4.4f, 2.9f, -4.2f}, 245419, 262144},
    {"cornell", "cornell/cornell_six_mirrors_790.glb",
     {0, 0.1f, 0.95f}, {0, -0.1545f, -0.017f}, 65, {0.2f, 0.8f, 0.3f}, 235486, 262144},
    {"sponza", "sponza/sponza_whole.glb",
     {-12, 3, 0.5f}, {0, 3.5f, 0}, 65, {0, 11, 0}, 178678, 256988}};
// clang-format on

bool is_full() {
  const char* full = std::getenv("CRSH_TEST_FULL");
  return full && std::string(full) == "1";
}

RenderOptions options_of(const View& view, uint32_t size, uint32_t bounces) {
  RenderOptions options;
  options.width = options.height = size;
  options.bounces = bounces;
  options.override_mirror = bounces > 0;
  options.view.eye = view.eye;
  options.view.target = view.target;
  options.view.fov_degrees = view.fov;
  options.lights = {{view.light, std::nullopt}};
  return options;
}

/// Null, and a line that says so, where the shared scenes are not here.
const scene::Scene* scene_of(const View& view) {
  const scene::Scene* scene = shared_scene(view.scene);
  if (!scene) MESSAGE("skipped: ", view.scene, " is not here (CRSH_SHARED_SCENES, ../shared/scenes)");
  return scene;
}

void check_algorithms(const View& view, uint32_t size, uint32_t brute_size) {
  const scene::Scene* scene = scene_of(view);
  if (!scene) return;
  CAPTURE(std::string(view.name));
  const RenderOptions options = options_of(view, size, 2), tiny = options_of(view, brute_size, 2);
  const Rendered ours = render_with("crsh", *scene, options);
  CHECK(difference(ours, render_with("crsh-2017", *scene, options)) == "");
  CHECK(difference(ours, render_with("rah", *scene, options)) == "");
  CHECK(difference(ours, render_with("bvh", *scene, options)) == "");
  CHECK(difference(ours, render_with("crsh-bvh", *scene, options)) == "");
  CHECK(difference(render_with("crsh", *scene, tiny), render_with("brute", *scene, tiny)) == "");
}

TEST_CASE("on the three views all presets give the same picture and hits") {
  for (const View& view : views) check_algorithms(view, 40, 12);
}

/// Within the 0.5% that another driver's rasteriser may make.
void check_near(uint64_t count, uint64_t expected) {
  CHECK(double(count) == doctest::Approx(double(expected)).epsilon(0.005));
}

/// Only the rays of one kind at k = 0.
uint64_t count_of(const View& view, const scene::Scene& scene, uint32_t kind) {
  RenderOptions options = options_of(view, 512, kind == shared::kind_shadow ? 0 : 1);
  options.rays.fill(false);
  options.rays[kind] = true;
  return rays_of(render(scene, options).statistics, ray_kinds[kind].name, 0).count;
}

/// One ray at a time over a binned SAH build needs 0.090% and 0.140% of brute force: what ray nodes are held against is
/// no straw man.
TEST_CASE("on Sponza bvh needs 0.1% of brute force for shadow rays at most, and 0.155% for reflection rays") {
  const View& sponza = views[2];
  const scene::Scene* scene = scene_of(sponza);
  if (!scene) return;
  const Rendered rendered = render_with("bvh", *scene, options_of(sponza, 128, 1));
  const auto share = [&](const char* kind) {
    const RayStatistics& row = rays_of(rendered.statistics, kind, 0);
    CHECK(row.levels.empty());
    CHECK(row.total_tests() == row.box_tests + row.triangle_tests);
    return double(row.total_tests()) / double(row.count * row.triangles);
  };
  CHECK(share("shadow") <= 0.0010);
  CHECK(share("reflection") <= 0.00155);
}

struct Shares {
  double shadow, reflection;
};

/// All tests of k = 0 as a share of brute force.
Shares shares(const View& view, const scene::Scene& scene, const char* algorithm, uint32_t size = 512) {
  const Rendered rendered = render_with(algorithm, scene, options_of(view, size, 1));
  const auto share = [&](const char* kind) {
    const RayStatistics& row = rays_of(rendered.statistics, kind, 0);
    return double(row.total_tests()) / double(row.count * row.triangles);
  };
  return {share("shadow"), share("reflection")};
}

TEST_CASE(
    "on the three views crsh-bvh needs 18% of the tests of bvh for shadow rays at most, and 30% for reflection rays") {
  for (const View& view : views) {
    const scene::Scene* scene = scene_of(view);
    if (!scene) return;
    CAPTURE(std::string(view.name));
    const Shares ours = shares(view, *scene, "crsh-bvh"), single = shares(view, *scene, "bvh");
    CHECK(ours.shadow <= 0.18 * single.shadow);
    CHECK(ours.reflection <= 0.30 * single.reflection);
    if (std::string(view.name) != "sponza") continue;
    CHECK(ours.shadow <= 0.000125);
    CHECK(ours.reflection <= 0.00040);
  }
}

/// What the README says of the ray hierarchy by itself, both halves of it.
TEST_CASE(
    "on Office and Sponza crsh alone needs fewer tests than bvh for shadow rays at 512x512; more at 256x256, and "
    "more for mirror rays at either size") {
  for (const View* view : {&views[0], &views[2]}) {
    const scene::Scene* scene = scene_of(*view);
    if (!scene) return;
    CAPTURE(std::string(view->name));
    const Shares large = shares(*view, *scene, "crsh"), large_single = shares(*view, *scene, "bvh");
    const Shares small = shares(*view, *scene, "crsh", 256), small_single = shares(*view, *scene, "bvh", 256);
    CHECK(large.shadow < 0.7 * large_single.shadow);
    CHECK(small.shadow > 1.2 * small_single.shadow);
    CHECK(large.reflection > 5 * large_single.reflection);
    CHECK(small.reflection > 12 * small_single.reflection);
  }
}

TEST_CASE("on 790 triangles between six mirrors crsh alone needs fewer tests than bvh, of either kind") {
  const scene::Scene* scene = scene_of(views[1]);
  if (!scene) return;
  const Shares ours = shares(views[1], *scene, "crsh"), single = shares(views[1], *scene, "bvh");
  CHECK(ours.shadow < 0.1 * single.shadow);
  CHECK(ours.reflection < 0.25 * single.reflection);
}

/// Shadow rays, as the paper's Table 1 counts.
double papers_share(const View& view, const scene::Scene& scene, ConeTest cone_test) {
  RenderOptions options = options_of(view, 512, 0);
  options.algorithm = preset("crsh-2017");
  options.algorithm.cone_test = cone_test;
  const RayStatistics row = rays_of(render(scene, options).statistics, "shadow", 0);
  return double(row.paper_tests()) / double(row.count * row.triangles);
}

/// The paper's figure for its own Sponza is 2.38% (Table 1); ours are 2.21% with equation 9's sign, 2.51% as printed.
TEST_CASE(
    "crsh-2017 needs what the paper says on Sponza, 2.38%: a little less with equation 9's sign, a little more "
    "without") {
  const scene::Scene* scene = scene_of(views[2]);
  if (!scene) return;
  const double with_sign = papers_share(views[2], *scene, ConeTest::with_sign);
  const double as_printed = papers_share(views[2], *scene, ConeTest::as_printed);
  MESSAGE("crsh-2017 on Sponza: ", fmt::format("{:.3f}% signed, {:.3f}% printed", with_sign * 100, as_printed * 100));
  CHECK(with_sign == doctest::Approx(0.02212).epsilon(0.005));
  CHECK(as_printed == doctest::Approx(0.02512).epsilon(0.005));
}

TEST_SUITE_BEGIN("full");

TEST_CASE("on the three views at 256x256 all presets give the same picture and hits, at 48x48 so does brute" *
          doctest::skip(!is_full())) {
  for (const View& view : views) check_algorithms(view, 256, 48);
}

TEST_CASE("the three views cast as many rays as the prototype counted" * doctest::skip(!is_full())) {
  for (const View& view : views) {
    const scene::Scene* scene = scene_of(view);
    if (!scene) return;
    CAPTURE(std::string(view.name));
    check_near(count_of(view, *scene, shared::kind_shadow), view.shadow_rays);
    check_near(count_of(view, *scene, shared::kind_reflection), view.mirror_rays);
  }
}

TEST_SUITE_END();

}  // namespace
}  // namespace crsh::test
