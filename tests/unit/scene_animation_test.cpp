// Keyframes: interpolation, clamping, hierarchy.

#include <doctest/doctest.h>

#include <cmath>

#include "crsh/error.h"
#include "scene/animation.h"
#include "scene/playing.h"
#include "scene/properties.h"
#include "scene_file.h"

using namespace crsh;
using scene::Channel;
using scene::Interpolation;
using test::GltfText;

namespace {

constexpr float half = 0.70710678f;

Channel translation(Interpolation interpolation, std::vector<float> times, const std::vector<float>& x) {
  Channel out;
  out.interpolation = interpolation;
  out.times = std::move(times);
  for (const float value : x) out.values.insert(out.values.end(), {value, 0, 0});
  return out;
}

Channel rotation(Interpolation interpolation, std::vector<float> times, std::vector<float> values) {
  return {{scene::Driven::node, 0, scene::node_rotation}, interpolation, 4, std::move(times), std::move(values)};
}

float x_of(const Channel& channel, double seconds) { return scene::sample(channel, seconds).at(0); }

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
  return glm::vec3(scene.pose(seconds, {1}).instances.at(0)[3]);
}

}  // namespace

TEST_CASE("steps hold, lines blend, both hold before the first and after the last key") {
  const std::vector<float> values = {0, 10};
  const Channel step = translation(Interpolation::step, {1, 3}, values),
                linear = translation(Interpolation::linear, {1, 3}, values);
  CHECK(x_of(step, 2.999) == 0);
  CHECK(x_of(step, 3) == 10);
  CHECK(x_of(linear, 1.5) == doctest::Approx(2.5));
  for (const Channel& channel : {step, linear}) {
    CHECK(x_of(channel, -5) == 0);
    CHECK(x_of(channel, 1) == 0);
    CHECK(x_of(channel, 99) == 10);
  }
}

TEST_CASE("splines pass their keys with the tangents given, scaled by the span") {
  const Channel channel = translation(Interpolation::cubic_spline, {0, 2}, {0, 0, 1, 1, 2, 0});
  CHECK(x_of(channel, 0) == 0);
  CHECK(x_of(channel, 0.5) == doctest::Approx(0.5));
  CHECK(x_of(channel, 1) == doctest::Approx(1));
  CHECK(x_of(channel, 2) == 2);
}

TEST_CASE("rotations turn the short way round at even speed and stay unit") {
  const Channel channel = rotation(Interpolation::linear, {0, 1}, {0, 0, 0, 1, 0, 0, -half, -half});
  for (const double t : {0.0, 0.25, 0.5, 1.0}) {
    const std::vector<float> q = scene::sample(channel, t);
    CHECK(glm::length(glm::vec4(q[0], q[1], q[2], q[3])) == doctest::Approx(1));
    CHECK(2 * std::acos(std::abs(q[3])) == doctest::Approx(t * 1.5707963).epsilon(1e-4));
  }
  const Channel nothing = rotation(Interpolation::step, {0}, {0, 0, 0, 0});
  CHECK(scene::sample(nothing, 0) == std::vector<float>{0, 0, 0, 1});
}

TEST_CASE("an animated parent carries its child; without the animation nothing moves") {
  const scene::Scene scene = animated(0, "rotation", "LINEAR", {0, 2}, {0, 0, 0, 1, 0, 0, half, half}).load();
  CHECK(glm::distance(corner(scene, 2), glm::vec3(0, 1, 0)) < 1e-6f);
  CHECK(glm::distance(corner(scene, 1), glm::vec3(half, half, 0)) < 1e-6f);
  CHECK(glm::vec3(scene.pose(2, {}).instances.at(0)[3]) == glm::vec3(1, 0, 0));
  CHECK(scene.pose(2, {0}).instances.at(0) == scene.pose(0, {}).instances.at(0));
  CHECK(scene.animations.at(1).name == "move");
  CHECK(scene.animations.at(1).duration == 2);
}

TEST_CASE("scale and translation replace the node's own") {
  const scene::Scene scaled = animated(0, "scale", "STEP", {0, 1}, {1, 1, 1, 3, 3, 3}).load();
  CHECK(corner(scaled, 1) == glm::vec3(3, 0, 0));
  const scene::Scene moved = animated(1, "translation", "LINEAR", {0, 1}, {0, 0, 0, 0, 8, 0}).load();
  CHECK(corner(moved, 0.5) == glm::vec3(0, 4, 0));
}

