#include "primitives/sort.h"

#include <algorithm>
#include <utility>

#include "assertion.h"
#include "primitives/grow.h"

namespace crsh::primitives {
namespace {

/// As sort_pass.glsl declares it.
struct Push {
  uint32_t count, lanes, run, shift, mask;
};

/// One pass over `n` pairs by `bits` bits from bit `shift` on.
struct Pass {
  uint32_t n, shift, bits;
  SortShape shape;
  bool unstable;

  [[nodiscard]] uint32_t lanes() const { return (n + shape.run - 1) / shape.run; }
  [[nodiscard]] uint64_t slots() const { return uint64_t(lanes()) << bits; }
  [[nodiscard]] Push push() const { return {n, lanes(), shape.run, shift, (1u << bits) - 1}; }
};

/// Counts and scans: leaves in the histogram where each lane's next pair of each digit goes.
void find_places(gpu::Recorder& recorder, SortScratch& scratch, const gpu::Buffer& pairs, const Pass& pass) {
  grow(recorder, scratch.histogram, quad_bytes(pass.slots()), "sort.histogram");
  recorder.fill(scratch.histogram, 0, pass.slots());
  const gpu::Kernel count("primitives/sort_count", {{0, pass.shape.group}});
  recorder.dispatch(count, pass.lanes(), pass.push(), {pairs, scratch.histogram}, pass.n);
  scan(recorder, scratch.scan, scratch.histogram, scratch.histogram, pass.slots(), ScanKind::exclusive);
}

/// `sorted` gets pairs or, where `values_only`, values.
void scatter(gpu::Recorder& recorder, SortScratch& scratch, const gpu::Buffer& pairs, const gpu::Buffer& sorted,
             bool values_only, const Pass& pass) {
  const gpu::Kernel kernel("primitives/sort_scatter",
                           {{0, pass.shape.group}, {1, values_only}, {2, pass.unstable}});
  recorder.dispatch(kernel, pass.lanes(), pass.push(), {pairs, scratch.histogram, sorted}, pass.n);
}

/// All passes, lowest digits first, each with an even share of the bits. `values`: the last pass writes there.
void sort(gpu::Recorder& recorder, SortScratch& scratch, gpu::Buffer& pairs, uint32_t n, uint32_t key_bits,
          const SortOptions& options, const gpu::Buffer* values) {
  CRSH_ASSERT(key_bits <= 32, "a sort by more than 32 bits");
  CRSH_ASSERT(pairs.bytes() >= uint64_t(n) * 8, "a sort past its buffer's end");
  CRSH_ASSERT(uint64_t(n) * 8 <= recorder.device().limits().max_binding, "a sort of more pairs than one binding holds");
  const SortShape shape = options.shape.value_or(sort_shape(recorder.device(), n));
  const uint32_t wanted = (key_bits + shape.digit_bits - 1) / shape.digit_bits;
  const uint32_t passes = values ? std::max(wanted, 1u) : wanted;
  if (passes > (values ? 1u : 0u)) grow(recorder, scratch.pairs, std::max<uint64_t>(n, 2) * 8, "sort.pairs");
  for (uint32_t i = 0; i < passes; ++i) {
    const uint32_t shift = key_bits * i / passes, end = key_bits * (i + 1) / passes;
    const Pass pass{n, shift, end - shift, shape, options.unstable};
    const bool last = values && i + 1 == passes;
    find_places(recorder, scratch, pairs, pass);
    scatter(recorder, scratch, pairs, last ? *values : scratch.pairs, last, pass);
    if (!last) std::swap(pairs, scratch.pairs);
  }
}

}  // namespace

SortShape sort_shape(const gpu::Device& device, uint32_t n) {
  if (!device.info().software) return {4, 64, 64};
  constexpr uint32_t fewest_lanes = 32, longest_run = 32768;
  return {11, std::clamp((n + fewest_lanes - 1) / fewest_lanes, 1u, longest_run), 8};
}

void sort_pairs(gpu::Recorder& recorder, SortScratch& scratch, gpu::Buffer& pairs, uint32_t n, uint32_t key_bits,
                const SortOptions& options) {
  if (n > 1) sort(recorder, scratch, pairs, n, key_bits, options, nullptr);
}

void sort_values(gpu::Recorder& recorder, SortScratch& scratch, gpu::Buffer& pairs, uint32_t n, uint32_t key_bits,
                 gpu::Buffer& values, const SortOptions& options) {
  grow(recorder, values, quad_bytes(n), "sort.values");
  if (n > 0) sort(recorder, scratch, pairs, n, key_bits, options, &values);
}

}  // namespace crsh::primitives
