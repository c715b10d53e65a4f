#ifndef CRSH_LIB_OCTAHEDRAL_GLSL
#define CRSH_LIB_OCTAHEDRAL_GLSL
// Directions mapped to a square: they are projected on an octahedron, whose upper half is folded outwards. Straight
// down, where most lamps shine, is the middle of the square, so that the lower hemisphere has no seam.

/// A direction (of any length but 0) as a point of the unit square. No transcendental function, so that every shader
/// gets the same bits.
vec2 octahedral(vec3 direction) {
  precise float sum = (abs(direction.x) + abs(direction.y)) + abs(direction.z);
  precise float inverse = 1.0 / sum;
  precise vec2 lower = direction.xz * inverse;
  precise vec2 folded = 1.0 - abs(lower.yx);
  precise vec2 upper = vec2(lower.x < 0.0 ? -folded.x : folded.x, lower.y < 0.0 ? -folded.y : folded.y);
  precise vec2 square = (direction.y > 0.0 ? upper : lower) * 0.5 + 0.5;
  return square;
}

#endif
