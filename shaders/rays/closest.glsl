// What the creation of closest-hit rays shares: they start at a surface and leave their weight to the gathering.

#include "lib/fresnel.glsl"
#include "rays/create.glsl"

// w: the solid that the ray travels in and, as a fraction, what of the weight passes by a surface that is not wholly
// there: always less than 1, because what is hardly there is not met.
layout(binding = 11, scalar) writeonly buffer Weights { vec4 weights[]; };
layout(binding = 12, scalar) readonly buffer Footprints { vec2 footprints[]; };  // y: how much of the surface is there

/// Cosine between the shading normal and the way back along the ray that came.
float cosine_of(vec3 normal, vec3 incoming) { return clamp(-exact_dot(normal, incoming), 0.0, 1.0); }

/// Writes the surface's weight and, where that is large enough, its ray, which leaves to the side that `side` points
/// to. `weight`: of the part of the surface that is there; `beside`: of the part that is not; `medium`: number of the
/// Lobes whose solid it travels in, 0: none.
void store(uint i, vec3 weight, float beside, vec3 side, vec3 direction, float medium) {
  uint surface = first_surface + i;
  float alpha = footprints[surface].y, passing = (1.0 - alpha) * beside;
  weight = weight * alpha + passing;
  bool starts = worth_casting(weight) && !met_nothing(surface);
  weights[surface] = starts ? vec4(weight, medium + passing) : vec4(0.0);
  if (!starts) {
    store_none(i);
    return;
  }
  float endless = uintBitsToFloat(0x7F800000u);
  store_ray(i, offset_point(positions[surface].xyz, side, extent_at(surface)), direction, endless);
}

/// The same for rays that show nothing of what lies behind.
void store(uint i, vec3 weight, vec3 side, vec3 direction, float medium) {
  store(i, weight, 0.0, side, direction, medium);
}

void store(uint i, vec3 weight, vec3 side, vec3 direction) { store(i, weight, side, direction, 0.0); }
