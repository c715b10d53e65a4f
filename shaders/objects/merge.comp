#version 460
// Makes nodes of the raw tree of pairs of clusters, and moves the clusters that remain to their places in the next
// round. A node of few triangles becomes a leaf where the surface area heuristic finds that cheaper. Lane: a cluster.
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
layout(local_size_x = 64) in;
#include "lib/invocation.glsl"
#include "objects/clusters.glsl"
#include "objects/raw.glsl"

layout(push_constant, scalar) uniform Push {
  uint count;
  uint first_node;  // raw nodes of this round begin here
};
layout(binding = 0, scalar) readonly buffer Nearest { uint nearest[]; };
layout(binding = 1, scalar) readonly buffer Places { uint places[]; };  // in the next round: the scan of the flags
layout(binding = 2, scalar) readonly buffer Low { vec4 cluster_low[]; };
layout(binding = 3, scalar) readonly buffer High { vec4 cluster_high[]; };
layout(binding = 4, scalar) writeonly buffer NextLow { vec4 next_low[]; };
layout(binding = 5, scalar) writeonly buffer NextHigh { vec4 next_high[]; };
layout(binding = 6, scalar) writeonly buffer RawNodes { uvec4 raw_nodes[]; };
layout(binding = 7, scalar) buffer Costs { float costs[]; };  // a raw node: expected tests below it, times its area

Cluster load_cluster(uint i) { return cluster_of(cluster_low[i], cluster_high[i]); }

/// The cost of a triangle, or of a node as it was found when the node was made.
float cost_of(Cluster cluster) {
  bool triangle = (cluster.ref & child_is_leaf) != 0u;
  float below = costs[triangle ? 0u : cluster.ref];
  return triangle ? triangle_cost * half_area(cluster.box) : below;
}

Cluster made_node(Cluster a, Cluster b, uint index) {
  Cluster both = Cluster(merged(a.box, b.box), index, a.count + b.count);
  float area = half_area(both.box);
  float as_node = 2.0 * box_cost * area + (cost_of(a) + cost_of(b)), as_leaf = triangle_cost * float(both.count) * area;
  bool leaf = both.count <= max_leaf_triangles && as_leaf <= as_node;
  raw_nodes[index] = words_of(RawNode(uint[2](a.ref, b.ref), uint[2](a.count, b.count), leaf));
  costs[index] = leaf ? as_leaf : as_node;
  return both;
}

void main() {
  uint i = invocation_index();
  if (i >= count) return;
  uint other = nearest[i];
  bool mutual = other != i && nearest[other] == i;
  if (mutual && other < i) return;
  Cluster cluster = load_cluster(i);
  // The number of a pair in this round: how many clusters before its second one have disappeared.
  if (mutual) cluster = made_node(cluster, load_cluster(other), first_node + other - places[other]);
  next_low[places[i]] = low_of(cluster);
  next_high[places[i]] = high_of(cluster);
}
