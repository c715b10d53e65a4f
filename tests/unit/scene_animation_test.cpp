// Keyframes: interpolation, clamping, hierarchy.

#include <doctest/doctest.h>

#include <cmath>

#include "scene/animation.h"
#include "scene_file.h"

using namespace crsh;
using scene::Channel;
using scene::Interpolation;
using scene::Path;
using test::GltfText;

namespace {

constexpr float half = 0.70710678f;

Channel translation(Interpolation interpolation, std::vector<float> times, std::vector<glm::vec4> values) {
  return {0, Path::translation, interpolation, std::move(times), std::move(values)};
}

/// A triangle on node 1 below node 0; `path` of node `node` animated.
GltfText animated(int node, const std::string& path, const std::string& interpolation, const std::vector<float>& times,
                  const std::vector<float>& values,
                  const std::string& nodes = R"({"children":[1]},{"mesh":0,"translation":[1,0,0]})") {
  GltfText file = test::one_triangle();
  file.nodes = nodes;
  file.values("SCALAR", 5126, times.size(), times);
  file.values(path == "rotation" ? "VEC4" : "VEC3", 5126, values.size() / (path == "rotation" ? 4 : 3), values);
  file.more =
      R"(,"animations":[{"name":"first","channels":[]},{"name":"move","channels":[{"sampler":0,"target":{"node":)" +
      std::to_string(node) + R"(,"path":")" + path + R"("}}],"samplers":[{"input":1,"output":2,"interpolation":")" +
      interpolation + R"("}]}])";
  return file;
}

glm::vec3 corner(const scene::Scene& scene, double seconds) {
  return glm::vec3(scene.pose(seconds, 1).instances.at(0)[3]);
}

}  // namespace

TEST_CASE("steps hold, lines blend, both hold before the first and after the last key") {
  const std::vector<glm::vec4> values = {{0, 0, 0, 0}, {10, 0, 0, 0}};
  const Channel step = translation(Interpolation::step, {1, 3}, values),
                linear = translation(Interpolation::linear, {1, 3}, values);
  CHECK(scene::sample(step, 2.999).x == 0);
  CHECK(scene::sample(step, 3).x == 10);
  CHECK(scene::sample(linear, 1.5).x == doctest::Approx(2.5));
  for (const Channel& channel : {step, linear}) {
    CHECK(scene::sample(channel, -5).x == 0);
    CHECK(scene::sample(channel, 1).x == 0);
    CHECK(scene::sample(channel, 99).x == 10);
  }
}

TEST_CASE("splines pass their keys with the tangents given, scaled by the span") {
  const Channel channel =
      translation(Interpolation::cubic_spline, {0, 2},
                  {{0, 0, 0, 0}, {0, 0, 0, 0}, {1, 0, 0, 0}, {1, 0, 0, 0}, {2, 0, 0, 0}, {0, 0, 0, 0}});
  CHECK(scene::sample(channel, 0).x == 0);
  CHECK(scene::sample(channel, 0.5).x == doctest::Approx(0.5));
  CHECK(scene::sample(channel, 1).x == doctest::Approx(1));
  CHECK(scene::sample(channel, 2).x == 2);
}

TEST_CASE("rotations turn the short way round at even speed and stay unit") {
  const Channel channel{0, Path::rotation, Interpolation::linear, {0, 1}, {{0, 0, 0, 1}, {0, 0, -half, -half}}};
  for (const double t : {0.0, 0.25, 0.5, 1.0}) {
    const glm::vec4 q = scene::sample(channel, t);
    CHECK(glm::length(q) == doctest::Approx(1));
    CHECK(2 * std::acos(std::abs(q.w)) == doctest::Approx(t * 1.5707963).epsilon(1e-4));
  }
  const Channel nothing{0, Path::rotation, Interpolation::step, {0}, {{0, 0, 0, 0}}};
  CHECK(scene::sample(nothing, 0) == glm::vec4(0, 0, 0, 1));
}

TEST_CASE("an animated parent carries its child; without the animation nothing moves") {
  const scene::Scene scene = animated(0, "rotation", "LINEAR", {0, 2}, {0, 0, 0, 1, 0, 0, half, half}).load();
  CHECK(glm::distance(corner(scene, 2), glm::vec3(0, 1, 0)) < 1e-6f);
  CHECK(glm::distance(corner(scene, 1), glm::vec3(half, half, 0)) < 1e-6f);
  CHECK(glm::vec3(scene.pose(2, {}).instances.at(0)[3]) == glm::vec3(1, 0, 0));
  CHECK(scene.pose(2, 0).instances.at(0) == scene.pose(0, {}).instances.at(0));
  CHECK(scene.animations.at(1).name == "move");
  CHECK(scene.animations.at(1).duration == 2);
}

TEST_CASE("scale and translation replace the node's own") {
  const scene::Scene scaled = animated(0, "scale", "STEP", {0, 1}, {1, 1, 1, 3, 3, 3}).load();
  CHECK(corner(scaled, 1) == glm::vec3(3, 0, 0));
  const scene::Scene moved = animated(1, "translation", "LINEAR", {0, 1}, {0, 0, 0, 0, 8, 0}).load();
  CHECK(corner(moved, 0.5) == glm::vec3(0, 4, 0));
}

TEST_CASE("a node with a matrix, or outside the scene, is not animated; morph targets are noted") {
  const scene::Scene fixed = animated(0, "translation", "LINEAR", {0}, {5, 5, 5},
                                      R"({"mesh":0,"matrix":[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1]},{})")
                                 .load();
  CHECK(fixed.animations.at(1).channels.empty());
  const scene::Scene outside = animated(1, "translation", "LINEAR", {0}, {5, 5, 5}, R"({"mesh":0},{})").load();
  CHECK(outside.animations.at(1).channels.empty());
  CHECK(animated(0, "weights", "LINEAR", {0}, {0, 0, 0}).load().unsupported ==
        std::vector<std::string>{"animation of morph targets"});
}
