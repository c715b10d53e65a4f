#ifndef CRSH_LIB_TRIANGLE_GLSL
#define CRSH_LIB_TRIANGLE_GLSL
// What a hit is, which one function decides, and the triangle's own bounds.
//
// A hit is: the ray passes inside the triangle, 0 < t < tmax, AND the point at t lies in the triangle's box (by its
// slab interval) and in its smallest sphere (by its chord). Float arithmetic also accepts points beside slivers and at
// grazing incidence, which a correct bound would cull. With both bounds in the definition no culling test can disagree
// with brute force.

#include "lib/exact.glsl"

/// Bounds are padded by 2^-20 of the largest coordinate involved, 16 units in its last place. This covers the rounding
/// of t and of the bounds themselves, and is a 16th of the step that moves ray origins off surfaces.
const float bound_pad = 9.5367431640625e-7;
/// The factor by which a computed bound is rounded outwards.
const float bound_slack = 1.0 + 9.5367431640625e-7;

/// Centre and padded radius of the smallest sphere around a triangle (Ericson 2004): for obtuse and right triangles the
/// one around the longest edge, else the circumscribed one. The radius is measured from the rounded centre, so that the
/// sphere does hold the corners.
vec4 smallest_sphere(vec3 a, vec3 b, vec3 c) {
  precise vec3 ab = b - a;
  precise vec3 ac = c - a;
  precise vec3 bc = c - b;
  precise float at_a = exact_dot(ab, ac);
  precise float at_b = -exact_dot(ab, bc);
  precise float at_c = exact_dot(ac, bc);
  precise vec3 centre = (a + b) * 0.5;
  if (at_a <= 0.0) {
    precise vec3 middle = (b + c) * 0.5;
    centre = middle;
  } else if (at_b <= 0.0) {
    precise vec3 middle = (a + c) * 0.5;
    centre = middle;
  } else if (at_c > 0.0) {
    // Barycentric weights of the circumcentre: squared edge times cosine term.
    precise float wa = exact_dot(bc, bc) * at_a;
    precise float wb = exact_dot(ac, ac) * at_b;
    precise float wc = exact_dot(ab, ab) * at_c;
    precise float sum = (wa + wb) + wc;
    precise vec3 offset = (ab * wb + ac * wc) / sum;
    centre = sum > 0.0 ? a + offset : centre;
  }
  precise float radius = max(max(exact_length(a - centre), exact_length(b - centre)), exact_length(c - centre));
  precise float padded = radius * bound_slack + bound_pad * max(max(largest(a), largest(b)), largest(c));
  return vec4(centre, padded);
}

/// 1 / d with zero components replaced by 1e-30, so that slabs see no NaN.
vec3 safe_inverse(vec3 d) {
  precise vec3 clamped = mix(d, mix(vec3(1e-30), vec3(-1e-30), lessThan(d, vec3(0.0))), lessThan(abs(d), vec3(1e-30)));
  precise vec3 inverse = vec3(1.0) / clamped;
  return inverse;
}

/// Whether the point at t lies in the box: whether t is in the ray's slab interval.
bool inside_slabs(vec3 origin, vec3 direction, float t, vec3 low, vec3 high) {
  precise vec3 inverse = safe_inverse(direction);
  precise vec3 first = (low - origin) * inverse;
  precise vec3 second = (high - origin) * inverse;
  precise vec3 near3 = min(first, second);
  precise vec3 far3 = max(first, second);
  precise float enter = max(max(near3.x, near3.y), near3.z);
  precise float leave = min(min(far3.x, far3.y), far3.z);
  precise float widened = leave * bound_slack;
  precise float later = t * bound_slack;
  return enter <= later && t <= widened;
}

/// Whether the point at t lies in the sphere: whether t is in the ray's chord.
bool inside_chord(vec3 origin, vec3 direction, float t, vec3 centre, float radius) {
  precise vec3 to_centre = centre - origin;
  precise float squared = exact_dot(direction, direction);
  precise float middle = exact_dot(to_centre, direction) / squared;
  precise vec3 across = to_centre - direction * middle;
  precise float left = radius * radius - exact_dot(across, across);
  precise float half_chord = sqrt(max(left, 0.0) / squared) * bound_slack;
  precise float distance_to_middle = abs(t - middle);
  precise float reach = half_chord + bound_pad * abs(middle);
  return left >= 0.0 && distance_to_middle <= reach;
}

/// How a ray sees corners: axes are cyclically renamed so that the direction's largest component comes last, and the
/// others are sheared along it. Computed once a ray, because lavapipe moves nothing out of loops.
struct Shear {
  bool x_largest;
  bool y_largest;
  float depth;  // the direction's largest component
  vec2 slope;   // the others, for each unit of it
};

