#include "viewer/camera.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace crsh::viewer {
namespace {

constexpr float pi = float(std::numbers::pi), right_angle = pi / 2;
constexpr float turn_a_height = pi;            // radians that a drag over the image's height turns
constexpr float steep = right_angle * 0.995f;  // beyond this pitch "up" no longer tells how the image is turned
constexpr float least_roll = 1e-4f;            // below this a roll is a rounding error
constexpr float least_distance = 1e-4f, max_distance = 1e7f;

/// Axes with `up` as the second: glTF's own where `up` is glTF's, else any two that fit.
glm::mat3 basis_of(glm::vec3 up) {
  up = glm::length(up) > 0 ? glm::normalize(up) : glm::vec3(0, 1, 0);
  const glm::vec3 near_back = std::abs(up.z) < 0.9f ? glm::vec3(0, 0, 1) : glm::vec3(0, -1, 0);
  const glm::vec3 right = glm::normalize(glm::cross(up, near_back));
  return {right, up, glm::cross(right, up)};
}

}  // namespace

glm::vec3 OrbitCamera::back() const {
  return basis * glm::vec3(std::sin(yaw) * std::cos(pitch), std::sin(pitch), std::cos(yaw) * std::cos(pitch));
}

glm::vec3 OrbitCamera::right() const {
  const glm::vec3 level = basis * glm::vec3(std::cos(yaw), 0, -std::sin(yaw));
  return level * std::cos(roll) + glm::cross(back(), level) * std::sin(roll);
}
glm::vec3 OrbitCamera::up() const { return glm::cross(back(), right()); }

ViewOption OrbitCamera::view() const {
  ViewOption view;
  view.eye = eye();
  view.target = pivot;
  view.up = roll != 0 || std::abs(pitch) > steep ? up() : basis[1];
  if (orthographic) view.orthographic_height = 2 * half_height * distance;
  else view.fov_degrees = std::clamp(glm::degrees(2 * std::atan(half_height)), 0.01f, 179.9f);
  return view;
}

Sight OrbitCamera::sight(glm::vec2 place, float aspect) const {
  const glm::vec3 across = (right() * (place.x * aspect) + up() * place.y) * half_height;
  if (orthographic) return {eye() + across * distance, -back()};
  return {eye(), glm::normalize(across - back())};
}

void OrbitCamera::orbit(glm::vec2 by) {
  by = glm::vec2(by.x * std::cos(roll) + by.y * std::sin(roll), by.y * std::cos(roll) - by.x * std::sin(roll));
  yaw = std::remainder(yaw - by.x * turn_a_height, 2 * pi);
  pitch = std::clamp(pitch + by.y * turn_a_height, -right_angle, right_angle);
}

void OrbitCamera::pan(glm::vec2 by) {
  const float height = 2 * half_height * distance;
  pivot += (up() * by.y - right() * by.x) * height;
}

void OrbitCamera::zoom(float factor, glm::vec2 place, float aspect) {
  const float wanted = std::clamp(distance * factor, least_distance, max_distance);
  const glm::vec3 at = pivot + (right() * (place.x * aspect) + up() * place.y) * (half_height * distance);
  pivot = at + (pivot - at) * (wanted / distance);
  distance = wanted;
}

void OrbitCamera::fly(glm::vec3 by) {
  pivot += right() * by.x + up() * by.y;
  if (orthographic) distance = std::clamp(distance - by.z, least_distance, max_distance);
  else pivot -= back() * by.z;
}

void OrbitCamera::look_at(glm::vec3 point) {
  if (orthographic) return void(pivot = point);
  const glm::vec3 from = eye(), away = from - point;
  const float length = glm::length(away);
  if (!(length > least_distance)) return;
  const glm::vec3 side = glm::transpose(basis) * (away / length);
  pivot = point;
  distance = length;
  pitch = std::asin(std::clamp(side.y, -1.0f, 1.0f));
  if (std::abs(pitch) < steep) yaw = std::atan2(side.x, side.z);
}

void OrbitCamera::turn_to(float new_yaw, float new_pitch) { yaw = new_yaw, pitch = new_pitch, roll = 0; }

void OrbitCamera::frame(const scene::Bounds& bounds, float aspect) {
  if (bounds.empty()) return;
  const float radius = std::max(glm::length(bounds.high - bounds.low) * 0.5f, least_distance);
  pivot = (bounds.low + bounds.high) * 0.5f;
  const float narrow = half_height * std::min(aspect, 1.0f);
  distance = 1.02f * radius / (orthographic ? narrow : std::sin(std::atan(narrow)));
  stand_off = 2 * radius;
}

void OrbitCamera::change_projection(const scene::Bounds& bounds) {
  orthographic = !orthographic;
  const glm::vec3 size = bounds.empty() ? glm::vec3(0) : bounds.high - bounds.low;
  const glm::vec3 middle = bounds.empty() ? pivot : (bounds.low + bounds.high) * 0.5f;
  stand_off = std::max(distance, glm::length(size) + glm::dot(middle - pivot, back()));
}

OrbitCamera orbit_of(const raster::CameraView& view, float distance, glm::vec3 up) {
  OrbitCamera camera;
  camera.basis = basis_of(up);
  camera.half_height = view.orthographic ? view.half_height / distance : view.half_height;
  camera.orthographic = view.orthographic;
  camera.distance = camera.stand_off = distance;
  camera.pivot = view.eye + view.forward * distance;
  const glm::vec3 side = glm::transpose(camera.basis) * -view.forward;
  camera.pitch = std::asin(std::clamp(side.y, -1.0f, 1.0f));
  const glm::vec3 across = glm::transpose(camera.basis) * view.right;
  camera.yaw = std::abs(camera.pitch) < steep ? std::atan2(side.x, side.z) : std::atan2(-across.z, across.x);
  const glm::vec3 level = camera.right();
  const float roll = std::atan2(glm::dot(view.right, camera.up()), glm::dot(view.right, level));
  camera.roll = std::abs(roll) > least_roll ? roll : 0;
  return camera;
}

}  // namespace crsh::viewer
