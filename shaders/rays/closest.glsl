// What the creation of closest-hit rays shares: they start at a surface and leave their weight to the gathering.

#include "lib/fresnel.glsl"
#include "rays/create.glsl"

layout(binding = 11, scalar) writeonly buffer Weights { vec4 weights[]; };

/// Cosine between the shading normal and the way back along the ray that came.
float cosine_of(vec3 normal, vec3 incoming) { return clamp(-exact_dot(normal, incoming), 0.0, 1.0); }

/// Writes the surface's weight and, where that is large enough, its ray, which leaves to the side that `side` points
/// to. `medium`: number of the Lobes whose solid it travels in, 0: none.
void store(uint i, vec3 weight, vec3 side, vec3 direction, float medium) {
  uint surface = first_surface + i;
  bool starts = worth_casting(weight) && !met_nothing(surface);
  weights[surface] = vec4(starts ? weight : vec3(0.0), medium);
  if (!starts) {
    store_none(i);
    return;
  }
  float endless = uintBitsToFloat(0x7F800000u);
  store_ray(i, offset_point(positions[surface].xyz, side, extent_at(surface)), direction, endless);
}

void store(uint i, vec3 weight, vec3 side, vec3 direction) { store(i, weight, side, direction, 0.0); }
