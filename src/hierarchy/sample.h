#pragma once
// How coherent rays are in creation order, measured on a sample of them: it decides whether to make nodes of them.
// Counts decide, never times, so that the same frame is always traced in the same way.

#include <vector>

#include "crsh/options.h"
#include "gpu/recorder.h"
#include "rays/batch.h"

namespace crsh::hierarchy {

struct SampleIn {
  const rays::Batch& batch;
  const AlgorithmOptions& options;
  float extent;  ///< longest edge of the scene's bounds, metres
};

/// Rays that a cut node of level 1 would hold on average, by segment, if rays were bundled unsorted; infinite for
/// segments whose rays share their origin, or of no rays. `sums` is kept between calls. Submits, and waits.
[[nodiscard]] std::vector<float> rays_a_node(gpu::Recorder& recorder, const SampleIn& in, gpu::Buffer& sums);

}  // namespace crsh::hierarchy
