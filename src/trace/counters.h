#pragma once
// The counters on the GPU, a row each bounce and ray kind, and how they become statistics.

#include <cstdint>

#include "crsh/statistics.h"
#include "gpu/buffer.h"
#include "gpu/recorder.h"

namespace crsh::trace {

/// 64-bit counters in two words each (shaders/shared/counters.h).
class Counters {
 public:
  Counters(gpu::Device& device, uint32_t bounces);

  [[nodiscard]] const gpu::Buffer& buffer() const { return buffer_; }
  /// First counter of a bounce and kind.
  [[nodiscard]] static uint32_t row(uint32_t bounce, uint32_t kind);

  /// All zero again.
  void clear(gpu::Recorder& recorder) const;
  /// Adds what was counted since clear() to `statistics`, whose rows are by bounce, then kind. Submits and waits.
  void add_to(gpu::Recorder& recorder, Statistics& statistics) const;

 private:
  gpu::Buffer buffer_;
  uint32_t rows_ = 0;
};

/// Empty rows for every bounce and kind that `bounces` allows.
[[nodiscard]] std::vector<RayStatistics> empty_rows(uint32_t bounces, uint64_t triangles);

}  // namespace crsh::trace
