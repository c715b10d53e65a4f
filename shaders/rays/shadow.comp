#version 460
// Shadow rays (section 3.2.2): from a light to a shaded point, where the light lies in front of the geometric normal
// and reaches the point. They start at the light's end, the paper's inversion, and end just before the surface.
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "lib/lights.glsl"
#include "rays/create.glsl"

/// Whether the light shines on the point's front.
bool lit(Light light, vec3 point, vec3 geometric) {
  Incidence incident = incidence(light, point);
  return incident.share > 0.0 && exact_dot(geometric, incident.towards) > 0.0;
}

void store_shadow_ray(uint i, Light light, vec3 point, vec3 geometric, float extent) {
  vec3 end = offset_point(point, geometric, max(extent, largest(light.position.xyz)));
  vec3 origin = light_end(light, end);
  precise vec3 way = end - origin;
  bool parallel = uint(light.position.w) == light_directional;
  store_ray(i, origin, parallel ? light.direction.xyz : exact_normalize(way), exact_length(way),
            light.colour.w * past_backs);
}

/// The normal on the light's side, where light that comes from there counts: also behind what diffuse light goes
/// through, and on no side of what is unlit. 0: nowhere.
vec3 side_to(Light light, vec3 point, vec3 geometric, uint surface) {
  if (has_lobes) {
    SurfaceLobes lobes = LOBES_OF(surface);
    if (lobes.unlit) return vec3(0.0);
    if (lobes.through_share > 0.0 && lit(light, point, -geometric)) return -geometric;
  }
  return lit(light, point, geometric) ? geometric : vec3(0.0);
}

void main() {
  uint i = invocation_index();
  if (i >= count) return;
  uint surface = first_surface + i % surfaces;
  Light light = lights[first_light + i / surfaces];
  vec3 point = positions[surface].xyz, side = side_to(light, point, geometrics[surface].xyz, surface);
  if (met_nothing(surface) || side == vec3(0.0)) store_none(i);
  else store_shadow_ray(i, light, point, side, extent_at(surface));
}
