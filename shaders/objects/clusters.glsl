// The clusters of a build, in Morton order: what is not merged yet. A cluster is a triangle or a node of the raw tree,
// whose leaves are triangles, and whose nodes are numbered from n - 2 down to 0, the root.

#include "lib/box.glsl"
#include "shared/object.h"

struct Cluster {
  Box box;
  uint ref;    // child_is_leaf and a triangle, or a raw node
  uint count;  // triangles
};

Cluster cluster_of(vec4 low, vec4 high) {
  return Cluster(Box(low.xyz, high.xyz), floatBitsToUint(low.w), floatBitsToUint(high.w));
}

vec4 low_of(Cluster cluster) { return vec4(cluster.box.low, uintBitsToFloat(cluster.ref)); }

vec4 high_of(Cluster cluster) { return vec4(cluster.box.high, uintBitsToFloat(cluster.count)); }
