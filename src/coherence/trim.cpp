#include "coherence/trim.h"

#include "primitives/grow.h"

namespace crsh::coherence {
namespace {

using primitives::grow;
using primitives::quad_bytes;

/// How many rays there are up to each segment's end: the inclusive scan of the head flags at its last slot.
std::vector<uint32_t> read_segment_ends(gpu::Recorder& recorder, TrimScratch& scratch, const rays::Batch& batch) {
  const size_t count = batch.segments.size();
  grow(recorder, scratch.segment_ends, count * 4, "trim.segment_ends");
  for (size_t i = 0; i < count; ++i)
    recorder.copy(batch.ends, ((i + 1) * batch.surfaces - 1) * 4, scratch.segment_ends, i * 4, 4);
  return recorder.read<uint32_t>(scratch.segment_ends, count);
}

/// Sets where each segment's rays lie, and how many there are in all.
void place_segments(rays::Batch& batch, const std::vector<uint32_t>& ends) {
  batch.count = 0;
  for (size_t i = 0; i < ends.size(); ++i) {
    batch.segments[i].first = batch.count;
    batch.segments[i].count = ends[i] - batch.count;
    batch.count = ends[i];
  }
}

}  // namespace

void trim(gpu::Recorder& recorder, TrimScratch& scratch, const gpu::Buffer& sparse_rays, const gpu::Buffer& flags,
          rays::Batch& out) {
  const uint32_t slot_count = uint32_t(out.segments.size()) * out.surfaces;
  recorder.stage(Stage::ray_creation);
  grow(recorder, out.ends, quad_bytes(slot_count), "rays.ends");
  if (slot_count > 0) {
    primitives::scan(recorder, scratch.scan, flags, out.ends, slot_count, primitives::ScanType::inclusive);
    place_segments(out, read_segment_ends(recorder, scratch, out));
  } else {
    place_segments(out, std::vector<uint32_t>(out.segments.size()));
  }
  grow(recorder, out.rays, uint64_t(out.count) * 32, "rays.rays");
  grow(recorder, out.slots, quad_bytes(out.count), "rays.slots");
  if (out.count > 0)
    recorder.dispatch(
        "coherence/trim", slot_count, slot_count,
        {{"sparse", sparse_rays}, {"flags", flags}, {"ends", out.ends}, {"rays", out.rays}, {"slots", out.slots}},
        slot_count);
}

}  // namespace crsh::coherence
