#ifndef CRSH_LIB_TANGENT_GLSL
#define CRSH_LIB_TANGENT_GLSL
// Tangents in one word: a direction on an octahedron's two squares (15 bits each), the bitangent's sign, and one bit
// that says that there is a tangent. C++: scene::packed_tangent.

const float tangent_steps = 32767.0;

vec2 signs_of(vec2 v) { return mix(vec2(-1.0), vec2(1.0), greaterThanEqual(v, vec2(0.0))); }

/// `tangent`: xyz of any length, 0 for none; w: the bitangent's sign.
uint packed_tangent(vec4 tangent) {
  float sum = abs(tangent.x) + abs(tangent.y) + abs(tangent.z);
  if (!(sum > 0.0)) return 0u;
  vec3 d = tangent.xyz / sum;
  vec2 square = d.z >= 0.0 ? d.xy : (1.0 - abs(d.yx)) * signs_of(d.xy);
  uvec2 steps = uvec2(clamp(square * 0.5 + 0.5, 0.0, 1.0) * tangent_steps + 0.5);
  return 1u | (tangent.w < 0.0 ? 2u : 0u) | steps.x << 2 | steps.y << 17;
}

bool has_tangent(uint word) { return word != 0u; }

/// xyz: unit; w: the bitangent's sign.
vec4 unpacked_tangent(uint word) {
  vec2 square = vec2(float(word >> 2 & 0x7FFFu), float(word >> 17)) / tangent_steps * 2.0 - 1.0;
  float height = 1.0 - abs(square.x) - abs(square.y);
  vec2 across = height >= 0.0 ? square : (1.0 - abs(square.yx)) * signs_of(square);
  return vec4(normalize(vec3(across, height)), (word & 2u) != 0u ? -1.0 : 1.0);
}

#endif
