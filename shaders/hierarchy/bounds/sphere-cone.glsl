// Node bound "sphere-cone" (section 3.2.4): a sphere of the rays' origins and a cone of their directions.
//
// The spread is kept as the tangent of the half-angle, made from chords of the unit sphere: acos(dot) has a floor of
// 3.5e-4 rad in float. Every result is rounded outwards, so that no bound rejects a ray that hits. The includer
// defines CRSH_SORTED_RAYS where it provides `Ray sorted_ray(uint i)`.

#include "lib/exact.glsl"
#include "lib/triangle.glsl"
#include "shared/node.h"
#include "shared/ray.h"

#define BOUND Node
#define BOUND_OF_WORDS(word) Node(word(0), word(1))
layout(constant_id = 9) const uint bound_bytes = 32;
layout(constant_id = 10) const uint bound_merge_fits = 0;
layout(constant_id = 11) const bool cone_test_as_printed = false;  // --cone-test

/// Cones from about 89.9 degrees on count as wide: they reject nothing. Vulkan promises no infinities: a large number.
const float widest_tangent = 1e3;
const float wide = 1e30;
/// Directions are unit to about 2^-23; chords between them are widened by this.
const float direction_error = 4.76837158203125e-7;
/// Directions whose sum is shorter than this lie opposite one another: there is no axis between them.
const float least_sum = 1e-4;

float limited_tangent(float tangent) { return tangent <= widest_tangent ? tangent : wide; }

/// Tangent of the angle whose chord on the unit sphere is `chord`.
float tangent_of_chord(float chord) {
  precise float widened = chord * bound_slack + direction_error;
  precise float sine_of_half = 0.5 * widened;
  precise float squared = sine_of_half * sine_of_half;
  precise float cosine = 1.0 - 2.0 * squared;
  precise float sine = 2.0 * sine_of_half * sqrt(max(1.0 - squared, 0.0));
  precise float tangent = sine / cosine * bound_slack;
  return cosine > 0.0 ? limited_tangent(tangent) : wide;
}

/// Tangent of the sum of two angles given by their tangents.
float tangent_of_sum(float a, float b) {
  precise float rest = 1.0 - a * b;
  precise float tangent = (a + b) / rest * bound_slack;
  return rest > 0.0 && max(a, b) < wide ? limited_tangent(tangent) : wide;
}

float chord(vec3 a, vec3 b) {
  precise vec3 difference = a - b;
  return exact_length(difference);
}

/// Radius of a sphere of origins: what was measured, plus the room that ray-side rounding needs.
float padded_radius(float measured, vec3 centre) {
  precise float padded = measured * bound_slack + 4.0 * bound_pad * (largest(centre) + measured);
  return padded;
}

Node bound_of_ray(Ray ray) {
  return Node(vec4(ray.origin.xyz, padded_radius(0.0, ray.origin.xyz)), vec4(ray.direction.xyz, tangent_of_chord(0.0)));
}

/// Equations 7 and 8 as printed.
vec4 merged_spheres(vec4 a, vec4 b) {
  precise vec3 centre = (a.xyz + b.xyz) * 0.5;
  precise vec3 apart = b.xyz - a.xyz;
  precise float radius = exact_length(apart) * 0.5 + max(a.w, b.w);
  precise float error = bound_pad * largest(centre);  // of the rounded centre
  precise float outward = radius * bound_slack + (radius > max(a.w, b.w) ? error : 0.0);
  return vec4(centre, outward);
}

/// Equations 1 to 4: the cone widened just so far that it holds the direction r.
vec4 merged_cone_and_direction(vec4 cone, vec3 r) {
  vec3 x = cone.xyz;
  float to_ray = tangent_of_chord(chord(x, r));
  if (to_ray <= cone.w) return cone;
  precise float cosine = 1.0 / sqrt(1.0 + cone.w * cone.w);
  precise float sine = cone.w * cosine;
  precise vec3 across = x * exact_dot(x, r) - r;  // equation 1
  vec3 q = exact_normalize(across);
  precise vec3 e = x * cosine + q * sine;  // equation 2
  precise vec3 sum = e + r;
  vec3 axis = exact_normalize(sum);  // equation 3
  // Equation 4 gives the angle to r; near-parallel directions leave q to chance, so the old cone is asked as well.
  float to_new = tangent_of_chord(chord(axis, r));
  float to_old = tangent_of_sum(tangent_of_chord(chord(axis, x)), cone.w);
  bool hopeless = cone.w >= wide || largest(sum) < least_sum;
  return hopeless ? vec4(x, wide) : vec4(axis, max(to_new, to_old));
}

