// Trimming, compression, decompression and the whole order of a batch against plain C++.

#include <doctest/doctest.h>

#include <numeric>

#include "batches.h"
#include "coherence/coherence.h"
#include "coherence/trim.h"
#include "coherence_twin.h"
#include "keys_twin.h"
#include "patterns.h"
#include "primitives/grow.h"
#include "support/kinds.h"

using namespace crsh;
using namespace crsh::coherence;

namespace {

/// Pairs (key, place) with room for whole quads.
gpu::Buffer upload_keys(const std::vector<uint32_t>& keys) {
  std::vector<glm::uvec2> pairs(primitives::pair_bytes(uint32_t(keys.size())) / 8);
  for (uint32_t i = 0; i < keys.size(); ++i) pairs[i] = {keys[i], i};
  return gpu::upload(test::device(), pairs, "pairs");
}

/// Keys that change every `length` rays on average; 0: never.
std::vector<uint32_t> runs(uint32_t n, uint32_t length) {
  std::vector<uint32_t> keys = test::numbers(test::Pattern::random, n, 32), result(n, 77);
  for (uint32_t i = 1; i < n && length; ++i) result[i] = keys[i] % length ? result[i - 1] : keys[i] >> 20;
  return result;
}

/// Rays of three kinds and two lights, 9,000 a segment but for an empty one.
rays::Batch mixed_batch() {
  std::vector<shared::Ray> all;
  std::vector<rays::Segment> segments = {{0, 0, 0, 9'000}, {0, 1, 0, 9'000}, {1, 0, 0, 0}, {2, 0, 0, 9'000}};
  for (const rays::Segment& segment : segments) {
    std::vector<shared::Ray> rays = test::key_rays(segment.count, segment.kind, 5 + segment.light);
    for (size_t i = 1; i < rays.size(); ++i)
      if (i % 5) rays[i] = rays[i - 1];  // neighbours that share a key
    all.insert(all.end(), rays.begin(), rays.end());
  }
  return test::make_batch(all, segments);
}

std::vector<uint32_t> ordered(const rays::Batch& batch, const rays::Keys& keys, bool compression, Order& out,
                              bool unstable = false) {
  gpu::Recorder recorder(test::device());
  OrderScratch scratch;
  order(recorder, scratch, {batch, keys, test::unit_bounds(), compression, unstable}, out);
  return batch.count ? recorder.read<uint32_t>(out.order, batch.count) : std::vector<uint32_t>{};
}

/// The whole keys of a batch, as hash() makes them.
std::vector<uint32_t> whole_keys(const rays::Batch& batch, const rays::Keys& keys) {
  gpu::Recorder recorder(test::device());
  gpu::Buffer pairs;
  (void)rays::hash(recorder, batch, keys, test::unit_bounds(), pairs);
  std::vector<uint32_t> result;
  for (const glm::uvec2& pair : recorder.read<glm::uvec2>(pairs, batch.count)) result.push_back(pair.x);
  return result;
}

const rays::Keys mixed_keys = test::in_turn<std::string>({"hilbert", "spherical", "origin-direction"});

}  // namespace

TEST_CASE("trimming moves every ray to its place and remembers its slot") {
  for (const uint32_t surfaces : {1u, 7u, 256u, 40'001u})
    for (const uint32_t one_in : {0u, 1u, 2u, 50u}) {
      rays::Batch batch;
      batch.segments = {{0, 0}, {0, 1}, {1, 0}};
      batch.surfaces = surfaces;
      const uint32_t slots = 3 * surfaces;
      const std::vector<shared::Ray> sparse = test::key_rays(slots, 0);
      std::vector<uint32_t> flags = test::numbers(test::Pattern::random, slots, 32), expected;
      for (uint32_t s = 0; s < slots; ++s) {
        flags[s] = one_in && flags[s] % one_in == 0 && s / surfaces != 1;  // nothing in the middle segment
        if (flags[s]) expected.push_back(s);
      }
      std::vector<uint32_t> counts(3);
      for (uint32_t s : expected) ++counts[s / surfaces];
      flags.resize(primitives::quad_bytes(slots) / 4, 1);
      gpu::Recorder recorder(test::device());
      TrimScratch scratch;
      const gpu::Buffer from = gpu::upload(test::device(), sparse, "sparse"),
                        heads = gpu::upload(test::device(), flags, "flags");
      trim(recorder, scratch, from, heads, batch);
      recorder.submit();
      CAPTURE(surfaces);
      CAPTURE(one_in);
      REQUIRE(batch.count == expected.size());
      CHECK(recorder.read<uint32_t>(batch.slots, batch.count) == expected);
      uint32_t first = 0, wrong = 0;
      for (size_t i = 0; i < 3; first += counts[i++]) {
        CHECK(batch.segments[i].first == first);
        CHECK(batch.segments[i].count == counts[i]);
      }
      const std::vector<uint32_t> ends = recorder.read<uint32_t>(batch.ends, slots);
      const std::vector<shared::Ray> rays = recorder.read<shared::Ray>(batch.rays, batch.count);
      for (uint32_t i = 0; i < batch.count; ++i)
        wrong += rays[i].origin != sparse[expected[i]].origin || rays[i].direction != sparse[expected[i]].direction ||
                 ends[expected[i]] - 1 != i;
      CHECK(wrong == 0);
    }
}

TEST_CASE("compression finds the chunks and decompression undoes it, for every length and size of chunks") {
  for (const uint32_t n : test::lengths)
    for (const uint32_t length : {0u, 1u, 3u, 100u}) {
      const std::vector<uint32_t> keys = runs(n, length);
      const test::ChunksTwin expected = test::compress_twin(keys);
      gpu::Recorder recorder(test::device());
      CompressScratch scratch;
      Chunks chunks;
      const gpu::Buffer uploaded = upload_keys(keys);
      compress(recorder, scratch, uploaded, n, chunks);
      recorder.submit();
      CAPTURE(n);
      CAPTURE(length);
      REQUIRE(chunks.count == expected.keys.size());
      CHECK(recorder.read<uint32_t>(chunks.bases, chunks.count) == expected.bases);
      CHECK(recorder.read<uint32_t>(chunks.sizes, chunks.count) == expected.sizes);
      const std::vector<glm::uvec2> pairs = recorder.read<glm::uvec2>(chunks.pairs, chunks.count);
      for (uint32_t c = 0; c < chunks.count; ++c) REQUIRE(pairs[c] == glm::uvec2(expected.keys[c], c));
      const gpu::Buffer sorted = gpu::upload(test::device(), test::order_twin(expected.keys), "sorted");
      const gpu::Buffer order(test::device(), primitives::quad_bytes(n), "order");
      decompress(recorder, scratch, chunks, sorted, n, order);
      CHECK(recorder.read<uint32_t>(order, n) == test::order_twin(keys));
    }
}

TEST_CASE("a batch is sorted by kind, light and hash, stably, with and without compression") {
  const rays::Batch batch = mixed_batch();
  const std::vector<uint32_t> keys = whole_keys(batch, mixed_keys), expected = test::order_twin(keys);
  Order with, without;
  CHECK(ordered(batch, mixed_keys, true, with) == expected);
  CHECK(ordered(batch, mixed_keys, false, without) == expected);
  CHECK(without.chunks == std::vector<uint32_t>(4, 0));
  const test::ChunksTwin chunks = test::compress_twin(keys);
  REQUIRE(with.chunks.size() == 4);
  for (size_t s = 0; s < 4; ++s) {
    const rays::Segment& segment = batch.segments[s];
    const auto inside = [&](uint32_t base) { return base >= segment.first && base < segment.first + segment.count; };
    CHECK(with.chunks[s] == std::count_if(chunks.bases.begin(), chunks.bases.end(), inside));
    for (uint32_t i = segment.first; i < segment.first + segment.count; ++i) REQUIRE(inside(expected[i]));
  }
}

TEST_CASE("mixed and separate batches order each segment alike") {
  const rays::Batch batch = mixed_batch();
  gpu::Recorder recorder(test::device());
  const std::vector<shared::Ray> rays = recorder.read<shared::Ray>(batch.rays, batch.count);
  Order out;
  const std::vector<uint32_t> mixed = ordered(batch, mixed_keys, true, out);
  for (size_t s = 0; s < batch.segments.size(); ++s) {
    const rays::Segment segment = batch.segments[s];
    const auto first = rays.begin() + segment.first;
    const rays::Batch alone = test::make_batch({first, first + segment.count}, {segment});
    Order alone_out;
    std::vector<uint32_t> separate = ordered(alone, mixed_keys, true, alone_out);
    for (uint32_t& ray : separate) ray += segment.first;
    CHECK(std::equal(separate.begin(), separate.end(), mixed.begin() + segment.first));
    CHECK(alone_out.chunks[0] == out.chunks[s]);
  }
}

TEST_CASE("64 segments fit beside the widest key") {
  std::vector<rays::Segment> segments;
  for (uint32_t light = 0; light < 64; ++light) segments.push_back({0, light, 0, 10});
  const rays::Batch batch = test::make_batch(test::key_rays(640, 0), segments);
  const rays::Keys keys = test::in_turn<std::string>({"origin-direction", "", ""});
  Order out;
  CHECK(ordered(batch, keys, true, out) == test::order_twin(whole_keys(batch, keys)));
}

TEST_CASE("rays without a key keep the order of creation, alone and beside sorted ones") {
  const rays::Batch batch = mixed_batch();
  std::vector<uint32_t> created(batch.count);
  std::iota(created.begin(), created.end(), 0u);
  Order out;
  CHECK(ordered(batch, {"", "", ""}, true, out) == created);
  CHECK(out.as_created);
  CHECK(ordered(batch, {"creation", "", "hilbert"}, true, out) != created);
  CHECK_FALSE(out.as_created);
  const std::vector<uint32_t> some = ordered(batch, {"hilbert", "", ""}, true, out);
  const uint32_t last = batch.segments[3].first;
  CHECK(std::equal(some.begin() + last, some.end(), created.begin() + last));
  CHECK(out.chunks[3] == 1);
  CHECK(ordered(test::make_batch({shared::Ray{}}, {{0, 0, 0, 0}}), mixed_keys, true, out).empty());
}

TEST_CASE("gathering writes the rays in sorted order") {
  const rays::Batch batch = mixed_batch();
  Order out;
  const std::vector<uint32_t> expected = ordered(batch, mixed_keys, true, out);
  gpu::Recorder recorder(test::device());
  gpu::Buffer sorted;
  gather(recorder, batch, out, sorted);
  const std::vector<shared::Ray> before = recorder.read<shared::Ray>(batch.rays, batch.count),
                                 after = recorder.read<shared::Ray>(sorted, batch.count);
  uint32_t wrong = 0;
  for (uint32_t i = 0; i < batch.count; ++i)
    wrong += after[i].origin != before[expected[i]].origin || after[i].direction != before[expected[i]].direction;
  CHECK(wrong == 0);
}

TEST_CASE("the order's stability check turns red when the sort is made unstable") {
  const rays::Batch batch = mixed_batch();
  const rays::Keys keys("spherical");
  const std::vector<uint32_t> expected = test::order_twin(whole_keys(batch, keys));
  Order out;
  for (const bool compression : {true, false}) {
    CHECK(ordered(batch, keys, compression, out) == expected);
    CHECK_FALSE(ordered(batch, keys, compression, out, true) == expected);
  }
}