vec3 turned(vec3 v, Shear shear) { return shear.x_largest ? v.yzx : shear.y_largest ? v.zxy : v; }

Shear shear_of(vec3 direction) {
  vec3 size = abs(direction);
  Shear shear = Shear(size.x > size.y && size.x > size.z, size.y > size.z, 0.0, vec2(0.0));
  vec3 d = turned(direction, shear);
  precise vec2 slope = d.xy / d.z;
  return Shear(shear.x_largest, shear.y_largest, d.z, slope);
}

/// A corner as the ray sees it: z is its depth along the direction's largest component, x and y are sheared so that the
/// ray passes through (0, 0). Only the corner enters into this, so that all triangles around it get the same, rounding
/// included (Woop, Benthin and Wald, "Watertight Ray/Triangle Intersection", 2013).
vec3 seen_from(vec3 origin, Shear shear, vec3 corner) {
  precise vec3 from_origin = corner - origin;
  vec3 p = turned(from_origin, shear);
  precise vec2 flattened = p.xy - shear.slope * p.z;
  return vec3(flattened, p.z);
}

/// Unnormalised barycentric weights of three corners as the ray sees them: they have one sign where it passes inside.
/// The difference of two rounded products has the right sign or is 0, and two triangles get the same one but for the
/// sign for the edge they share. So no ray slips between the triangles around an edge or a corner.
vec3 edge_weights(vec3 a, vec3 b, vec3 c) {
  precise vec3 left = vec3(b.x * c.y, c.x * a.y, a.x * b.y);
  precise vec3 right = vec3(b.y * c.x, c.y * a.x, a.y * b.x);
  precise vec3 weights = left - right;
  return weights;
}

/// Whether the point at t lies in the triangle's own box and in its smallest sphere, each padded.
bool inside_bounds(vec3 origin, vec3 direction, float t, vec3 a, vec3 b, vec3 c) {
  vec4 sphere = smallest_sphere(a, b, c);
  float largest_origin = largest(origin);
  precise float pad = bound_pad * (max(max(largest(a), largest(b)), largest(c)) + largest_origin);
  precise vec3 low = min(min(a, b), c) - vec3(pad);
  precise vec3 high = max(max(a, b), c) + vec3(pad);
  precise float radius = sphere.w + bound_pad * largest_origin;
  return inside_slabs(origin, direction, t, low, high) && inside_chord(origin, direction, t, sphere.xyz, radius);
}

/// Whether the ray hits the triangle, at which t, and with which edge weights. `shear`: of the ray's direction.
/// `cull_back`: rays pass through the triangle's back.
bool hit_triangle(vec3 origin, vec3 direction, Shear shear, float tmax, vec3 a, vec3 b, vec3 c, bool cull_back,
                  out float t, out vec3 weights) {
  vec3 sa = seen_from(origin, shear, a), sb = seen_from(origin, shear, b), sc = seen_from(origin, shear, c);
  weights = edge_weights(sa, sb, sc);
  bool inside = all(greaterThanEqual(weights, vec3(0.0))) || all(lessThanEqual(weights, vec3(0.0)));

  // Depth is a weighted mean of the corners' depths, so that the point stays on the triangle at grazing incidence, too.
  precise float sum = (weights.x + weights.y) + weights.z;
  precise float towards = sum * shear.depth;  // negative: the ray meets the front
  precise float depth = (weights.x * sa.z + weights.y * sb.z) + weights.z * sc.z;
  precise float at = depth / towards;
  t = at;
  bool in_range = towards != 0.0 && at > 0.0 && at < tmax;  // 0: parallel to the ray, or without area
  bool faces = !(cull_back && towards > 0.0);

  bool hit = false;
  if (inside && in_range && faces) hit = inside_bounds(origin, direction, at, a, b, c);
  return hit;
}

/// Edge weights brought to a sum of 1 (a third each where the triangle has no area).
vec3 normalised(vec3 weights) {
  precise float sum = (weights.x + weights.y) + weights.z;
  precise vec3 result = sum != 0.0 ? weights / sum : vec3(1.0 / 3.0);
  return result;
}

/// Barycentric weights of a, b, c where the ray meets the triangle.
vec3 barycentrics(vec3 origin, vec3 direction, vec3 a, vec3 b, vec3 c) {
  Shear shear = shear_of(direction);
  return normalised(
      edge_weights(seen_from(origin, shear, a), seen_from(origin, shear, b), seen_from(origin, shear, c)));
}

#endif
