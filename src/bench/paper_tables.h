#pragma once
// The paper's Tables 1, 2 and 3, with the names of its rows, and what was measured here.

#include <optional>
#include <string>
#include <vector>

#include "bench/measure.h"
#include "bench/table.h"
#include "crsh/kinds.h"

namespace crsh::bench {

/// All variants on one scene. Every scene of a run has the same variants, by their labels.
struct SceneResults {
  std::string name;  ///< "sponza"
  std::string path;  ///< as given
  std::vector<Result> results;
};

/// Which rays the tables count, a kind at a bounce or at all of them.
struct CountedRays {
  size_t kind = 0;
  std::optional<uint32_t> bounce;
};
/// An empty list means all rays.
using RayFilter = std::vector<CountedRays>;
[[nodiscard]] bool is_counted(const RayStatistics& rays, const RayFilter& filter);

/// The paper's name for a variant: "RAH Algorithm", "Our Algorithm (crsh arity=4)".
[[nodiscard]] std::string row_name(const Result& result);

/// Tests of a pass as the paper counts them and in per cent of brute force, and with everything counted.
[[nodiscard]] Table table_1(const std::vector<SceneResults>& scenes, const RayFilter& filter);
/// Tests, misses and hits for each kind of rays and level.
[[nodiscard]] Table table_2(const SceneResults& scene, const RayFilter& filter);
/// Median milliseconds of each stage, and how many times faster than the reference the two most costly ones are.
[[nodiscard]] Table table_3(const std::vector<SceneResults>& scenes);

/// Median milliseconds of a stage, or of the whole frame.
[[nodiscard]] double stage_median(const Result& result, Stage stage);
[[nodiscard]] double frame_median(const Result& result);
/// The median time of traversal and intersection together; below, of everything from ray creation to intersection.
[[nodiscard]] double tracing_median(const Result& result);
[[nodiscard]] double secondary_median(const Result& result);

/// Sums over the rays that are counted.
struct Sums {
  uint64_t rays = 0, brute_force = 0, paper = 0, total = 0;
};
[[nodiscard]] Sums sums_of(const Result& result, const RayFilter& filter);

}  // namespace crsh::bench
