#pragma once
// Prefix sums of arrays of any length. Each lane adds up a run of elements of its own, one after the other, so that
// nothing depends on the subgroup's size. The sums of the runs are scanned in the same way, level by level.

#include <cstdint>
#include <vector>

#include "gpu/recorder.h"

namespace crsh::primitives {

/// How a scan is cut up. Software devices like long runs in small workgroups, GPUs many lanes.
struct ScanShape {
  uint32_t run = 0;    ///< elements that one lane walks; a multiple of 4
  uint32_t group = 0;  ///< lanes of a workgroup
};
[[nodiscard]] ScanShape scan_shape(const gpu::Device& device);

/// What a scan needs besides its arrays, kept between calls: for each level the sums of its runs.
struct ScanScratch {
  std::vector<gpu::Buffer> sums;
};

enum class ScanType { exclusive, inclusive };

/// destination[i] = sum of source[0 .. i) (exclusive) or source[0 .. i] (inclusive), modulo 2^32, for i < n <= 2^27.
/// Both are buffers of uint, may be the same one, and hold quad_bytes(n) bytes at least: the words from n up to the
/// next multiple of 4 are read and overwritten. An exclusive scan of n + 1 elements leaves the total of the first n in
/// element n, whatever the source holds there. (Section 3.2.2: the scan operator.)
void scan(gpu::Recorder& recorder, ScanScratch& scratch, const gpu::Buffer& source, const gpu::Buffer& destination,
          uint64_t n, ScanType type);
void scan(gpu::Recorder& recorder, ScanScratch& scratch, const gpu::Buffer& source, const gpu::Buffer& destination,
          uint64_t n, ScanType type, ScanShape shape);

/// sums[i] = sum of elements i * run up to (i + 1) * run of `source`: the upward half of a scan. Sizes as in scan().
void sum_runs(gpu::Recorder& recorder, const gpu::Buffer& source, uint64_t n, const gpu::Buffer& sums, ScanShape shape);

}  // namespace crsh::primitives
