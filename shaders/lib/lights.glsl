#ifndef CRSH_LIB_LIGHTS_GLSL
#define CRSH_LIB_LIGHTS_GLSL
// How much of a light reaches a point (KHR_lights_punctual). Ray creation and shading use the same function.

#include "lib/exact.glsl"
#include "shared/scene.h"

/// Unit direction to the light, and the share of its intensity that arrives, 1/m2 (directional: 1); 0 where none does.
struct Incidence {
  vec3 towards;
  float share;
};

/// The inverse square of the distance, which falls smoothly to 0 at `range` (infinite: it does not).
float distance_share(float squared, float range) {
  if (squared < 1e-20) return 0.0;
  precise float relative = squared / (range * range);
  precise float window = clamp(1.0 - relative * relative, 0.0, 1.0);
  return window / squared;
}

Incidence incidence(Light light, vec3 point) {
  if (uint(light.position.w) == light_directional) return Incidence(-light.direction.xyz, 1.0);
  precise vec3 way = light.position.xyz - point;
  vec3 towards = exact_normalize(way);
  precise float angular = clamp(light.cone.y - exact_dot(light.direction.xyz, towards) * light.cone.x, 0.0, 1.0);
  return Incidence(towards, distance_share(exact_dot(way, way), light.direction.w) * angular * angular);
}

/// Where a shadow ray to `point` starts: at the light (the paper's inversion, section 3.2.2). That of a directional
/// light starts on the plane through the light's position, which lies outside the scene's bounds.
vec3 light_end(Light light, vec3 point) {
  if (uint(light.position.w) != light_directional) return light.position.xyz;
  precise vec3 from_plane = point - light.position.xyz;
  precise float height = exact_dot(from_plane, light.direction.xyz);
  precise vec3 origin = point - light.direction.xyz * height;
  return origin;
}

#endif
