#ifndef CRSH_LIB_OFFSET_GLSL
#define CRSH_LIB_OFFSET_GLSL
// Where rays leave a surface. The only step of its kind: no hit is refused for being near.

#include "lib/exact.glsl"

/// 2^-16 of the largest coordinate: 128 units in its last place, above the rounding of hit points, and without a
/// length in scene units, so that a scene may have any scale and lie anywhere.
const float offset_step = 1.52587890625e-5;

/// `point` moved off its surface along the unit geometric normal `side`, to the side that it points to.
vec3 offset_point(vec3 point, vec3 side) {
  precise float step = offset_step * largest(point);
  precise vec3 moved = point + side * step;
  return moved;
}

/// `direction` on the side that `side` points to: what dips below is mirrored back about the geometric surface.
vec3 on_side(vec3 direction, vec3 side) {
  precise float height = exact_dot(direction, side);
  precise vec3 mirrored = direction - side * (2.0 * height);
  return height < 0.0 ? exact_normalize(mirrored) : direction;
}

#endif
