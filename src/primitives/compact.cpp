#include "primitives/compact.h"

#include "crsh/assertion.h"
#include "primitives/grow.h"

namespace crsh::primitives {
namespace {

/// As compact.comp declares it.
struct Push {
  uint32_t quads, lanes;
};

}  // namespace

uint32_t compact(gpu::Recorder& recorder, CompactScratch& scratch, const gpu::Buffer& flags, uint32_t n,
                 gpu::Buffer& indices) {
  return compact(recorder, scratch, flags, n, indices, scan_shape(recorder.device()));
}

uint32_t compact(gpu::Recorder& recorder, CompactScratch& scratch, const gpu::Buffer& flags, uint32_t n,
                 gpu::Buffer& indices, ScanShape shape) {
  CRSH_ASSERT(quad_bytes(n) <= recorder.device().limits().max_binding, "a compaction of more than one binding holds");
  CRSH_ASSERT(n == 0 || flags.bytes() >= quad_bytes(n), "a compaction past its buffer's end");
  if (n == 0) return 0;
  const uint32_t quads = (n + 3) / 4, lanes = (n + shape.run - 1) / shape.run;
  grow(recorder, scratch.counts, quad_bytes(lanes + 1), "compact.counts");
  if (n % 4) recorder.fill(flags, 0, 4 - n % 4, n);
  sum_runs(recorder, flags, n, scratch.counts, shape);
  scan(recorder, scratch.scan, scratch.counts, scratch.counts, lanes + 1, ScanType::exclusive, shape);
  const uint32_t total = recorder.read<uint32_t>(scratch.counts, 1, lanes)[0];
  grow(recorder, indices, quad_bytes(total), "compact.indices");
  const gpu::Kernel kernel("primitives/compact", {{0, shape.group}, {1, shape.run / 4}});
  recorder.dispatch(kernel, lanes, Push{quads, lanes},
                    {{"flags", flags}, {"before", scratch.counts}, {"indices", indices}}, n);
  return total;
}

}  // namespace crsh::primitives
