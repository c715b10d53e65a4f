#pragma once
// A plain build of an object hierarchy on the host, to compare the device's with.

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

/// The SAH cost of a hierarchy built top down over these boxes by the binned surface area heuristic, with 32 bins an
/// axis and at most 4 triangles a leaf: the expected tests of a ray that meets the root's box.
[[nodiscard]] double binned_sah_cost(std::vector<SahBox> boxes);

/// The box of each drawn triangle, in world space.
[[nodiscard]] std::vector<SahBox> world_boxes(const scene::Scene& scene, const Variant& variant);

/// A table of the object hierarchies' SAH costs, and their ratios to `binned`, which has a cost for each scene.
[[nodiscard]] Table sah_table(const std::vector<SceneResults>& scenes, const std::vector<double>& binned);

}  // namespace crsh::bench
