// Ranges of origins, ends and directions, for bounds made of them. Minima and maxima are exact, so that merged and
// fitted bounds are the same. The includer defines CRSH_SORTED_RAYS where it provides `Ray sorted_ray(uint i)`.

#include "lib/exact.glsl"
#include "lib/triangle.glsl"
#include "shared/node.h"
#include "shared/ray.h"

#define BOUND Slab
#define BOUND_OF_WORDS(word) Slab(word(0), word(1), word(2), word(3), word(4), word(5))
layout(constant_id = 9) const uint bound_bytes = 96;
layout(constant_id = 10) const uint bound_merge_fits = 1;  // merging loses nothing

const float slab_wide = 3e38;
/// Longer rays count as endless: their ends would overflow, and make no difference.
const float slab_longest = 1e30;
/// The pad of lib/triangle.glsl's box, and half as much again for the rounding of both pads.
const float slab_pad = 1.5 * bound_pad;
/// A factor for the ends of intervals: they and a single ray's differ by the rounding of four operations.
const float slab_slack = 1.0 + 8.0 * bound_pad;

/// The box around the ray's end in which rounding may put its last hit; everything for a ray without end.
void slab_ends(Ray ray, out vec3 low, out vec3 high) {
  precise vec3 end = ray.origin.xyz + ray.direction.xyz * ray.origin.w;
  precise vec3 pad = vec3(slab_pad * largest(end) + 4.0 * bound_pad * ray.origin.w);
  precise vec3 padded_low = end - pad;
  precise vec3 padded_high = end + pad;
  bool endless = ray.origin.w > slab_longest;
  low = endless ? vec3(-slab_wide) : padded_low;
  high = endless ? vec3(slab_wide) : padded_high;
}

Slab bound_of_ray(Ray ray) {
  precise vec3 pad = vec3(slab_pad * largest(ray.origin.xyz));
  precise vec3 low = ray.origin.xyz - pad;
  precise vec3 high = ray.origin.xyz + pad;
  vec3 end_low, end_high;
  slab_ends(ray, end_low, end_high);
  return Slab(vec4(low, 0.0), vec4(high, 0.0), vec4(ray.direction.xyz, 0.0), vec4(ray.direction.xyz, 0.0),
              vec4(end_low, 0.0), vec4(end_high, 0.0));
}

Slab bound_merge(Slab a, Slab b) {
  return Slab(min(a.origin_low, b.origin_low), max(a.origin_high, b.origin_high), min(a.direction_low, b.direction_low),
              max(a.direction_high, b.direction_high), min(a.end_low, b.end_low), max(a.end_high, b.end_high));
}

Slab bound_merge_ray(Slab node, Ray ray) { return bound_merge(node, bound_of_ray(ray)); }

#ifdef CRSH_SORTED_RAYS
/// The ranges of rays first .. last-1.
Slab bound_fit(uint first, uint last) {
  Slab node = bound_of_ray(sorted_ray(first));
  for (uint i = first + 1u; i < last; ++i) node = bound_merge_ray(node, sorted_ray(i));
  return node;
}
#endif

/// Test-only mutation: every range of directions is narrower by a factor.
Slab bound_narrowed(Slab node, float scale) {
  vec4 middle = 0.5 * (node.direction_low + node.direction_high), half_range = node.direction_high - middle;
  return Slab(node.origin_low, node.origin_high, middle - half_range * scale, middle + half_range * scale, node.end_low,
              node.end_high);
}

/// For the statistics: tangent of the half-angle (3e38: a right angle) and radius of the ranges.
vec2 bound_spread(Slab node) {
  float radius = 0.5 * exact_length(node.origin_high.xyz - node.origin_low.xyz);
  float sine = min(0.5 * exact_length(node.direction_high.xyz - node.direction_low.xyz), 1.0);
  return vec2(sine < 1.0 ? sine / sqrt(1.0 - sine * sine) : slab_wide, radius);
}

