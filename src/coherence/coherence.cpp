#include "coherence/coherence.h"

#include "primitives/grow.h"

namespace crsh::coherence {
namespace {

void keep_creation_order(gpu::Recorder& recorder, uint32_t ray_count, const gpu::Buffer& order) {
  const uint32_t quads = (ray_count + 3) / 4;
  recorder.stage(Stage::ray_creation);
  recorder.dispatch("coherence/creation_order", quads, quads, {{"order", order}}, ray_count);
}

/// Compresses the pairs in scratch.pairs to chunks, sorts the chunks, and expands them to rays again.
void sort_compressed(gpu::Recorder& recorder, OrderScratch& scratch, const OrderIn& in, uint32_t key_bits, Order& out) {
  const uint32_t count = in.batch.count;
  Chunks& chunks = scratch.chunks;
  recorder.stage(Stage::ray_compression);
  compress(recorder, scratch.compress, scratch.pairs, count, chunks);
  out.chunks = count_chunks(recorder, scratch.compress, chunks, in.batch.segments);
  recorder.stage(Stage::ray_sorting);
  primitives::sort_values(recorder, scratch.sort, chunks.pairs, chunks.count, key_bits, scratch.sorted_chunks,
                          {.unstable = in.unstable});
  recorder.stage(Stage::ray_decompression);
  decompress(recorder, scratch.compress, chunks, scratch.sorted_chunks, count, out.order);
}

}  // namespace

void order(gpu::Recorder& recorder, OrderScratch& scratch, const OrderIn& in, Order& out) {
  const uint32_t count = in.batch.count;
  out.chunks.assign(in.batch.segments.size(), 0);
  out.as_created = !rays::any_sorted(in.batch, in.keys);
  primitives::grow(recorder, out.order, primitives::quad_bytes(count), "rays.order");
  if (out.as_created) return keep_creation_order(recorder, count, out.order);
  recorder.stage(Stage::ray_creation);
  const uint32_t key_bits = rays::hash(recorder, in.batch, in.keys, in.bounds, scratch.pairs);
  if (in.compression) return sort_compressed(recorder, scratch, in, key_bits, out);
  recorder.stage(Stage::ray_sorting);
  primitives::sort_values(recorder, scratch.sort, scratch.pairs, count, key_bits, out.order, {.unstable = in.unstable});
}

void gather(gpu::Recorder& recorder, const rays::Batch& batch, const Order& order, gpu::Buffer& sorted) {
  recorder.stage(Stage::ray_decompression);
  primitives::grow(recorder, sorted, uint64_t(batch.count) * 32, "rays.sorted");
  recorder.dispatch("coherence/gather", batch.count, batch.count,
                    {{"rays", batch.rays}, {"order", order.order}, {"sorted", sorted}}, batch.count);
}

}  // namespace crsh::coherence
