// The same options give the same bytes, and other options others.

#include <doctest/doctest.h>

#include <string>
#include <vector>

#include "images/built_scene.h"
#include "output/exr.h"
#include "output/whole_file.h"
#include "support/device.h"
#include "support/render.h"
#include "support/temporary_folder.h"

namespace crsh::test {
namespace {

const std::vector<std::string> layers = {"", "Z", "N", "Albedo"};

RenderOptions small() {
  RenderOptions options;
  options.width = 40;
  options.height = 30;
  options.bounces = 2;
  return options;
}

std::string exr_of(const Picture& picture) {
  return output::encode_exr(picture, layers, {{"crsh:bounces", "2"}}).bytes;
}

TEST_CASE("two renderings in one process give the same bytes, under two names, and the same counters") {
  const TemporaryFolder folder;
  const Rendered first = render(own_scene("glass"), small()), second = render(own_scene("glass"), small());
  output::write_exr(folder / "first.exr", first.picture, layers, {});
  output::write_exr(folder / "second, another name.exr", second.picture, layers, {});
  CHECK(output::read_whole(folder / "first.exr") == output::read_whole(folder / "second, another name.exr"));
  CHECK(difference_of_counters(first.statistics, second.statistics) == "");
}

TEST_CASE("two devices give the same bytes and counters") {
  gpu::Device other(device_request());
  const Rendered first = render(own_scene("glass"), small()), second = render(other, own_scene("glass"), small());
  CHECK(exr_of(first.picture) == exr_of(second.picture));
  CHECK(difference_of_counters(first.statistics, second.statistics) == "");
  CHECK(other.validation_messages() == 0);
}

TEST_CASE("a renderer's second frame is as its first, and counts as much again") {
  RenderOptions options = small();
  Renderer renderer(borrowed(device()), borrowed(own_scene("cornell")), options);
  const Picture first = renderer.render(0);
  const RayStatistics once = rays_of(renderer.statistics(), "shadow", 1);
  CHECK(difference(first, renderer.render(0)) == "");
  const RayStatistics twice = rays_of(renderer.statistics(), "shadow", 1);
  CHECK(twice.count == 2 * once.count);
  CHECK(twice.hits_digest == 2 * once.hits_digest);
  CHECK(twice.total_tests() == 2 * once.total_tests());
}

RenderOptions sampled(uint32_t seed) {
  RenderOptions options = small();
  options.bounces = 1;
  options.samples = 4;
  options.seed = seed;
  return options;
}

TEST_CASE("equal seeds give equal samples, other seeds others") {
  const Rendered seven = render(own_scene("cornell"), sampled(7));
  CHECK(difference(seven, render(own_scene("cornell"), sampled(7))) == "");
  CHECK(difference(seven.picture, render(own_scene("cornell"), sampled(8)).picture) != "");
}

TEST_CASE("samples are anti-aliased alike by every algorithm") {
  const Rendered ours = render(own_scene("cornell"), sampled(3));
  CHECK(difference(ours, render_with("crsh-2017", own_scene("cornell"), sampled(3))) == "");
  CHECK(difference(ours, render_with("rah", own_scene("cornell"), sampled(3))) == "");
}

/// What the first sample of a pixel sees is at its centre, however many there are.
TEST_CASE("depth and normals are those of the pixel's centre for any number of samples") {
  const Picture one = render(own_scene("cornell"), small()).picture,
                four = render(own_scene("cornell"), sampled(0)).picture;
  CHECK(one.find("Z")->values == four.find("Z")->values);
  CHECK(one.find("N")->values == four.find("N")->values);
}

TEST_CASE("times of an animation give different pictures, each the same again") {
  RenderOptions options = small();
  options.bounces = 0;
  const scene::Scene& moving = own_scene("moving");
  const Rendered start = render(moving, options, 0), later = render(moving, options, 1.1);
  CHECK(difference(start.picture, later.picture) != "");
  CHECK(difference(later, render(moving, options, 1.1)) == "");
}

TEST_CASE("a frame does not depend on the frames before it") {
  RenderOptions options = small();
  options.bounces = 0;
  Renderer renderer(borrowed(device()), borrowed(own_scene("moving")), options);
  (void)renderer.render(0.4);
  CHECK(difference(renderer.render(1.1), render(own_scene("moving"), options, 1.1).picture) == "");
}

/// Frames of one renderer, which refits, against those of a new one each, which builds.
void check_frames(const std::string& scene, const std::string& algorithm) {
  RenderOptions options = small();
  options.bounces = 1;
  options.algorithm = preset(algorithm);
  Renderer renderer(borrowed(device()), borrowed(own_scene(scene)), options);
  for (const double seconds : {0.0, 0.3, 0.9, 1.0, 3.1, 0.3}) {
    CAPTURE(scene);
    CAPTURE(seconds);
    CHECK(difference(renderer.render(seconds), render(own_scene(scene), options, seconds).picture) == "");
  }
}

TEST_CASE("every frame of a deforming scene is as a new renderer makes it") {
  for (const char* scene : {"walking", "morphing"})
    for (const char* algorithm : {"crsh-bvh", "bvh", "crsh"}) check_frames(scene, algorithm);
}

TEST_CASE("what deforms is refitted, and what stands still is not") {
  RenderOptions options = small();
  options.bounces = 0;
  Renderer renderer(borrowed(device()), borrowed(own_scene("morphing")), options);
  for (const double seconds : {0.0, 0.1, 0.1, 0.2}) (void)renderer.render(seconds);
  const ObjectHierarchyStatistics& counts = renderer.statistics().object_hierarchy;
  CHECK(counts.builds + counts.refits >= 3);
  CHECK(counts.refits == 2);
}

}  // namespace
}  // namespace crsh::test
