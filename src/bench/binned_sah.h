#pragma once
// A plain build of an object hierarchy to hold the device's against.

#include <array>
#include <glm/glm.hpp>
#include <vector>

#include "bench/paper_tables.h"
#include "bench/table.h"

namespace crsh::bench {

struct SahBox {
  glm::vec3 low{std::numeric_limits<float>::infinity()}, high{-std::numeric_limits<float>::infinity()};
  [[nodiscard]] double half_area() const;
  void include(const SahBox& other);
};

/// Expected tests of a ray that meets the root's box, of a top-down build over these boxes by the binned surface area
/// heuristic: 32 bins an axis, leaves of 4 triangles at most.
[[nodiscard]] double binned_sah_cost(std::vector<SahBox> boxes);

/// A box a drawn triangle, in the world.
[[nodiscard]] std::vector<SahBox> world_boxes(const scene::Scene& scene, const Variant& variant);

/// The SAH cost of the object hierarchies, and how it compares with `binned`, a cost a scene.
[[nodiscard]] Table sah_table(const std::vector<SceneResults>& scenes, const std::vector<double>& binned);

}  // namespace crsh::bench
