#include "coherence/compress.h"

#include "primitives/grow.h"
#include "primitives/sort.h"

namespace crsh::coherence {
namespace {

using primitives::grow;
using primitives::quad_bytes;

struct CompressPush {
  uint32_t chunk_count, ray_count;
};
struct FindPush {
  uint32_t count, chunk_count;
};
struct DecompressPush {
  uint32_t ray_count, chunk_count;
};

}  // namespace

void compress(gpu::Recorder& recorder, CompressScratch& scratch, const gpu::Buffer& pairs, uint32_t ray_count,
              Chunks& out) {
  grow(recorder, scratch.flags, quad_bytes(ray_count), "compress.flags");
  recorder.dispatch("coherence/flag_heads", (uint64_t(ray_count) + 3) / 4, ray_count,
                    {{"pairs", pairs}, {"flags", scratch.flags}}, ray_count);
  out.count = primitives::compact(recorder, scratch.compact, scratch.flags, ray_count, out.bases);
  grow(recorder, out.pairs, primitives::pair_bytes(out.count), "chunks.pairs");
  grow(recorder, out.sizes, quad_bytes(out.count), "chunks.sizes");
  recorder.dispatch("coherence/compress", out.count, CompressPush{out.count, ray_count},
                    {{"pairs", pairs}, {"bases", out.bases}, {"chunks", out.pairs}, {"sizes", out.sizes}}, out.count);
}

std::vector<uint32_t> count_chunks(gpu::Recorder& recorder, CompressScratch& scratch, const Chunks& chunks,
                                   const std::vector<rays::Segment>& segments) {
  std::vector<uint32_t> counts(segments.size());
  std::vector<size_t> filled;  // segments with rays
  for (size_t i = 0; i < segments.size(); ++i)
    if (segments[i].count > 0) filled.push_back(i);
  if (filled.size() == 1) counts[filled[0]] = chunks.count;
  if (filled.size() <= 1) return counts;
  const uint32_t count = uint32_t(filled.size());
  grow(recorder, scratch.firsts, quad_bytes(count), "compress.firsts");
  for (uint32_t i = 0; i < count; ++i) recorder.fill(scratch.firsts, segments[filled[i]].first, 1, i);
  recorder.dispatch("coherence/find_chunks", count, FindPush{count, chunks.count},
                    {{"rising", chunks.bases}, {"firsts", scratch.firsts}});
  std::vector<uint32_t> firsts = recorder.read<uint32_t>(scratch.firsts, count);
  firsts.push_back(chunks.count);
  for (size_t i = 0; i < count; ++i) counts[filled[i]] = firsts[i + 1] - firsts[i];
  return counts;
}

void decompress(gpu::Recorder& recorder, CompressScratch& scratch, const Chunks& chunks, const gpu::Buffer& sorted,
                uint32_t ray_count, const gpu::Buffer& order) {
  if (ray_count == 0) return;
  grow(recorder, scratch.skeleton, quad_bytes(uint64_t(chunks.count) + 1), "compress.skeleton");
  grow(recorder, scratch.sorted_bases, quad_bytes(chunks.count), "compress.sorted_bases");
  recorder.dispatch("coherence/skeleton", chunks.count, chunks.count,
                    {{"sorted", sorted},
                     {"bases", chunks.bases},
                     {"sizes", chunks.sizes},
                     {"skeleton", scratch.skeleton},
                     {"sorted_bases", scratch.sorted_bases}},
                    chunks.count);
  primitives::scan(recorder, scratch.scan, scratch.skeleton, scratch.skeleton, uint64_t(chunks.count) + 1,
                   primitives::ScanType::exclusive);
  const gpu::Runs runs = recorder.device().tuning().fill_runs;
  recorder.dispatch(gpu::Kernel("coherence/decompress", {{0, runs.group}, {1, runs.length}}),
                    (uint64_t(ray_count) + runs.length - 1) / runs.length, DecompressPush{ray_count, chunks.count},
                    {{"rising", scratch.skeleton}, {"sorted_bases", scratch.sorted_bases}, {"order", order}},
                    ray_count);
}

}  // namespace crsh::coherence