TEST_CASE("a node with a matrix, or outside the scene, is not animated; what is not known is noted") {
  const scene::Scene fixed = animated(0, "translation", "LINEAR", {0}, {5, 5, 5},
                                      R"({"mesh":0,"matrix":[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1]},{})")
                                 .load();
  CHECK(fixed.animations.at(1).channels.empty());
  const scene::Scene outside = animated(1, "translation", "LINEAR", {0}, {5, 5, 5}, R"({"mesh":0},{})").load();
  CHECK(outside.animations.at(1).channels.empty());
  CHECK(animated(0, "colour", "LINEAR", {0}, {0, 0, 0}).load().unsupported ==
        std::vector<std::string>{"animation of 'colour'"});
}

TEST_CASE("a frame at a key's time shows that key, at any number of frames a second, however the file rounded it") {
  for (const double rate : {24.0, 25.0, 30.0, 50.0, 60.0, 23.976, 29.97}) {
    CAPTURE(rate);
    std::vector<float> divided, multiplied, values;
    for (int frame = 0; frame < 2000; ++frame) {
      divided.push_back(float(frame / rate));
      multiplied.push_back(float(frame) * float(1 / rate));
      values.push_back(float(frame));
    }
    const Channel one = translation(Interpolation::step, divided, values),
                  other = translation(Interpolation::step, multiplied, values),
                  line = translation(Interpolation::linear, divided, values);
    int late = 0, off = 0;
    for (int frame = 0; frame < 2000; ++frame) {
      late += x_of(one, frame / rate) != float(frame);
      late += x_of(other, frame / rate) != float(frame);
      late += x_of(one, double(float(frame / rate))) != float(frame);
      late += x_of(one, frame / double(float(rate))) != float(frame);
      off += std::abs(x_of(line, frame / rate) - float(frame)) > 1e-3f;
    }
    CHECK(late == 0);
    CHECK(off == 0);
  }
}

TEST_CASE("a step that is yet to come is not shown early") {
  const Channel channel = translation(Interpolation::step, {0, 10}, {0, 1});
  CHECK(x_of(channel, 9.9999) == 0);
  CHECK(x_of(channel, 10) == 1);
}

namespace {

/// Animations of one key each: `paths` of node 0, the value 2 i of the i-th.
GltfText several(const std::vector<std::string>& paths) {
  GltfText file = test::one_triangle();
  file.values<float>("SCALAR", 5126, 1, {0});
  for (size_t i = 0; i < paths.size(); ++i) file.values<float>("VEC3", 5126, 1, std::vector<float>(3, 2.0f * float(i)));
  file.more = R"(,"animations":[)";
  for (size_t i = 0; i < paths.size(); ++i)
    file.more += (i ? "," : "") + std::string(R"({"name":"a)") + std::to_string(i) +
                 R"(","channels":[{"sampler":0,"target":{"node":0,"path":")" + paths[i] +
                 R"("}}],"samplers":[{"input":1,"output":)" + std::to_string(2 + i) + "}]}";
  file.more += "]";
  return file;
}

using Chosen = std::vector<uint32_t>;

}  // namespace

TEST_CASE("animations that drive different things play together, and of others the first; a line says so") {
  const scene::Scene apart = several({"scale", "translation"}).load(),
                     same = several({"translation", "scale", "translation"}).load();
  const scene::Playing both = scene::playing(apart, ""), first = scene::playing(same, "");
  CHECK(both.animations == Chosen{0, 1});
  CHECK(both.note == "2 animations play together: 'a0', 'a1'");
  CHECK(first.animations == Chosen{0, 1});
  CHECK(first.note == "animations that play: 'a0', 'a1'; left out, because they move the same: 'a2'");
  CHECK(scene::playing(several({"scale"}).load(), "").note.empty());
  CHECK(scene::playing(test::one_triangle().load(), "").animations.empty());
}

TEST_CASE("an animation is chosen by name or index, or all of them, of which the last counts") {
  const scene::Scene scene = several({"translation", "scale", "translation"}).load();
  CHECK(scene::playing(scene, "a2").animations == Chosen{2});
  CHECK(scene::playing(scene, "1").animations == Chosen{1});
  CHECK(scene::playing(scene, "all").animations == Chosen{0, 1, 2});
  CHECK(glm::vec3(scene.pose(0, {0, 1, 2}).instances.at(0)[3]) == glm::vec3(4));
  CHECK_THROWS_WITH_AS((void)scene::playing(scene, "dance"), doctest::Contains("it has 3: 'a0' 'a1' 'a2'"), UserError);
}
