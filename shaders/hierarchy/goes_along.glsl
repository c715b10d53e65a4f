#ifndef CRSH_HIERARCHY_GOES_ALONG_GLSL
#define CRSH_HIERARCHY_GOES_ALONG_GLSL

#include "lib/exact.glsl"
#include "shared/ray.h"

/// Whether a cut node that begins with `first` may hold `ray`: their directions are in one octant and no farther apart
/// than `chord` on the unit sphere, and their origins no farther than `reach` (metres).
bool goes_along(Ray first, Ray ray, float chord, float reach) {
  bvec3 same_side = equal(lessThan(first.direction.xyz, vec3(0.0)), lessThan(ray.direction.xyz, vec3(0.0)));
  precise vec3 turned = ray.direction.xyz - first.direction.xyz;
  precise vec3 moved = ray.origin.xyz - first.origin.xyz;
  return all(same_side) && exact_length(turned) <= chord && exact_length(moved) <= reach;
}

#endif
