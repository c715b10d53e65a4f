// Nodes of the raw tree, in which every leaf is one triangle; small subtrees become leaves later.

#include "shared/object.h"

struct RawNode {
  uint child[2];
  uint count[2];  // triangles of each child
  bool leaf;      // cheaper as one leaf than as a node
};

const uint raw_leaf_bit = 1u << 31;

RawNode raw_node_of(uvec4 words) {
  return RawNode(uint[2](words.x, words.y), uint[2](words.z, words.w & ~raw_leaf_bit), (words.w & raw_leaf_bit) != 0u);
}

uvec4 words_of(RawNode node) {
  return uvec4(node.child[0], node.child[1], node.count[0], node.count[1] | (node.leaf ? raw_leaf_bit : 0u));
}
