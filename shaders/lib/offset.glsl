#ifndef CRSH_LIB_OFFSET_GLSL
#define CRSH_LIB_OFFSET_GLSL
// Where rays leave a surface. The only step of its kind: no hit is refused for being near.

#include "lib/exact.glsl"

/// Shares of coordinates: no length in scene units, so that a scene may have any scale and lie anywhere.
/// 2^-16 of the point's largest, 128 units in its last place: above the rounding of interpolated points.
const float offset_step = 1.52587890625e-5;
/// 2^-20 of the largest of what else the arithmetic of a hit meets, its triangle's corners and the ray's other end:
/// above the rounding of both where the point is much closer to the world's origin than they are.
const float offset_step_of_others = 9.5367431640625e-7;

/// Bound of the coordinates of a triangle, from its smallest sphere.
float extent_of(vec4 sphere) {
  precise float extent = largest(sphere.xyz) + sphere.w;
  return extent;
}

/// `point` moved off its surface along the unit geometric normal `side`, to the side that it points to. `others`: the
/// largest coordinate of its triangle and of the ray's other end.
vec3 offset_point(vec3 point, vec3 side, float others) {
  precise float step = max(offset_step * largest(point), offset_step_of_others * others);
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
