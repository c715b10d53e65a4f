#pragma once
// Secondary ray sorting (section 3.2.3): hash, compress, radix sort, decompress.

#include <cstdint>
#include <vector>

#include "coherence/compress.h"
#include "gpu/recorder.h"
#include "primitives/sort.h"
#include "rays/batch.h"
#include "rays/hash.h"

namespace crsh::coherence {

struct OrderIn {
  const rays::Batch& batch;
  const rays::Keys& keys;
  scene::Bounds bounds;     ///< of the scene, metres: where origins lie
  bool compression = true;  ///< sort chunks instead of rays; the order is the same
  bool unstable = false;    ///< test-only fault: equal keys change their order
};

/// The batch's rays sorted by key; rays of one key stay in creation order, and segments keep their places.
struct Order {
  gpu::Buffer order;             ///< uint a place: the ray, an index into Batch::rays
  std::vector<uint32_t> chunks;  ///< a segment: chunks that its rays were compressed to; 0 without compression
  bool as_created = false;       ///< no ray has a key: order[i] == i
};

/// What sorting needs besides, kept between calls.
struct OrderScratch {
  gpu::Buffer pairs, sorted_chunks;
  Chunks chunks;
  CompressScratch compress;
  primitives::SortScratch sort;
};

/// Sorts the rays of a batch. Hashing is timed as ray creation, as in the paper's Table 3; compression, sorting and
/// decompression as stages of their own. With compression it submits, and waits for the number of chunks.
void order(gpu::Recorder& recorder, OrderScratch& scratch, const OrderIn& in, Order& out);

/// sorted[i] = rays[order[i]], shared::Ray; `sorted` grows to hold them.
void gather(gpu::Recorder& recorder, const rays::Batch& batch, const Order& order, gpu::Buffer& sorted);

}  // namespace crsh::coherence
