#pragma once
// The indices of the elements that are flagged.

#include <cstdint>

#include "primitives/scan.h"

namespace crsh::primitives {

/// What a compaction needs besides its arrays, kept between calls.
struct CompactScratch {
  gpu::Buffer counts;  ///< uint a run: how many flags are set, then the scan of that
  ScanScratch scan;
};

/// Writes the indices of all set flags, in rising order, to `indices`, which grows to hold them, and returns their
/// number: it submits and waits for that. `flags` is n <= 2^25 uints of 0 or 1, in a buffer of quad_bytes(n) bytes at
/// least; where n is no multiple of 4, the words up to the next multiple are set to 0. (Section 3.2.3: chunk bases.)
[[nodiscard]] uint32_t compact(gpu::Recorder& recorder, CompactScratch& scratch, const gpu::Buffer& flags, uint32_t n,
                               gpu::Buffer& indices);
[[nodiscard]] uint32_t compact(gpu::Recorder& recorder, CompactScratch& scratch, const gpu::Buffer& flags, uint32_t n,
                               gpu::Buffer& indices, ScanShape shape);

}  // namespace crsh::primitives
