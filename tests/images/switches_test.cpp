// No switch of an algorithm changes a hit or a pixel.

#include <doctest/doctest.h>

#include <functional>
#include <string>
#include <vector>

#include "rays/hash.h"
#include "support/kinds.h"
#include "support/render.h"

namespace crsh::test {
namespace {

using Change = std::function<void(AlgorithmOptions&)>;

/// Shadow, reflection and refraction rays.
RenderOptions small() {
  RenderOptions options;
  options.width = 24;
  options.height = 18;
  options.bounces = 2;
  return options;
}

Rendered changed(const Change& change) {
  RenderOptions options = small();
  options.algorithm = preset("crsh");
  change(options.algorithm);
  return render(own_scene("glass"), options);
}

const Rendered& usual() {
  static const Rendered rendered = render_with("crsh", own_scene("glass"), small());
  return rendered;
}

std::string difference_by(const Change& change) { return difference(usual(), changed(change)); }

TEST_CASE("mixed and separate batches give the same hits, counters and picture") {
  for (const std::string& algorithm : preset_names()) {
    CAPTURE(algorithm);
    const Rendered mixed = changed([&](auto& options) { options = preset(algorithm); });
    const Rendered apart = changed([&](auto& options) { options = preset(algorithm), options.mixed_batches = false; });
    CHECK(difference(mixed, apart) == "");
    CHECK(difference_of_counters(mixed.statistics, apart.statistics) == "");
  }
}

TEST_CASE("scanlines and tiles give the same hits and picture") {
  CHECK(difference_by([](auto& options) { options.ray_order = RayOrder::tiles; }) == "");
}

TEST_CASE("compression changes no hit, no pixel, and no counter but its own chunks") {
  for (const char* algorithm : {"crsh", "crsh-2017"}) {
    CAPTURE(std::string(algorithm));
    const auto with = [&](bool on) {
      return changed([=](auto& options) { options = preset(algorithm), options.compression = on; });
    };
    Rendered chunked = with(true), plain = with(false);
    CHECK(rays_of(chunked.statistics, "shadow", 0).chunks > 0);
    for (RayStatistics& row : chunked.statistics.rays) row.chunks = 0;
    CHECK(difference(chunked, plain) == "");
    CHECK(difference_of_counters(chunked.statistics, plain.statistics) == "");
  }
}

TEST_CASE("every sort key gives the same hits and picture") {
  for (const std::string& key : rays::key_names()) {
    CAPTURE(key);
    CHECK(difference_by([&](auto& options) { options.keys.fill(key), options.compression = true; }) == "");
  }
}

TEST_CASE("kinds sorted by different keys, or one not at all, give the same hits and picture") {
  const auto keys = in_turn<std::string>({"octahedral", "", "spherical"});
  CHECK(difference_by([&](auto& options) { options.keys = keys; }) == "");
  CHECK(difference_by([](auto& options) { options.keys = in_turn<std::string>({"", "hilbert", ""}); }) == "");
}

TEST_CASE("merged and fitted bounds give the same hits and picture") {
  CHECK(difference_by([](auto& options) { options.fit = Fit::merged; }) == "");
}

TEST_CASE("bounds with and without intervals, objects culled or not, give the same hits and picture") {
  CHECK(difference_by([](auto& options) { options.interval = false; }) == "");
  CHECK(difference_by([](auto& options) { options.mesh_culling = false; }) == "");
  CHECK(difference_by([](auto& options) { options.interval = options.mesh_culling = false; }) == "");
}

TEST_CASE(
    "cones tested with equation 9's sign and as it is printed give the same hits and picture, the latter by more "
    "tests") {
  const scene::Scene& scene = own_scene("glass");
  RenderOptions options;
  options.width = 32, options.height = 24, options.bounces = 1;
  options.algorithm = preset("crsh-2017");
  const Rendered with_sign = render(scene, options);
  options.algorithm.cone_test = ConeTest::as_printed;
  const Rendered as_printed = render(scene, options);
  CHECK(difference(with_sign, as_printed) == "");
  uint64_t signed_tests = 0, printed_tests = 0;
  for (const RayStatistics& row : with_sign.statistics.rays) {
    const uint64_t more = rays_of(as_printed.statistics, row.kind, row.bounce).paper_tests();
    CHECK(more >= row.paper_tests());
    signed_tests += row.paper_tests(), printed_tests += more;
  }
  CHECK(printed_tests > signed_tests);
}

TEST_CASE("a bound without cones has no cone test to choose") {
  const Rendered as_printed = changed([](auto& options) { options.cone_test = ConeTest::as_printed; });
  CHECK(difference(usual(), as_printed) == "");
  CHECK(difference_of_counters(usual().statistics, as_printed.statistics) == "");
}

TEST_CASE("every arity gives the same hits and picture") {
  for (const uint32_t arity : {2, 3, 8, 64}) {
    CAPTURE(arity);
    CHECK(difference_by([&](auto& options) { options.arity = arity; }) == "");
  }
}

TEST_CASE("every number of levels gives the same hits and picture") {
  for (const uint32_t levels : {1, 2, 3, 4}) {
    CAPTURE(levels);
    CHECK(difference_by([&](auto& options) { options.levels.fill(levels); }) == "");
    CHECK(difference_by([&](auto& options) { options.levels.fill(levels), options.fit = Fit::merged; }) == "");
  }
}

TEST_CASE("nodes through the object hierarchy give the same hits and picture, however they are made") {
  const auto difference_of = [](const Change& change) {
    return difference_by([&](auto& options) { options = preset("crsh-bvh"), options.least_rays = 0, change(options); });
  };
  for (const uint32_t levels : {1, 2}) CHECK(difference_of([&](auto& options) { options.levels.fill(levels); }) == "");
  for (const uint32_t arity : {2, 3, 20, 64}) CHECK(difference_of([&](auto& options) { options.arity = arity; }) == "");
  CHECK(difference_of([](auto& options) { options.nodes = NodeCut::fixed, options.keys.fill("creation"); }) == "");
  CHECK(difference_of([](auto& options) { options.interval = false, options.bound = "sphere-cone"; }) == "");
  CHECK(difference_of([](auto& options) { options.cut_angle = 0, options.compression = true; }) == "");
}

TEST_CASE("rays that are too scattered for nodes go one by one, kind by kind") {
  const scene::Scene& scene = own_scene("glass");
  RenderOptions options;
  options.width = 64, options.height = 48, options.bounces = 1;
  const auto rendered_with = [&](const AlgorithmOptions& algorithm) {
    options.algorithm = algorithm;
    return render(scene, options);
  };
  AlgorithmOptions never = preset("crsh-bvh"), always = never;
  never.least_rays = 0, always.least_rays = 64;
  const Rendered single = rendered_with(preset("bvh")), nodes = rendered_with(never), scattered = rendered_with(always);
  CHECK(difference(nodes, single) == "");
  CHECK(difference(scattered, single) == "");
  for (const char* kind : {"reflection", "refraction"}) {
    CAPTURE(std::string(kind));
    const RayStatistics &one = rays_of(single.statistics, kind, 0), &all = rays_of(scattered.statistics, kind, 0);
    CHECK(rays_of(nodes.statistics, kind, 0).levels.size() == 2);
    CHECK(all.levels.empty());
    CHECK(all.box_tests == one.box_tests);
    CHECK(all.triangle_tests == one.triangle_tests);
  }
  // Shadow rays share their origin: they are bundled.
  const RayStatistics &shadow = rays_of(scattered.statistics, "shadow", 0),
                      &same = rays_of(nodes.statistics, "shadow", 0);
  CHECK(shadow.levels.size() == 2);
  CHECK(shadow.total_tests() == same.total_tests());
}

TEST_CASE("kinds with different numbers of levels give the same hits and picture") {
  CHECK(difference_by([](auto& options) { options.levels = in_turn<uint32_t>({1, 3, 2}); }) == "");
  CHECK(difference_by([](auto& options) { options.levels = in_turn<uint32_t>({4, 1, 8}), options.arity = 2; }) == "");
}

}  // namespace
}  // namespace crsh::test
