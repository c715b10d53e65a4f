#pragma once
// The counters and times of a run, as `--stats` writes them (schema crsh-stats/1).

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "crsh/stage.h"

namespace crsh {

/// One level of nodes above the rays. tests = hits + misses.
struct LevelStatistics {
  uint32_t level = 1;
  uint64_t nodes = 0;
  double half_angle_sum = 0;  ///< radians, over nodes
  double radius_sum = 0;      ///< metres, over nodes
  uint64_t tests = 0, hits = 0;
  [[nodiscard]] uint64_t misses() const { return tests - hits; }
};

/// Rays of one kind and bounce, summed over all frames and samples.
struct RayStatistics {
  std::string kind;
  uint32_t bounce = 0;
  uint64_t count = 0, hits = 0, hits_digest = 0, chunks = 0;
  uint64_t triangles = 0;  ///< drawn: brute force is count × triangles
  uint64_t mesh_tests = 0, box_tests = 0;
  std::vector<LevelStatistics> levels;  ///< the top level first
  uint64_t triangle_tests = 0;
  uint64_t alpha_tests = 0;  ///< of triangles hit, how many were asked for their alpha (alphaMode MASK and BLEND)
  [[nodiscard]] uint64_t object_tests() const { return mesh_tests + box_tests; }
  [[nodiscard]] uint64_t paper_tests() const;  ///< Σ levels.tests + triangle_tests
  [[nodiscard]] uint64_t total_tests() const { return paper_tests() + object_tests(); }
};

struct FrameTime {
  double total_ms = 0;                         ///< wall clock of the frame, all samples
  std::array<double, stage_count> stage_ms{};  ///< GPU timestamps
  double pipeline_ms = 0;                      ///< making and compiling pipelines: in no stage, and 0 once all are made
};

/// What the object hierarchy took, where the algorithm has one.
struct ObjectHierarchyStatistics {
  uint64_t builds = 0, refits = 0;
  double sah_cost = 0;  ///< of the last frame: tests that the surface area heuristic expects of a ray
};

struct Statistics {
  uint64_t triangles = 0, meshes = 0, instances = 0, lights = 0;
  std::vector<RayStatistics> rays;  ///< by bounce, then kind
  ObjectHierarchyStatistics object_hierarchy;
  std::vector<FrameTime> frames;
  uint64_t device_peak_bytes = 0;
};

}  // namespace crsh
