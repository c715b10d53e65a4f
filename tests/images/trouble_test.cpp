// Forced trouble: small first capacities, small submits, little memory. Pictures and counters do not show it.

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <cstdlib>
#include <string>

#include "crsh/error.h"
#include "images/built_scene.h"
#include "support/device.h"
#include "support/render.h"

namespace crsh::test {
namespace {

RenderOptions small(uint32_t bounces = 2) {
  RenderOptions options;
  options.width = 40;
  options.height = 30;
  options.bounces = bounces;
  return options;
}

/// By a preset on a device of its own.
Rendered troubled(const gpu::DeviceRequest& request, const char* scene, const std::string& algorithm,
                  RenderOptions options) {
  gpu::Device device(request);
  options.algorithm = preset(algorithm);
  Rendered rendered = render(device, own_scene(scene), options);
  CHECK(device.validation_messages() == 0);
  return rendered;
}

void check_same(const Rendered& a, const Rendered& b) {
  CHECK(difference(a.picture, b.picture) == "");
  CHECK(difference_of_counters(a.statistics, b.statistics) == "");
}

TEST_CASE("buffers that start with 1 or 64 bytes change no picture and no counter") {
  const char* scene = "cornell";
  for (const char* algorithm : {"crsh", "crsh-2017"})
    for (const uint64_t bytes : {1, 64}) {
      CAPTURE(std::string(algorithm));
      CAPTURE(bytes);
      gpu::DeviceRequest request = device_request();
      request.first_capacity = bytes;
      check_same(troubled(request, scene, algorithm, small()), render_with(algorithm, own_scene(scene), small()));
    }
}

TEST_CASE("submits of 2^16 tests change no picture and no counter") {
  const char* scene = "cornell";
  for (const std::string& algorithm : preset_names()) {
    CAPTURE(std::string(algorithm));
    RenderOptions options = small(1);
    const Rendered usual = render_with(algorithm, own_scene(scene), options);
    options.submit_work = 1 << 16;
    check_same(usual, render_with(algorithm, own_scene(scene), options));
  }
}

TEST_CASE("256 MiB of device memory, where it would take more, change no picture and no counter") {
  RenderOptions options = small(0);
  options.width = 752;
  options.height = 564;
  const Rendered usual = troubled(device_request(), "glass", "rah", options);
  gpu::DeviceRequest request = device_request();
  request.memory_budget = uint64_t(256) << 20;
  const Rendered frugal = troubled(request, "glass", "rah", options);
  CHECK(usual.statistics.device_peak_bytes > request.memory_budget);
  CHECK(frugal.statistics.device_peak_bytes <= request.memory_budget);
  check_same(frugal, usual);
}

/// The refusal of a budget of so many MiB; empty: it was enough.
std::string refusal(uint64_t mebibytes, const char* scene, const std::string& algorithm, uint32_t bounces = 2) {
  gpu::DeviceRequest request = device_request();
  request.memory_budget = mebibytes << 20;
  try {
    (void)troubled(request, scene, algorithm, small(bounces));
  } catch (const UserError& error) {
    return error.what();
  }
  return {};
}

/// The number at the end of a refusal; 0: it names none.
uint64_t named_minimum(const std::string& message) {
  const std::string words = "it needs at least ";
  const size_t found = message.find(words);
  return found == std::string::npos ? 0 : std::strtoull(message.c_str() + found + words.size(), nullptr, 10);
}

TEST_CASE("the least memory that a refusal names is enough, and changes no picture and no counter") {
  const char* scene = "glass";
  for (const char* algorithm : {"rah", "crsh-2017"}) {
    CAPTURE(std::string(algorithm));
    const std::string message = refusal(2, scene, algorithm);
    CAPTURE(message);
    const uint64_t least = named_minimum(message);
    REQUIRE(least > 2);
    gpu::DeviceRequest request = device_request();
    request.memory_budget = least << 20;
    const Rendered frugal = troubled(request, scene, algorithm, small());
    const Rendered usual = troubled(device_request(), scene, algorithm, small());
    CHECK(frugal.statistics.device_peak_bytes <= least << 20);
    CHECK(frugal.statistics.device_peak_bytes < usual.statistics.device_peak_bytes / 2);
    check_same(frugal, usual);
  }
}

TEST_CASE("the least memory that a refusal names is enough to build the object hierarchy, too") {
  for (const char* scene : {"glass", "office"}) {
    const uint64_t least = named_minimum(refusal(1, scene, "bvh"));
    CAPTURE(least);
    REQUIRE(least > 2);
    CHECK(refusal(least, scene, "bvh") == "");
  }
}

TEST_CASE("where memory does not hold the scene itself, the refusal names what the whole frame needs") {
  const std::string message = refusal(1, "colonnade", "crsh", 0);
  CAPTURE(message);
  CHECK(message.starts_with("a memory budget of 1 MiB is too little"));
  REQUIRE(named_minimum(message) > 1);
  CHECK(refusal(named_minimum(message), "colonnade", "crsh", 0) == "");
}

TEST_CASE("a frame that failed for want of memory counts nothing twice") {
  gpu::Device roomy(device_request());
  RenderOptions options = small(1);
  options.algorithm = preset("rah");
  const Rendered usual = render(roomy, own_scene("glass"), options);
  gpu::DeviceRequest request = device_request();
  request.memory_budget = usual.statistics.device_peak_bytes - 4096;
  gpu::Device device(request);
  const Rendered frugal = render(device, own_scene("glass"), options);
  CHECK(frugal.statistics.device_peak_bytes <= request.memory_budget);
  check_same(frugal, usual);
}

/// A floor, and a strip that hangs over it.
scene::Scene strip_over_floor() {
  Triangles triangles;
  triangles.add_quad({-2, 0, 2}, {2, 0, 2}, {2, 0, -2}, {-2, 0, -2});
  triangles.add_quad({-1, 0.5f, 0.3f}, {1, 0.6f, 0.2f}, {1, 0.6f, -0.3f}, {-1, 0.5f, -0.2f});
  return built_scene(triangles, {matt({0.5f, 0.6f, 0.7f})});
}

TEST_CASE("an image traced in several portions is the same in scanlines, in tiles and by brute force") {
  const scene::Scene scene = strip_over_floor();
  RenderOptions options;
  options.width = 1100;
  options.height = 1000;  // above 2^20 pixels, which are traced together
  options.bounces = 0;
  options.lights = {{{1, 3, 1}, 20.0f}};
  const Rendered brute = render_with("brute", scene, options);
  CHECK(rays_of(brute.statistics, "shadow", 0).count > 1 << 17);
  CHECK(difference(brute, render_with("rah", scene, options)) == "");
  CHECK(difference(brute, render_with("crsh", scene, options)) == "");
}

}  // namespace
}  // namespace crsh::test