/// Tangent of the angle between two directions, rounded outwards; 1e30 from a right angle on.
float slab_tangent_between(vec3 a, vec3 b) {
  precise float along = exact_dot(a, b) - slab_pad * exact_length(a) * exact_length(b);
  float across = exact_length(exact_cross(a, b));
  return along > 0.0 ? min(across / along * bound_slack + slab_pad, 1e30) : 1e30;
}

/// The ball around the box of origins, and the cone around the box of directions, for looking at the node.
Node bound_outline(Slab node) {
  precise vec3 centre = 0.5 * (node.origin_low.xyz + node.origin_high.xyz);
  precise float radius = exact_length(node.origin_high.xyz - centre) * bound_slack + slab_pad * largest(centre);
  vec3 low = node.direction_low.xyz, high = node.direction_high.xyz;
  precise vec3 middle = low + high;
  float tangent = 0.0;
  if (largest(middle) < 1e-6) return Node(vec4(centre, radius), vec4(0.0, 0.0, 1.0, 1e30));
  for (uint corner = 0u; corner < 8u; ++corner) {
    vec3 direction = mix(low, high, bvec3((corner & 1u) != 0u, (corner & 2u) != 0u, (corner & 4u) != 0u));
    tangent = max(tangent, slab_tangent_between(direction, middle));
  }
  return Node(vec4(centre, radius), vec4(exact_normalize(middle), tangent));
}

/// Whether the box reaches into what lies between the rays' origins and their ends.
bool slab_passes(Slab node, vec3 low, vec3 high) {
  return all(lessThanEqual(min(node.origin_low.xyz, node.end_low.xyz), high)) &&
         all(greaterThanEqual(max(node.origin_high.xyz, node.end_high.xyz), low));
}

/// Whether a ray of the node can be within low .. high: the slab test in interval arithmetic, which rejects no ray that
/// its own slab test would accept. On an axis the earliest ray enters at the least (low - origin) / direction, and the
/// latest leaves at the greatest. Where some rays go forward and others backward, or stand still, they may never leave.
/// No ray enters before `enter`.
bool bound_may_hit_box(Slab node, Interval interval, vec3 low, vec3 high, bool use_interval, out float enter) {
  vec3 inverse_low = safe_inverse(node.direction_low.xyz), inverse_high = safe_inverse(node.direction_high.xyz);
  bvec3 forward = greaterThanEqual(node.direction_high.xyz, vec3(0.0));
  bvec3 backward = lessThan(node.direction_low.xyz, vec3(0.0));
  precise vec3 ahead = low - node.origin_high.xyz;   // > 0: only rays that go forward come there
  precise vec3 behind = high - node.origin_low.xyz;  // < 0: only rays that go backward do
  precise vec3 quickest = ahead * inverse_high;      // all backward: when the slowest leaves
  precise vec3 slowest = behind * inverse_low;       // some backward: when the quickest of them enters
  vec3 enter3 = max(mix(vec3(0.0), quickest, greaterThan(ahead, vec3(0.0))),
                    mix(vec3(0.0), slowest, lessThan(behind, vec3(0.0))));
  vec3 leave3 = mix(slowest, mix(quickest, vec3(slab_wide), forward), backward);
  enter = max(max(enter3.x, enter3.y), enter3.z);
  float leave = min(min(leave3.x, leave3.y), leave3.z);
  precise float last = (use_interval ? min(leave, interval.far_end) : leave) * slab_slack;
  bvec3 towards = bvec3(forward.x || ahead.x <= 0.0, forward.y || ahead.y <= 0.0, forward.z || ahead.z <= 0.0);
  bvec3 back = bvec3(backward.x || behind.x >= 0.0, backward.y || behind.y >= 0.0, backward.z || behind.z >= 0.0);
  return all(towards) && all(back) && enter <= last && (!use_interval || slab_passes(node, low, high));
}

