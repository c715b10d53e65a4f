#include "images/boxes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <numbers>

#include "images/built_scene.h"

namespace crsh::test {
namespace {

using glm::dvec3;

/// Corner `index` of a box: bit n chooses the end of axis n.
dvec3 corner(const Box& box, int index) {
  return {index & 1 ? box.high.x : box.low.x, index & 2 ? box.high.y : box.low.y, index & 4 ? box.high.z : box.low.z};
}

/// Corners of the six faces, counter-clockwise from outside.
constexpr int faces[6][4] = {{0, 4, 6, 2}, {1, 3, 7, 5}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 2, 3, 1}, {4, 5, 7, 6}};

void add_box(const Box& box, const Placement& placement, Triangles& triangles) {
  const auto at = [&](int index) { return glm::vec3(placement.to_world(corner(box, index))); };
  for (const auto& face : faces) triangles.add_quad(at(face[0]), at(face[1]), at(face[2]), at(face[3]));
}

/// Whether the way from `from` to `to` leads through the box, grown by `margin`.
bool meets(const Box& box, const dvec3& from, const dvec3& to, double margin) {
  double enter = 0, leave = 1;
  for (int axis = 0; axis < 3; ++axis) {
    const double low = box.low[axis] - margin - from[axis], high = box.high[axis] + margin - from[axis];
    const double way = to[axis] - from[axis];
    if (low > high) return false;
    if (way == 0) {
      if (low > 0 || high < 0) return false;
      continue;
    }
    enter = std::max(enter, std::min(low / way, high / way));
    leave = std::min(leave, std::max(low / way, high / way));
  }
  return enter < leave;
}

bool blocked(const BoxScene& scene, const dvec3& from, const dvec3& to, double margin) {
  return std::ranges::any_of(scene.boxes, [&](const Box& box) { return meets(box, from, to, margin); });
}

enum class Light { yes, no, doubt };

/// The oracle: `point` on a face with this unit normal, own coordinates.
Light light_at(const BoxScene& scene, const dvec3& point, const dvec3& normal, double margin) {
  const dvec3 way = scene.lights.front() - point;
  const double cosine = glm::dot(normal, glm::normalize(way));
  if (cosine < -0.02) return Light::no;
  if (cosine < 0.02) return Light::doubt;
  const dvec3 above = point + normal * (2 * margin);
  if (blocked(scene, above, scene.lights.front(), -3 * margin)) return Light::no;
  return blocked(scene, above, scene.lights.front(), margin) ? Light::doubt : Light::yes;
}

struct Pixel {
  dvec3 point{0}, normal{0};
  float depth = 0, light = 0;
};

/// What the picture has at a pixel, in own coordinates. The camera's matrix tells the eye's axes.
Pixel pixel_at(const BoxScene& scene, const Picture& picture, uint32_t x, uint32_t y) {
  const size_t index = size_t(y) * picture.width + x;
  const glm::dmat4 to_camera(picture.world_to_camera);
  const double half = std::tan(scene.fov * std::numbers::pi / 360);
  Pixel pixel;
  pixel.depth = picture.find("Z")->values[index];
  pixel.light = picture.find("")->values[index * 4];
  const dvec3 seen = dvec3((2 * (x + 0.5) / picture.width - 1) * half, (1 - 2 * (y + 0.5) / picture.height) * half, 1) *
                     double(pixel.depth);
  const glm::dmat3 axes(to_camera);
  const dvec3 eye(glm::vec3(scene.placement.to_world(scene.eye)));
  pixel.point = scene.placement.to_own(eye + glm::transpose(axes) * seen);
  const float* normal = &picture.find("N")->values[index * 3];
  pixel.normal = glm::transpose(scene.placement.rotation()) * dvec3(normal[0], normal[1], normal[2]);
  return pixel;
}

void judge(const Pixel& pixel, Light expected, uint32_t x, uint32_t y, Lighting& lighting) {
  if (expected == Light::doubt) return;
  const bool wanted = expected == Light::yes, wrong = wanted != (pixel.light > 0);
  ++(wanted ? lighting.lit : lighting.shadowed);
  if (!wrong) return;
  ++(wanted ? lighting.acne : lighting.leaks);
  if (lighting.first.empty())
    lighting.first = fmt::format("({}, {}) is {} at {} {} {}", x, y, wanted ? "dark" : "lit", pixel.point.x,
                                 pixel.point.y, pixel.point.z);
}

}  // namespace

glm::dmat3 Placement::rotation() const {
  if (!turned) return glm::dmat3(1);
  return glm::dmat3(glm::rotate(glm::rotate(glm::dmat4(1), 0.7, {0.3, 0.8, 0.5}), 0.4, {0.9, -0.1, 0.2}));
}

dvec3 Placement::to_world(const dvec3& point) const { return rotation() * point * scale + offset; }
dvec3 Placement::to_own(const dvec3& point) const { return glm::transpose(rotation()) * (point - offset) / scale; }

scene::Scene scene_of(const BoxScene& boxes) {
  Triangles triangles;
  for (const Box& box : boxes.boxes) add_box(box, boxes.placement, triangles);
  return built_scene(triangles, {matt(glm::vec3(0.5f))});
}

RenderOptions options_of(const BoxScene& boxes, uint32_t size) {
  const auto world = [&](const dvec3& point) { return glm::vec3(boxes.placement.to_world(point)); };
  RenderOptions options;
  options.width = options.height = size;
  options.bounces = 0;
  options.view.eye = world(boxes.eye);
  options.view.target = world(boxes.target);
  options.view.up = glm::vec3(boxes.placement.rotation() * dvec3(0, 1, 0));
  options.view.fov_degrees = static_cast<float>(boxes.fov);
  for (const dvec3& light : boxes.lights) {
    const double distance = glm::distance(light, boxes.target) * boxes.placement.scale;
    options.lights.push_back({world(light), static_cast<float>(distance * distance)});
  }
  return options;
}

glm::mat4 node_shining(const dvec3& direction) {
  const dvec3 x = glm::normalize(glm::cross(direction, dvec3(0.3, 0.2, 0.9))), y = glm::cross(x, direction);
  return glm::mat4(glm::dmat4(glm::dvec4(x, 0), glm::dvec4(y, 0), glm::dvec4(-direction, 0), glm::dvec4(0, 0, 0, 1)));
}

Lighting lighting_of(const BoxScene& boxes, const Picture& picture, double margin) {
  Lighting lighting;
  for (uint32_t y = 0; y < picture.height; ++y)
    for (uint32_t x = 0; x < picture.width; ++x) {
      const Pixel pixel = pixel_at(boxes, picture, x, y);
      if (pixel.depth < 1e10f) judge(pixel, light_at(boxes, pixel.point, pixel.normal, margin), x, y, lighting);
    }
  return lighting;
}

}  // namespace crsh::test
