#ifndef CRSH_LIB_MINUS_LOG2_GLSL
#define CRSH_LIB_MINUS_LOG2_GLSL
// Transmittances, as -log2 in 16.16 fixed point a channel.

/// Nothing gets through.
const uint blocked = 0xFFFFFFFFu;

/// They are added up to `blocked` at most, so that the sum does not depend on the order of adding.
uvec3 saturating_sum(uvec3 a, uvec3 b) {
  uvec3 sum = a + b;
  return mix(sum, uvec3(blocked), lessThan(sum, a));
}

/// -log2 of what is let through, 0 to 1; `blocked` for 0. Written out, because log2() may round
/// otherwise in another shader: the exponent, and of the rest, from sqrt(1/2) to sqrt(2), the series of the area
/// hyperbolic tangent (off by less than 1e-8).
uint minus_log2(float through) {
  uint bits = floatBitsToUint(clamp(through, 0.0, 1.0));
  float mantissa = uintBitsToFloat((bits & 0x7FFFFFu) | 0x3F800000u);
  bool high = mantissa > 1.41421356;
  float exponent = float(int(bits >> 23) - (high ? 126 : 127));
  float rest = high ? mantissa * 0.5 : mantissa;
  precise float s = (rest - 1.0) / (rest + 1.0);
  precise float square = s * s;
  precise float series = s * (2.885390082 + square * (0.961796694 + square * (0.577078016 + square * 0.412198583)));
  precise float fixed_point = (exponent + series) * -65536.0 + 0.5;
  return through > 0.0 ? uint(max(fixed_point, 0.0)) : blocked;
}

/// What a sheet that is there to `alpha` lets through: all beside it, and of what meets it `tint`, RGB of 10 bits each.
uvec3 sheet_minus_log2(float alpha, uint tint) {
  vec3 share = vec3(float(tint & 1023u), float(tint >> 10 & 1023u), float(tint >> 20)) / 1023.0;
  precise vec3 through = vec3(1.0 - alpha) + share * alpha;
  return uvec3(minus_log2(through.x), minus_log2(through.y), minus_log2(through.z));
}

#endif
