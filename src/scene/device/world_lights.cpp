#include "scene/device/world_lights.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace crsh::scene {
namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();

glm::vec3 centre_of(const Bounds& bounds) { return bounds.empty() ? glm::vec3(0) : (bounds.low + bounds.high) * 0.5f; }
float radius_of(const Bounds& bounds) { return bounds.empty() ? 1.0f : glm::length(bounds.high - bounds.low) * 0.5f; }

shared::Light point_light(glm::vec3 position, float candela, bool past_backs) {
  return {glm::vec4(position, float(shared::light_point)), glm::vec4(0, 0, -1, infinity),
          glm::vec4(glm::vec3(candela), past_backs ? 1 : 0), glm::vec4(0, 1, 0, 0)};
}

/// The intensity that lights the middle of the scene with π lux, whatever its scale, so that white walls there have 1
/// cd/m2.
float default_candela(float distance, size_t count) {
  return float(std::numbers::pi * double(distance) * distance / double(count));
}

LightRig rig_of_options(const Scene& scene, std::span<const LightOption> options, const Bounds& bounds) {
  LightRig rig;
  for (const LightOption& option : options) {
    const glm::vec3 at = scene.drawn(option.position);
    const float candela =
        option.candela.value_or(default_candela(glm::distance(at, centre_of(bounds)), options.size()));
    rig.fixed.push_back(point_light(at, candela, option.past_backs));
    if (!option.candela) rig.chosen.push_back({option.position, candela, option.past_backs});
  }
  return rig;
}

/// The default light: above and to the right of the eye, at a tenth of the eye's distance to the middle of the scene.
/// It shines past backs, so that it never stands behind walls that the eye looks past: into a doll's house.
LightRig rig_of_default(const Scene& scene, const Bounds& bounds, const Viewpoint& viewpoint) {
  const float away = std::max(glm::distance(viewpoint.eye, centre_of(bounds)), radius_of(bounds) * 0.5f);
  const glm::dvec3 at = scene.in_file(viewpoint.eye + (viewpoint.right + viewpoint.up) * (0.1f * away));
  const float candela = default_candela(away, 1);
  return {{point_light(scene.drawn(at), candela, true)}, {{at, candela, true}}};
}

glm::vec3 shines_along(const glm::mat4& transform) {
  const glm::vec3 axis = -glm::vec3(transform[2]);
  const float length = glm::length(axis);
  return length > 0 && std::isfinite(length) ? axis / length : glm::vec3(0, 0, -1);
}

/// Scale and offset of the angular attenuation, as KHR_lights_punctual suggests; 0 and 1 do nothing.
glm::vec4 cone_of(const Light& light) {
  if (light.type != LightType::spot) return {0, 1, 0, 0};
  const float inner = std::min(light.inner_cone, light.outer_cone);
  const float scale = 1 / std::max(0.001f, std::cos(inner) - std::cos(light.outer_cone));
  return {scale, -std::cos(light.outer_cone) * scale, 0, 0};
}

shared::Light world_light(const Light& light, const glm::mat4& transform, const Bounds& bounds) {
  const glm::vec3 direction = shines_along(transform);
  const bool parallel = light.type == LightType::directional;
  const glm::vec3 outside = centre_of(bounds) - direction * (radius_of(bounds) * 1.01f);
  return {glm::vec4(parallel ? outside : glm::vec3(transform[3]), float(light.type)),
          glm::vec4(direction, parallel ? infinity : light.range), glm::vec4(light.colour * light.intensity, 0),
          cone_of(light)};
}

}  // namespace

LightRig resolve_lights(const Scene& scene, std::span<const LightOption> options, const Bounds& bounds,
                        const Viewpoint& viewpoint) {
  if (!options.empty()) return rig_of_options(scene, options, bounds);
  if (!scene.lights.empty()) return {};
  return rig_of_default(scene, bounds, viewpoint);
}

std::vector<shared::Light> world_lights(const Scene& scene, const Pose& pose, const LightRig& rig,
                                        const Bounds& bounds) {
  if (!rig.fixed.empty()) return rig.fixed;
  std::vector<shared::Light> lights;
  for (uint32_t i = 0; i < scene.lights.size(); ++i)
    lights.push_back(world_light(changed_or(pose.changes.lights, scene.lights, i), pose.lights[i], bounds));
  return lights;
}

}  // namespace crsh::scene
