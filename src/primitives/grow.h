#pragma once
// Scratch buffers that grow between submits.

#include <cstdint>
#include <string_view>

#include "gpu/recorder.h"

namespace crsh::primitives {

/// Makes `buffer` hold `bytes`. Where it has to grow, its old contents are lost, and what is recorded is submitted
/// first, because it may use the old buffer. Throws OutOfMemory.
inline void grow(gpu::Recorder& recorder, gpu::Buffer& buffer, uint64_t bytes, std::string_view name) {
  if (buffer.bytes() >= bytes && buffer.bytes() > 0) return;
  recorder.submit();
  buffer.reserve(recorder.device(), bytes > 16 ? bytes : 16, name);
}

/// Bytes of `count` 32-bit words, rounded up to a multiple of four words, a quad: kernels read and write whole quads.
[[nodiscard]] constexpr uint64_t quad_bytes(uint64_t count) { return (count + 3) / 4 * 16; }

}  // namespace crsh::primitives