/// Equations 5 and 6 (the latter gives an angle, not its cosine). The half of the angle between the axes is measured
/// from the rounded axis: near-opposite axes do not cancel to its exact middle.
vec4 merged_cones(vec4 a, vec4 b) {
  precise vec3 sum = a.xyz + b.xyz;
  vec3 axis = exact_normalize(sum);
  float half_tangent = tangent_of_chord(max(chord(axis, a.xyz), chord(axis, b.xyz)));
  float between = largest(sum) < least_sum ? wide : half_tangent;
  return vec4(axis, tangent_of_sum(between, max(a.w, b.w)));
}

Node bound_merge_ray(Node node, Ray ray) {
  return Node(merged_spheres(node.sphere, vec4(ray.origin.xyz, padded_radius(0.0, ray.origin.xyz))),
              merged_cone_and_direction(node.cone, ray.direction.xyz));
}

Node bound_merge(Node a, Node b) { return Node(merged_spheres(a.sphere, b.sphere), merged_cones(a.cone, b.cone)); }

#ifdef CRSH_SORTED_RAYS
/// Fitted to rays first .. last-1: the middle of the origins' box and of the directions' box, then what reaches
/// farthest from them. Two loops of last - first each.
Node bound_fit(uint first, uint last) {
  vec3 low = vec3(wide), high = vec3(-wide), left = vec3(wide), right = vec3(-wide);
  for (uint i = first; i < last; ++i) {
    Ray ray = sorted_ray(i);
    low = min(low, ray.origin.xyz);
    high = max(high, ray.origin.xyz);
    left = min(left, ray.direction.xyz);
    right = max(right, ray.direction.xyz);
  }
  precise vec3 centre = (low + high) * 0.5;
  precise vec3 middle = left + right;
  vec3 axis = exact_normalize(middle);
  float radius = 0.0, widest = 0.0;
  for (uint i = first; i < last; ++i) {
    Ray ray = sorted_ray(i);
    radius = max(radius, chord(ray.origin.xyz, centre));
    widest = max(widest, chord(ray.direction.xyz, axis));
  }
  float tangent = largest(middle) < least_sum ? wide : tangent_of_chord(widest);
  return Node(vec4(centre, padded_radius(radius, centre)), vec4(axis, tangent));
}
#endif

/// Test-only mutation: the cone too narrow by a factor.
Node bound_narrowed(Node node, float scale) { return Node(node.sphere, vec4(node.cone.xyz, node.cone.w * scale)); }

/// Tangent of the half-angle (1e30: a right angle or wider) and radius, for the statistics.
vec2 bound_spread(Node node) { return vec2(node.cone.w, node.sphere.w); }

/// The node as a ball and a cone, for looking at it: that is what it is.
Node bound_outline(Node node) { return node; }

/// Equation 9 (Roger et al. 2007) on a sphere of objects or of one triangle; and nothing beyond the interval's far
/// end. As printed, |C - H| is a length, so that the cone opens backwards, too. Here it is negative behind the apex,
/// and what lies there is rejected; --cone-test printed drops the sign, which lets more through and never less. No
/// epsilon in scene units: the slack is relative to the distances at hand.
bool bound_may_hit_sphere(Node node, Interval interval, vec4 sphere, bool use_interval) {
  precise vec3 v = sphere.xyz - node.sphere.xyz;
  precise float reach = node.sphere.w + sphere.w;
  precise float along = exact_dot(v, node.cone.xyz);
  precise vec3 across = v - node.cone.xyz * along;
  precise float slack = 2.0 * bound_pad * (exact_length(v) + reach);
  precise float secant = sqrt(1.0 + node.cone.w * node.cone.w);
  precise float to_foot = cone_test_as_printed ? abs(along) : along;  // |C - H|
  precise float allowed = to_foot * node.cone.w + (reach + slack) * secant;
  bool bounded = node.cone.w < wide;
  bool outside = bounded && exact_length(across) > allowed;
  bool behind = bounded && !cone_test_as_printed && along + reach + slack < 0.0;
  bool beyond = use_interval && exact_length(v) - reach - slack > interval.far_end * bound_slack;
  return !(outside || behind || beyond);
}

/// The sphere around the box; no ray comes into it before `enter` (metres).
bool bound_may_hit_box(Node node, Interval interval, vec3 low, vec3 high, bool use_interval, out float enter) {
  precise vec3 centre = 0.5 * (low + high);
  precise float radius = max(chord(high, centre), chord(low, centre)) * bound_slack + bound_pad * largest(centre);
  float apart = chord(centre, node.sphere.xyz);
  precise float reach = (node.sphere.w + radius) * bound_slack;
  precise float nearest = apart - reach - 2.0 * bound_pad * (apart + reach);
  enter = max(nearest, 0.0);
  return bound_may_hit_sphere(node, interval, vec4(centre, radius), use_interval);
}
