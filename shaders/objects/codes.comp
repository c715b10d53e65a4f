#version 460
// The Morton code of each triangle's centroid, 20 bits an axis, in two words of 30 bits. Triangles are sorted by the
// low word first, then by the high one with a stable sort. Lane: a pair (code, triangle).
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
layout(local_size_x = 64) in;
#include "lib/invocation.glsl"
#include "lib/morton.glsl"

layout(constant_id = 0) const bool high_word = false;  // false: writes the low word, and the triangle's number besides

layout(push_constant, scalar) uniform Push {
  vec3 low;       // corner of the cube that holds the centroids
  float inverse;  // 1 / its edge
  uint count;
};
layout(binding = 0, scalar) readonly buffer CornersA { vec4 corner_a[]; };
layout(binding = 1, scalar) readonly buffer CornersB { vec4 corner_b[]; };
layout(binding = 2, scalar) readonly buffer CornersC { vec4 corner_c[]; };
layout(binding = 3, scalar) buffer Pairs { uvec2 pairs[]; };

void main() {
  uint i = invocation_index();
  if (i >= count) return;
  uint triangle = high_word ? pairs[i].y : i;
  vec3 a = corner_a[triangle].xyz, b = corner_b[triangle].xyz, c = corner_c[triangle].xyz;
  vec3 middle = 0.5 * (min(min(a, b), c) + max(max(a, b), c));
  vec3 place = clamp((middle - low) * inverse, 0.0, 1.0);
  uvec3 cell = uvec3(min(place * 1048576.0, 1048575.0));
  pairs[i] = uvec2(morton(high_word ? cell >> 10 : cell & 1023u), triangle);
}
