#ifndef CRSH_SHARED_NODE_H
#define CRSH_SHARED_NODE_H
#include "shared/types.h"

CRSH_SHARED_BEGIN

/// A node of the ray hierarchy with the bound "sphere-cone": eight floats (section 3.2.4). Lengths are metres, and the
/// cone's width is the tangent of its half-angle, 1e30 for a right angle or wider, where the cone rejects nothing.
struct Node {
  vec4 sphere;  ///< xyz: centre of the sphere of origins, w: its radius, rounded outwards
  vec4 cone;    ///< xyz: unit axis, w: tangent of the half-angle, rounded outwards
};

/// A node with one of the bounds made of slabs: the padded ranges of its rays' origins and ends (metres), and those of
/// their unit directions. Where a ray has no end: -3e38 to 3e38.
struct Slab {
  vec4 origin_low;  ///< w: 0, here and below
  vec4 origin_high;
  vec4 direction_low;
  vec4 direction_high;
  vec4 end_low;
  vec4 end_high;
};

/// The distances at which a node's rays can hit, in an array beside the nodes. Metres.
struct Interval {
  float near_end;
  float far_end;
};

/// A candidate: a node of the level that is tested, and a triangle. The paper packs them into 18 + 14 bits; two words
/// hold more.
struct HitPair {
  uint node;
  uint triangle;
};

CRSH_SHARED_END
#endif
