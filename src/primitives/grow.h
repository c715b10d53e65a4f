#pragma once
// Scratch buffers that grow between submits.

#include <cstdint>
#include <string_view>

#include "gpu/recorder.h"

namespace crsh::primitives {

/// Makes `buffer` hold `bytes`; where it has to grow, what is recorded so far is submitted first and its old contents
/// are lost. Throws OutOfMemory.
inline void grow(gpu::Recorder& recorder, gpu::Buffer& buffer, uint64_t bytes, std::string_view name) {
  if (buffer.bytes() >= bytes && buffer.bytes() > 0) return;
  recorder.submit();
  buffer.reserve(recorder.device(), bytes > 16 ? bytes : 16, name);
}

/// Bytes of `count` 32-bit words, rounded up to whole quads, which the kernels read and write.
[[nodiscard]] constexpr uint64_t quad_bytes(uint64_t count) { return (count + 3) / 4 * 16; }

}  // namespace crsh::primitives
