#pragma once
// The counters on the device, a row for each bounce and kind of rays, and how they become statistics.

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
  /// The first counter of a bounce and kind.
  [[nodiscard]] static uint32_t row(uint32_t bounce, uint32_t kind);

  /// Sets all counters to zero.
  void clear(gpu::Recorder& recorder) const;
  /// Adds what was counted since clear() to `statistics`, whose rows are by bounce, then kind. Submits and waits.
  void add_to(gpu::Recorder& recorder, Statistics& statistics) const;

 private:
  gpu::Buffer buffer_;
  uint32_t rows_ = 0;
};

/// Rows with zeros for every bounce and kind of rays that `bounces` allows.
[[nodiscard]] std::vector<RayStatistics> empty_rows(uint32_t bounces, uint64_t triangles);

}  // namespace crsh::trace
