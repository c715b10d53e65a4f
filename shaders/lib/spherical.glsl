#ifndef CRSH_LIB_SPHERICAL_GLSL
#define CRSH_LIB_SPHERICAL_GLSL
// Spherical coordinates (section 3.2.2). The arc tangent is written out, so that every driver gets the same bits.

/// Arc tangent of 0 to 1, in radians, within 2e-8 before rounding (Abramowitz and Stegun 4.4.49).
float exact_atan_unit(float x) {
  precise float square = x * x;
  precise float p = 0.0028662257;
  p = p * square - 0.0161657367;
  p = p * square + 0.0429096138;
  p = p * square - 0.0752896400;
  p = p * square + 0.1065626393;
  p = p * square - 0.1420889944;
  p = p * square + 0.1999355085;
  p = p * square - 0.3333314528;
  p = p * square + 1.0;
  precise float angle = p * x;
  return angle;
}

/// The angle of the point (x, y), -pi to pi radians.
float exact_atan(float y, float x) {
  precise float longer = max(abs(x), abs(y));
  precise float inverse = 1.0 / longer;
  precise float ratio = min(abs(x), abs(y)) * inverse;
  precise float angle = exact_atan_unit(ratio);
  precise float steep = 1.57079632679 - angle;
  angle = abs(y) > abs(x) ? steep : angle;
  precise float obtuse = 3.14159265359 - angle;
  angle = x < 0.0 ? obtuse : angle;
  return y < 0.0 ? -angle : angle;
}

/// A direction (of any length but 0) as (theta / pi, (phi + pi) / 2 pi), each 0 to 1; theta is the angle from the
/// upward axis, phi that around it.
vec2 spherical(vec3 direction) {
  precise float level_squared = direction.x * direction.x + direction.z * direction.z;
  precise float level = sqrt(level_squared);
  precise float theta = exact_atan(level, direction.y) * 0.318309886184;
  precise float phi = exact_atan(direction.z, direction.x) * 0.159154943092 + 0.5;
  return vec2(theta, phi);
}

#endif
