#ifndef CRSH_SHARED_NODE_H
#define CRSH_SHARED_NODE_H
#include "shared/types.h"

CRSH_SHARED_BEGIN

/// A node of the ray hierarchy by the bound "sphere-cone": eight floats (section 3.2.4). Metres; the spread is the
/// tangent of the half-angle, 1e30 where the cone is a right angle or wider (then nothing is rejected by it).
struct Node {
  vec4 sphere;  ///< xyz: centre of the sphere of origins, w: its radius, rounded outwards
  vec4 cone;    ///< xyz: unit axis, w: tangent of the half-angle, rounded outwards
};

/// A node by the bounds made of slabs: the ranges of its rays' origins and ends, padded (metres), and of their unit
/// directions. Without end: -3e38 to 3e38.
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

/// A candidate: node (of the level at hand) and triangle. The paper packs 18 + 14 bits; two words lift that limit.
struct HitPair {
  uint node;
  uint triangle;
};

CRSH_SHARED_END
#endif