bool bound_may_hit_sphere(Slab node, Interval interval, vec4 sphere, bool use_interval) {
  precise vec3 low = sphere.xyz - vec3(sphere.w);
  precise vec3 high = sphere.xyz + vec3(sphere.w);
  precise vec3 pad = vec3(bound_pad * (largest(sphere.xyz) + sphere.w));
  precise vec3 padded_low = low - pad;
  precise vec3 padded_high = high + pad;
  float enter;
  return bound_may_hit_box(node, interval, padded_low, padded_high, use_interval, enter);
}

/// A triangle's own box, padded for its corners; the pad for the origins is in the node already.
void slab_box_of(vec3 a, vec3 b, vec3 c, out vec3 low, out vec3 high) {
  precise vec3 pad = vec3(slab_pad * max(max(largest(a), largest(b)), largest(c)));
  precise vec3 padded_low = min(min(a, b), c) - pad;
  precise vec3 padded_high = max(max(a, b), c) + pad;
  low = padded_low;
  high = padded_high;
}

bool slab_may_hit_corners_box(Slab node, Interval interval, vec3 a, vec3 b, vec3 c, bool use_interval) {
  vec3 low, high;
  slab_box_of(a, b, c, low, high);
  float enter;
  return bound_may_hit_box(node, interval, low, high, use_interval, enter);
}

/// A node prepared for many tests against boxes, as in a walk through the object hierarchy. On an axis rays enter a box
/// at its near plane: the earliest from the nearest origin, with the fastest direction. They leave at its far plane:
/// the latest from the farthest origin, with the slowest direction. Where some go forward and others backward, they may
/// enter at once and never leave.
struct PreparedSlab {
  bvec3 near_is_low;
  vec3 near_origin;
  vec3 near_inverse;
  vec3 far_origin;
  vec3 far_inverse;
  vec3 leave_late;  // 3e38 where rays may never leave
  vec3 low;         // of the box that holds all rays from origin to end
  vec3 high;
};

PreparedSlab slab_prepare(Slab node, bool use_interval) {
  vec3 inverse_low = safe_inverse(node.direction_low.xyz), inverse_high = safe_inverse(node.direction_high.xyz);
  bvec3 forward = greaterThanEqual(node.direction_low.xyz, vec3(0.0));
  bvec3 mixed = bvec3(uvec3(not(forward)) * uvec3(greaterThanEqual(node.direction_high.xyz, vec3(0.0))));
  return PreparedSlab(forward, mix(node.origin_low.xyz, node.origin_high.xyz, forward),
                      mix(mix(inverse_low, inverse_high, forward), vec3(0.0), mixed),
                      mix(node.origin_high.xyz, node.origin_low.xyz, forward), mix(inverse_high, inverse_low, forward),
                      mix(vec3(-slab_wide), vec3(slab_wide), mixed),
                      use_interval ? min(node.origin_low.xyz, node.end_low.xyz) : vec3(-slab_wide),
                      use_interval ? max(node.origin_high.xyz, node.end_high.xyz) : vec3(slab_wide));
}

/// Whether a ray of the node can be within low .. high before `reach`, and from which distance on.
bool slab_prepared_may_hit_box(PreparedSlab node, float reach, vec3 low, vec3 high, out float enter) {
  precise vec3 near3 = (mix(high, low, node.near_is_low) - node.near_origin) * node.near_inverse;
  precise vec3 far3 = (mix(low, high, node.near_is_low) - node.far_origin) * node.far_inverse;
  vec3 leave3 = max(far3, node.leave_late);
  enter = max(max(max(near3.x, near3.y), near3.z), 0.0);
  precise float last = min(min(min(leave3.x, leave3.y), leave3.z), reach) * slab_slack;
  return enter <= last && all(lessThanEqual(node.low, high)) && all(greaterThanEqual(node.high, low));
}

bool slab_prepared_may_hit_corners_box(PreparedSlab node, float reach, vec3 a, vec3 b, vec3 c, out float enter) {
  vec3 low, high;
  slab_box_of(a, b, c, low, high);
  return slab_prepared_may_hit_box(node, reach, low, high, enter);
}
