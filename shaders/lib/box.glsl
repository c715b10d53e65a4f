#ifndef CRSH_LIB_BOX_GLSL
#define CRSH_LIB_BOX_GLSL
// Boxes of the object hierarchy. A box test never rejects a hit (lib/triangle.glsl, inside_slabs): it computes the same
// slabs in the same order, from a box that holds the triangle's own padded box, and rounding keeps the order of
// numbers.

#include "lib/exact.glsl"
#include "lib/triangle.glsl"

/// The pad, as a share of the largest coordinate. It comes in two parts: that of the corners when a box is built, and
/// that of the ray's origin when it is tested. Both are rounded, and so it is a quarter larger than `bound_pad`.
const float box_pad = 1.25 * bound_pad;
const float box_slack = 1.0 + 2.0 * bound_pad;

struct Box {
  vec3 low;
  vec3 high;
};

/// A box that holds nothing: merging with it changes nothing.
Box empty_box() {
  float infinity = uintBitsToFloat(0x7F800000u);
  return Box(vec3(infinity), vec3(-infinity));
}

/// The box around a triangle, padded for its corners.
Box box_of(vec3 a, vec3 b, vec3 c) {
  precise float pad = box_pad * max(max(largest(a), largest(b)), largest(c));
  precise vec3 low = min(min(a, b), c) - vec3(pad);
  precise vec3 high = max(max(a, b), c) + vec3(pad);
  return Box(low, high);
}

Box merged(Box a, Box b) { return Box(min(a.low, b.low), max(a.high, b.high)); }

/// Half of the box's surface; 0 for an empty box.
float half_area(Box box) {
  precise vec3 size = max(box.high - box.low, vec3(0.0));
  precise float xy = size.x * size.y;
  precise float yz = size.y * size.z;
  precise float zx = size.z * size.x;
  precise float sum = (xy + yz) + zx;
  return sum;
}

/// A ray prepared for tests against boxes: the origin is moved by its pad both ways, which is as if boxes were larger
/// by it.
struct BoxRay {
  vec3 for_low;
  vec3 for_high;
  vec3 inverse;
};

BoxRay box_ray(vec3 origin, vec3 direction) {
  precise float pad = box_pad * largest(origin);
  precise vec3 for_low = origin + vec3(pad);
  precise vec3 for_high = origin - vec3(pad);
  return BoxRay(for_low, for_high, safe_inverse(direction));
}

/// Whether the ray may hit something in the box at 0 < t <= tmax, and the t at which it enters (below 0: it starts
/// inside).
bool may_hit_box(BoxRay ray, float tmax, vec3 low, vec3 high, out float enter) {
  precise vec3 first = (low - ray.for_low) * ray.inverse;
  precise vec3 second = (high - ray.for_high) * ray.inverse;
  precise vec3 near3 = min(first, second);
  precise vec3 far3 = max(first, second);
  precise float nearest = max(max(near3.x, near3.y), near3.z);
  precise float farthest = min(min(min(far3.x, far3.y), far3.z), tmax);
  precise float reach = farthest * box_slack;
  enter = nearest;
  return nearest <= reach && farthest >= 0.0;
}

#endif
