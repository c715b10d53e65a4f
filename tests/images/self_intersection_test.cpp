// No acne and no leaks: rays leave the surface that they start from, at any scale and anywhere, and walls are tight.

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "images/boxes.h"
#include "support/render.h"

namespace crsh::test {
namespace {

struct Place {
  const char* name;
  Placement placement;
  double margin;  ///< of the oracle, own lengths: above the step that moves rays off surfaces
};

const Place places[] = {
    {"as it is", {}, 0.002},
    {"turned", {.turned = true}, 0.002},
    {"a thousand times as large", {.scale = 1000, .turned = true}, 0.002},
    {"a thousandth as large", {.scale = 0.001, .turned = true}, 0.002},
    {"10,000 m away", {.scale = 4, .offset = {6000, -3000, 7500}, .turned = true}, 0.05},
};

/// On a slab, boxes that touch it and one another.
BoxScene touching_boxes(const Placement& placement, const glm::dvec3& light) {
  return {.boxes = {{{-2, -0.2, -2}, {2, 0, 2}},
                    {{-0.5, 0, -0.5}, {0.5, 1, 0.5}},
                    {{0.5, 0, -0.4}, {1, 0.5, 0.2}},
                    {{-0.25, 1, -0.25}, {0.3, 1.4, 0.25}},
                    {{-1.5, 0, 0.7}, {-0.7, 0.3, 1.4}}},
          .lights = {light},
          .eye = {1.9, 2.1, 2.7},
          .target = {0, 0.3, 0},
          .placement = placement};
}

/// One layer of triangles around the eye.
BoxScene room(const Placement& placement, const glm::dvec3& light) {
  return {.boxes = {{{-1, -1, -1}, {1, 1, 1}}},
          .lights = {light},
          .eye = {0.3, 0.1, -0.4},
          .target = {-0.6, -0.7, 0.9},
          .fov = 100,
          .placement = placement};
}

RenderOptions mirrored(RenderOptions options) {
  options.override_mirror = true;
  options.bounces = 4;
  return options;
}

bool is_dark(const Picture& picture) {
  const std::vector<float>& values = picture.find("")->values;
  for (size_t i = 0; i < values.size(); ++i)
    if (i % 4 != 3 && values[i] != 0) return false;
  return true;
}

void check_lighting(const BoxScene& boxes, const Picture& picture, double margin) {
  const Lighting lighting = lighting_of(boxes, picture, margin);
  CHECK(lighting.lit > picture.width * picture.height / 10);
  CHECK(lighting.shadowed > picture.width * picture.height / 50);
  CHECK_MESSAGE(lighting.acne == 0, lighting.first);
  CHECK_MESSAGE(lighting.leaks == 0, lighting.first);
}

void check_boxes(const Place& place, const glm::dvec3& light, double margin) {
  CAPTURE(std::string(place.name));
  const BoxScene boxes = touching_boxes(place.placement, light);
  check_lighting(boxes, render(scene_of(boxes), options_of(boxes, 96)).picture, margin);
}

TEST_CASE("touching boxes have no acne and attached shadows, at any scale and anywhere") {
  for (const Place& place : places) check_boxes(place, {-1.4, 2.2, -0.9}, place.margin);
}

TEST_CASE("a light close to a face makes no acne") {
  for (const Place& place : places) check_boxes(place, {0.8, 0.75, 0.9}, place.margin);
}

TEST_CASE("a light 10 km away from a metre's boxes makes no acne, and its shadows stay attached") {
  for (const Place& place : places)
    if (place.placement.scale == 1) check_boxes(place, {-6000, 7000, -4000}, 0.02);
}

/// A wide slab, seen from close by: beside the world's origin coordinates are small, but not the slab's and the
/// light's.
BoxScene wide_slab(double height) {
  return {.boxes = {{{-20, -1, -20}, {20, 0, 20}}},
          .lights = {{3, 8, 5}},
          .eye = glm::dvec3(0.3, 1, 0.2) * height,
          .target = {0, 0, 0},
          .placement = {.turned = true}};
}

TEST_CASE("a wide floor has no acne where it leads through the world's origin") {
  for (const double height : {0.05, 0.5, 5.0}) {
    CAPTURE(height);
    const BoxScene slab = wide_slab(height);
    const Rendered rendered = render(scene_of(slab), mirrored(options_of(slab, 96)));
    CHECK(rays_of(rendered.statistics, "shadow", 0).count == 96 * 96);
    CHECK(rays_of(rendered.statistics, "shadow", 0).hits == 0);
    CHECK(rays_of(rendered.statistics, "reflection", 0).count == 96 * 96);
    CHECK(rays_of(rendered.statistics, "reflection", 0).hits == 0);
  }
}

TEST_CASE("a directional light makes no acne") {
  for (const Place& place : places) {
    CAPTURE(std::string(place.name));
    const glm::dvec3 towards = glm::normalize(glm::dvec3(-0.6, 0.7, -0.4));
    const BoxScene boxes = touching_boxes(place.placement, towards * 1e7);
    scene::Scene scene = scene_of(boxes);
    scene.nodes.push_back({.matrix = node_shining(-(place.placement.rotation() * towards))});
    scene.lights.push_back({.type = scene::LightType::directional, .intensity = 3, .node = 1});
    RenderOptions options = options_of(boxes, 96);
    options.lights.clear();
    check_lighting(boxes, render(scene, options).picture, place.margin);
  }
}

TEST_CASE("every point of a closed room is lit by the light in it") {
  for (const Place& place : places) {
    CAPTURE(std::string(place.name));
    const BoxScene boxes = room(place.placement, {-0.2, 0.6, 0.3});
    const Rendered rendered = render(scene_of(boxes), options_of(boxes, 64));
    CHECK(rays_of(rendered.statistics, "shadow", 0).count == 64 * 64);
    CHECK(rays_of(rendered.statistics, "shadow", 0).hits == 0);
  }
}

TEST_CASE("a closed room is black inside where the light is outside") {
  for (const Place& place : places) {
    CAPTURE(std::string(place.name));
    const BoxScene boxes = room(place.placement, {1.4, 2.1, -1.7});
    const Rendered rendered = render(scene_of(boxes), options_of(boxes, 64));
    CHECK(rays_of(rendered.statistics, "shadow", 0).count > 0);
    CHECK(is_dark(rendered.picture));
  }
}

TEST_CASE("a closed room is black outside where the light is inside") {
  for (const Place& place : places) {
    CAPTURE(std::string(place.name));
    BoxScene boxes = room(place.placement, {-0.2, 0.6, 0.3});
    boxes.eye = {2.5, 2.1, -2.7};
    boxes.target = {0, 0, 0};
    CHECK(is_dark(render(scene_of(boxes), options_of(boxes, 64)).picture));
  }
}

TEST_CASE("no mirrored ray escapes from a closed room") {
  for (const Place& place : places) {
    const BoxScene boxes = room(place.placement, {-0.2, 0.6, 0.3});
    const Rendered rendered = render(scene_of(boxes), mirrored(options_of(boxes, 64)));
    for (uint32_t bounce = 0; bounce < 4; ++bounce) {
      CAPTURE(std::string(place.name));
      CAPTURE(bounce);
      CHECK(rays_of(rendered.statistics, "reflection", bounce).count == 64 * 64);
      CHECK(rays_of(rendered.statistics, "reflection", bounce).hits == 64 * 64);
    }
  }
}

TEST_CASE("no mirrored ray meets the convex box that it left") {
  for (const Place& place : places) {
    CAPTURE(std::string(place.name));
    BoxScene boxes = touching_boxes(place.placement, {1.2, 3, 1.5});
    boxes.boxes.resize(1);
    const Rendered rendered = render(scene_of(boxes), mirrored(options_of(boxes, 64)));
    CHECK(rays_of(rendered.statistics, "reflection", 0).count > 0);
    CHECK(rays_of(rendered.statistics, "reflection", 0).hits == 0);
  }
}

}  // namespace
}  // namespace crsh::test
