#pragma once
// The descent of section 3.2.5 in plain C++: node by node, depth first, with the nodes that the device built.

#include <cstdint>
#include <vector>

#include "support/cases_trace.h"

namespace crsh::test {

/// What the descent needs, read back from the device.
struct WalkIn {
  std::vector<std::vector<shared::Node>> nodes;  ///< a level
  std::vector<std::vector<shared::Interval>> intervals;
  std::vector<std::vector<glm::uvec2>> children;
  std::vector<glm::vec4> object_spheres, triangle_spheres;
  std::vector<glm::uvec4> blocks;
  bool interval = true, mesh_culling = true, cone_as_printed = false;
};

[[nodiscard]] WalkIn read_for_walk(gpu::Recorder& recorder, const hierarchy::Hierarchy& hierarchy,
                                   const scene::GpuScene& scene, const AlgorithmOptions& options);

struct LevelCounts {
  uint64_t tests = 0, hits = 0;
};

struct Walk {
  std::vector<shared::HitPair> pairs;  ///< level 1, node-major
  uint64_t mesh_tests = 0;
  std::vector<LevelCounts> levels;  ///< levels[0] is level 1
};

/// Nodes [first, end) of level `depth` downwards.
[[nodiscard]] Walk walk(const WalkIn& in, uint32_t depth, hierarchy::Range nodes);

}  // namespace crsh::test
