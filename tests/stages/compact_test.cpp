// Compaction against a plain loop.

#include <doctest/doctest.h>

#include <vector>

#include "patterns.h"
#include "primitives/compact.h"
#include "primitives/grow.h"
#include "support/device.h"

using namespace crsh;
using namespace crsh::primitives;

namespace {

std::vector<uint32_t> twin(const std::vector<uint32_t>& flags) {
  std::vector<uint32_t> indices;
  for (uint32_t i = 0; i < flags.size(); ++i)
    if (flags[i]) indices.push_back(i);
  return indices;
}

std::vector<uint32_t> compacted(std::vector<uint32_t> flags, ScanShape shape) {
  gpu::Recorder recorder(test::device());
  CompactScratch scratch;
  gpu::Buffer indices;
  const uint32_t n = uint32_t(flags.size());
  flags.resize(quad_bytes(n) / 4, 1);  // what lies past the end must not count
  const gpu::Buffer buffer = gpu::upload(test::device(), flags, "flags");
  const uint32_t count = compact(recorder, scratch, buffer, n, indices, shape);
  return count ? recorder.read<uint32_t>(indices, count) : std::vector<uint32_t>{};
}

}  // namespace

TEST_CASE("a compaction lists the set flags in order, for every length and density") {
  for (const uint32_t n : test::lengths)
    for (const uint32_t one_in : {0u, 1u, 2u, 100u}) {
      std::vector<uint32_t> flags = test::numbers(test::Pattern::random, n, 32);
      for (uint32_t& flag : flags) flag = one_in > 0 && flag % one_in == 0;
      for (const ScanShape& shape : {scan_shape(test::device()), ScanShape{4, 64}, ScanShape{16, 64}}) {
        CAPTURE(n);
        CAPTURE(one_in);
        CAPTURE(shape.run);
        CHECK(compacted(flags, shape) == twin(flags));
      }
    }
}
