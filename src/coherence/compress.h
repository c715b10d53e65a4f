#pragma once
// Compression of rays into chunks and back (section 3.2.3, Figures 5 and 6).

#include <cstdint>
#include <vector>

#include "primitives/compact.h"
#include "rays/batch.h"

namespace crsh::coherence {

/// Runs of rays, next to one another in creation order, that have the same key.
struct Chunks {
  gpu::Buffer pairs;  ///< uvec2 a chunk: key, chunk
  gpu::Buffer bases;  ///< uint a chunk: its first ray
  gpu::Buffer sizes;  ///< uint a chunk: its rays
  uint32_t count = 0;
};

/// What compression and decompression need besides, kept between calls.
struct CompressScratch {
  gpu::Buffer flags;         ///< of heads, a uint a ray
  gpu::Buffer firsts;        ///< a uint a segment
  gpu::Buffer skeleton;      ///< sizes of the sorted chunks, then their starts
  gpu::Buffer sorted_bases;  ///< bases of the sorted chunks
  primitives::CompactScratch compact;
  primitives::ScanScratch scan;
};

/// Compresses `ray_count` pairs, uvec2 (key, ray) with ray i at place i, into `out`: flags the rays where the key
/// changes, scans the flags, and makes key, base and size of each chunk from that. Submits, and waits for their number.
/// (Figure 5.)
void compress(gpu::Recorder& recorder, CompressScratch& scratch, const gpu::Buffer& pairs, uint32_t ray_count,
              Chunks& out);

/// How many chunks each segment has. Submits and waits where more than one segment has rays.
[[nodiscard]] std::vector<uint32_t> count_chunks(gpu::Recorder& recorder, CompressScratch& scratch,
                                                 const Chunks& chunks, const std::vector<rays::Segment>& segments);

/// Fills `order`, a uint for each of `ray_count` places, with the rays of the chunks in the order `sorted` (a uint a
/// place: the chunk). The paper's skeleton array holds the sizes of the sorted chunks; its exclusive scan says where
/// each begins. (Figure 6.)
void decompress(gpu::Recorder& recorder, CompressScratch& scratch, const Chunks& chunks, const gpu::Buffer& sorted,
                uint32_t ray_count, const gpu::Buffer& order);

}  // namespace crsh::coherence
