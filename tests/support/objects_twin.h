#pragma once
// Trees of boxes as the device made them, and a plain build to hold them against.

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "gpu/recorder.h"
#include "objects/hierarchy.h"
#include "support/twin.h"

namespace crsh::test {

struct TreeBox {
  glm::vec3 low{std::numeric_limits<float>::infinity()}, high{-std::numeric_limits<float>::infinity()};
  [[nodiscard]] bool holds(const TreeBox& inner) const;
  [[nodiscard]] double half_area() const;
  void include(const TreeBox& other);
};

/// The box around a triangle as shaders/lib/box.glsl has it.
[[nodiscard]] TreeBox padded_box(const Triangle& triangle);

/// An object hierarchy, downloaded.
struct Tree {
  std::vector<glm::vec4> box_low, box_high, leaf_a, leaf_b, leaf_c, root;
  [[nodiscard]] uint32_t ref(uint32_t slot) const;
  [[nodiscard]] uint32_t count(uint32_t slot) const;  ///< triangles
  [[nodiscard]] TreeBox box(uint32_t slot) const;
  [[nodiscard]] bool operator==(const Tree&) const = default;
};
[[nodiscard]] Tree tree_of(gpu::Recorder& recorder, const objects::Hierarchy& hierarchy);

/// What is wrong with the tree over these triangles; empty: nothing.
[[nodiscard]] std::string fault_of(const Tree& tree, const std::vector<Triangle>& triangles);

/// Expected tests of a ray that meets the root: the surface area heuristic.
[[nodiscard]] double sah_cost(const Tree& tree);

}  // namespace crsh::test
