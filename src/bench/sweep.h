#pragma once
// How cost grows: the same picture with more triangles, more pixels or more lights.

#include <functional>
#include <string>
#include <vector>

#include "bench/report.h"

namespace crsh::bench {

enum class SweepAxis { triangles, pixels, lights };
inline const std::vector<std::string> sweep_names = {"triangles", "pixels", "lights"};

/// One size of a sweep.
struct SweepStep {
  double size = 0;              ///< triangles, pixels or lights
  std::vector<Result> results;  ///< of the variants that were run at this size
};

/// The scene with every triangle cut into n x n: the same surfaces, finer.
[[nodiscard]] scene::Scene subdivided(const scene::Scene& scene, uint32_t n);

/// Runs all variants but brute force at every size, those of one size in turn. A variant whose next size would need
/// more than `max_sweep_tests` a frame ends there.
[[nodiscard]] std::vector<SweepStep> sweep(SweepAxis axis, gpu::Device& device, const scene::Scene& scene,
                                           const std::vector<Variant>& variants, const Schedule& schedule,
                                           const Progress& progress);
inline constexpr double max_sweep_tests = 2e9;

/// Curves of tracing time, and every figure with the growth from the first size to the last.
[[nodiscard]] ChartSection sweep_section(SweepAxis axis, const std::string& scene, const std::vector<SweepStep>& steps);

}  // namespace crsh::bench
