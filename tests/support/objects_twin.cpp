#include "support/objects_twin.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <bit>
#include <numeric>
#include <span>

#include "shared/object.h"

namespace crsh::test {
namespace {

using glm::vec3;
using shared::child_is_leaf;

constexpr float box_pad = 1.25f * 0x1p-20f;

float largest(const vec3& v) { return std::max(std::max(std::abs(v.x), std::abs(v.y)), std::abs(v.z)); }

/// A walk over a downloaded tree that looks at everything.
class Inspection {
 public:
  Inspection(const Tree& tree, const std::vector<Triangle>& triangles)
      : tree_(tree), triangles_(triangles), seen_(triangles.size(), false) {}

  std::string run() {
    const TreeBox root{vec3(tree_.root[0]), vec3(tree_.root[1])};
    const uint32_t count = inspect(0, root, 0, 1);
    if (count != triangles_.size()) fail("the root holds {} triangles of {}", count, triangles_.size());
    return fault_;
  }

 private:
  template <class... Values>
  void fail(fmt::format_string<Values...> text, Values&&... values) {
    if (fault_.empty()) fault_ = fmt::format(text, std::forward<Values>(values)...);
  }

  /// A node whose triangles begin at `first`; returns how many they are.
  uint32_t inspect(uint32_t node, const TreeBox& own, uint32_t first, uint32_t depth) {
    if (depth > shared::max_object_depth) fail("node {} is too deep", node);
    if (2 * node + 1 >= tree_.box_low.size()) fail("there is no node {}", node);
    if (!fault_.empty()) return 0;
    uint32_t sum = 0;
    for (const uint32_t slot : {2 * node, 2 * node + 1}) {
      const uint32_t ref = tree_.ref(slot), count = tree_.count(slot);
      const TreeBox box = tree_.box(slot);
      if (count && !own.holds(box)) fail("node {} sticks out of its parent's box", node);
      if (ref & child_is_leaf) inspect_leaf(slot, first + sum);
      else if (inspect(ref, box, first + sum, depth + 1) != count && fault_.empty())
        fail("slot {} does not hold {} triangles", slot, count);
      sum += count;
    }
    return sum;
  }

  void inspect_leaf(uint32_t slot, uint32_t first) {
    const uint32_t begin = tree_.ref(slot) & ~child_is_leaf, count = tree_.count(slot);
    if (count > shared::max_leaf_triangles) fail("a leaf of {} triangles", count);
    if (count && begin != first) fail("the leaf at {} does not follow its neighbour's end {}", begin, first);
    for (uint32_t i = begin; i < begin + count && fault_.empty(); ++i) inspect_triangle(i, tree_.box(slot));
  }

  void inspect_triangle(uint32_t place, const TreeBox& box) {
    const uint32_t id = std::bit_cast<uint32_t>(tree_.leaf_c[place].w);
    if (id >= triangles_.size()) return fail("there is no triangle {}", id);
    if (seen_[id]) fail("triangle {} stands twice", id);
    seen_[id] = true;
    const Triangle there{vec3(tree_.leaf_a[place]), vec3(tree_.leaf_b[place]), vec3(tree_.leaf_c[place])};
    if (there.a != triangles_[id].a || there.b != triangles_[id].b || there.c != triangles_[id].c)
      fail("triangle {} has other corners", id);
    if (!box.holds(padded_box(triangles_[id]))) fail("triangle {} sticks out of its leaf's box", id);
  }

  const Tree& tree_;
  const std::vector<Triangle>& triangles_;
  std::vector<bool> seen_;
  std::string fault_;
};

/// Σ of expected tests times half areas, below and with a node.
double cost_times_area(const Tree& tree, uint32_t node) {
  TreeBox whole;
  double below = 0;
  for (const uint32_t slot : {2 * node, 2 * node + 1}) {
    const uint32_t ref = tree.ref(slot), count = tree.count(slot);
    if (count == 0) continue;
    const TreeBox box = tree.box(slot);
    whole.include(box);
    below += ref & child_is_leaf ? shared::triangle_cost * count * box.half_area() : cost_times_area(tree, ref);
  }
  return 2.0 * shared::box_cost * whole.half_area() + below;
}

}  // namespace

bool TreeBox::holds(const TreeBox& inner) const {
  return glm::all(glm::lessThanEqual(low, inner.low)) && glm::all(glm::greaterThanEqual(high, inner.high));
}

double TreeBox::half_area() const {
  const glm::dvec3 size = glm::max(glm::dvec3(high) - glm::dvec3(low), glm::dvec3(0));
  return size.x * size.y + size.y * size.z + size.z * size.x;
}

void TreeBox::include(const TreeBox& other) {
  low = glm::min(low, other.low);
  high = glm::max(high, other.high);
}

TreeBox padded_box(const Triangle& triangle) {
  const auto& [a, b, c] = triangle;
  const float pad = box_pad * std::max(std::max(largest(a), largest(b)), largest(c));
  return {glm::min(glm::min(a, b), c) - pad, glm::max(glm::max(a, b), c) + pad};
}

uint32_t Tree::ref(uint32_t slot) const { return std::bit_cast<uint32_t>(box_low[slot].w); }
uint32_t Tree::count(uint32_t slot) const { return std::bit_cast<uint32_t>(box_high[slot].w); }
TreeBox Tree::box(uint32_t slot) const { return {vec3(box_low[slot]), vec3(box_high[slot])}; }

Tree tree_of(gpu::Recorder& recorder, const objects::Hierarchy& h) {
  Tree tree;
  tree.box_low = recorder.read<glm::vec4>(h.box_low, 2 * h.node_count);
  tree.box_high = recorder.read<glm::vec4>(h.box_high, 2 * h.node_count);
  tree.leaf_a = recorder.read<glm::vec4>(h.leaf_a, h.triangle_count);
  tree.leaf_b = recorder.read<glm::vec4>(h.leaf_b, h.triangle_count);
  tree.leaf_c = recorder.read<glm::vec4>(h.leaf_c, h.triangle_count);
  tree.root = recorder.read<glm::vec4>(h.root, 2);
  return tree;
}

std::string fault_of(const Tree& tree, const std::vector<Triangle>& triangles) {
  return Inspection(tree, triangles).run();
}

double sah_cost(const Tree& tree) {
  const TreeBox root{vec3(tree.root[0]), vec3(tree.root[1])};
  const double area = root.half_area();
  return area > 0 ? cost_times_area(tree, 0) / area : 0;
}

}  // namespace crsh::test
