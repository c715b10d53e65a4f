#ifndef CRSH_LIB_OFFSET_GLSL
#define CRSH_LIB_OFFSET_GLSL
// Where rays leave a surface: a step off it. There is no other such measure; no hit is refused for being near.

#include "lib/exact.glsl"

/// Steps are shares of coordinates and no lengths in scene units, so that a scene may have any scale and lie anywhere.
/// This one is 2^-16 of the point's largest coordinate, 128 units in its last place: more than the rounding of
/// interpolated points.
const float offset_step = 1.52587890625e-5;
/// This one is 2^-20 of the largest coordinate of the triangle's corners and of the ray's other end: more than the
/// rounding of both, which matters where the point is much closer to the world's origin than they are.
const float offset_step_of_others = 9.5367431640625e-7;

/// No coordinate of the triangle with this smallest sphere is larger.
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

/// `direction`, mirrored at the geometric surface where it does not point to the side of `side`.
vec3 on_side(vec3 direction, vec3 side) {
  precise float height = exact_dot(direction, side);
  precise vec3 mirrored = direction - side * (2.0 * height);
  return height < 0.0 ? exact_normalize(mirrored) : direction;
}

#endif
