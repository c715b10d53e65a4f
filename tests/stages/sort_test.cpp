// The radix sort against std::stable_sort.

#include <doctest/doctest.h>

#include <algorithm>
#include <glm/glm.hpp>
#include <vector>

#include "patterns.h"
#include "primitives/sort.h"
#include "support/device.h"

using namespace crsh;
using namespace crsh::primitives;
using Pairs = std::vector<glm::uvec2>;

namespace {

/// Values are places, so that a permutation shows.
Pairs pairs_of(const std::vector<uint32_t>& keys) {
  Pairs pairs;
  for (uint32_t key : keys) pairs.emplace_back(key, uint32_t(pairs.size()));
  return pairs;
}

Pairs twin(Pairs pairs) {
  std::stable_sort(pairs.begin(), pairs.end(), [](glm::uvec2 a, glm::uvec2 b) { return a.x < b.x; });
  return pairs;
}

std::vector<uint32_t> values_of(const Pairs& pairs) {
  std::vector<uint32_t> values;
  for (glm::uvec2 pair : pairs) values.push_back(pair.y);
  return values;
}

/// With room for whole quads, whose last pairs are rubbish.
gpu::Buffer upload_pairs(Pairs pairs) {
  pairs.resize(pair_bytes(uint32_t(pairs.size())) / 8, {0, 0xDEADBEEF});
  return gpu::upload(test::device(), pairs, "pairs");
}

Pairs sorted_on_gpu(const Pairs& pairs, uint32_t key_bits, const SortOptions& options = {}) {
  gpu::Recorder recorder(test::device());
  SortScratch scratch;
  gpu::Buffer buffer = upload_pairs(pairs);
  sort_pairs(recorder, scratch, buffer, uint32_t(pairs.size()), key_bits, options);
  return recorder.read<glm::uvec2>(buffer, pairs.size());
}

std::vector<uint32_t> values_sorted_on_gpu(const Pairs& pairs, uint32_t key_bits, const SortOptions& options = {}) {
  gpu::Recorder recorder(test::device());
  SortScratch scratch;
  gpu::Buffer buffer = upload_pairs(pairs), values;
  sort_values(recorder, scratch, buffer, uint32_t(pairs.size()), key_bits, values, options);
  return recorder.read<uint32_t>(values, pairs.size());
}

/// What stability means, said without a reference: sorted by key, equal keys by where they came from.
bool stable(const Pairs& sorted) {
  return std::is_sorted(sorted.begin(), sorted.end(),
                        [](glm::uvec2 a, glm::uvec2 b) { return a.x < b.x || (a.x == b.x && a.y < b.y); });
}

/// The device's own shape and one for GPUs, which everything must be right for everywhere.
std::vector<SortOptions> shapes(uint32_t n, uint32_t key_bits) {
  return {{.shape = sort_shape(test::device(), n, key_bits)}, {.shape = SortShape{4, 64, 64}}};
}

}  // namespace

TEST_CASE("a sort agrees with std::stable_sort for every length and pattern") {
  for (const uint32_t n : test::lengths)
    for (const test::Pattern pattern : test::patterns) {
      const Pairs pairs = pairs_of(test::numbers(pattern, n, 32)), expected = twin(pairs);
      for (const SortOptions& options : shapes(n, 32)) {
        CAPTURE(n);
        CAPTURE(test::name_of(pattern));
        CAPTURE(options.shape->digit_bits);
        CHECK(sorted_on_gpu(pairs, 32, options) == expected);
        CHECK(values_sorted_on_gpu(pairs, 32, options) == values_of(expected));
      }
    }
}

TEST_CASE("a sort goes by as many bits as it is told") {
  for (uint32_t bits = 0; bits <= 32; ++bits) {
    const Pairs pairs = pairs_of(test::numbers(test::Pattern::random, 3'001, bits)), expected = twin(pairs);
    for (const SortOptions& options : shapes(3'001, bits)) {
      CAPTURE(bits);
      CAPTURE(options.shape->digit_bits);
      CHECK(sorted_on_gpu(pairs, bits, options) == expected);
      CHECK(values_sorted_on_gpu(pairs, bits, options) == values_of(expected));
    }
  }
}

TEST_CASE("digits as wide as they get are right") {
  const Pairs pairs = pairs_of(test::numbers(test::Pattern::random, 100'001, 26));
  CHECK(sort_shape(test::device(), 1u << 20, 26).digit_bits <= 13);
  CHECK(sorted_on_gpu(pairs, 26, {.shape = SortShape{13, 10'000, 8}}) == twin(pairs));
}

TEST_CASE("runs longer than one dispatch may loop over go on in the next") {
  const Pairs pairs = pairs_of(test::numbers(test::Pattern::random, 1'000'003, 16));
  CHECK(sorted_on_gpu(pairs, 16, {.shape = SortShape{8, 400'000, 8}}) == twin(pairs));
}

TEST_CASE("the stability check turns red when the sort is made unstable") {
  const Pairs pairs = pairs_of(test::numbers(test::Pattern::random, 65'537, 10));
  CHECK(stable(sorted_on_gpu(pairs, 10)));
  Pairs faulty = sorted_on_gpu(pairs, 10, {.shape = {}, .unstable = true});
  CHECK_FALSE(stable(faulty));
  CHECK_FALSE(values_sorted_on_gpu(pairs, 10, {.shape = {}, .unstable = true}) == values_of(twin(pairs)));
  std::sort(faulty.begin(), faulty.end(),
            [](glm::uvec2 a, glm::uvec2 b) { return a.x < b.x || (a.x == b.x && a.y < b.y); });
  CHECK(faulty == twin(pairs));  // a permutation it is all the same
}
