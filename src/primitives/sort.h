#pragma once
// A stable least-significant-digit radix sort of 32-bit keys with 32-bit values. Each lane walks a run of pairs of its
// own, one after the other, and has its own column of the histogram: it works with any subgroup size and waits for no
// other lane.

#include <cstdint>
#include <optional>

#include "primitives/scan.h"

namespace crsh::primitives {

/// How a sort is cut up. Software devices like few lanes and wide digits, GPUs many lanes and narrow digits.
struct SortShape {
  uint32_t digit_bits = 0;  ///< at most so many a pass; 1 to 13
  uint32_t run = 0;         ///< pairs that one lane walks, in one dispatch or several; a multiple of 4
  uint32_t group = 0;       ///< lanes of a workgroup
};
/// The shape that `n` pairs and `key_bits` bits are best sorted with on this kind of device.
[[nodiscard]] SortShape sort_shape(const gpu::Device& device, uint32_t n, uint32_t key_bits);

struct SortOptions {
  std::optional<SortShape> shape;  ///< none: sort_shape()
  bool unstable = false;           ///< test-only fault: equal keys change their order
};

/// What a sort needs besides its pairs, kept between calls.
struct SortScratch {
  gpu::Buffer pairs;      ///< where a pass writes; it then changes places with the buffer that was read
  gpu::Buffer histogram;  ///< a column a lane
  ScanScratch scan;
};

/// Bytes of `n` pairs, rounded up to the four that a lane loads together.
[[nodiscard]] constexpr uint64_t pair_bytes(uint32_t n) { return (uint64_t(n) + 3) / 4 * 32; }

/// Sorts `n` pairs, uvec2 (key, value), by the lowest `key_bits` (0 to 32) bits of their keys; the other bits must be 0
/// for the result to be sorted by whole keys. Pairs with equal keys keep their order. `pairs` holds the result; it may
/// have changed places with the scratch buffer, so that handles taken before are stale. It must have pair_bytes(n),
/// which must fit one binding; what lies past the n pairs is overwritten. (Section 3.2.3: radix sort.)
void sort_pairs(gpu::Recorder& recorder, SortScratch& scratch, gpu::Buffer& pairs, uint32_t n, uint32_t key_bits,
                const SortOptions& options = {});

/// The same where only the values are wanted: `values`, a uint each, grows to hold them; `pairs` then holds nothing of
/// use.
void sort_values(gpu::Recorder& recorder, SortScratch& scratch, gpu::Buffer& pairs, uint32_t n, uint32_t key_bits,
                 gpu::Buffer& values, const SortOptions& options = {});

}  // namespace crsh::primitives
