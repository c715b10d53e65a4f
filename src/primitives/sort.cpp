#include "primitives/sort.h"

#include <algorithm>
#include <utility>

#include "crsh/assertion.h"
#include "primitives/grow.h"

namespace crsh::primitives {
namespace {

/// As sort_pass.glsl declares it.
struct Push {
  uint32_t count, lanes, run, first, steps, shift, mask;
};

/// One pass over `n` pairs by `bits` bits from bit `shift` on.
struct Pass {
  uint32_t n, shift, bits;
  SortShape shape;
  bool unstable;

  [[nodiscard]] uint32_t lanes() const { return (n + shape.run - 1) / shape.run; }
  [[nodiscard]] uint64_t slots() const { return uint64_t(lanes()) << bits; }
};

/// Runs a kernel over the pass's lanes. Each dispatch takes only a part of every lane's run, because lavapipe 22.3 ends
/// an invocation's loops after 65,535 turns.
void dispatch_parts(gpu::Recorder& recorder, const gpu::Kernel& kernel, const Pass& pass,
                    std::initializer_list<gpu::Argument> arguments) {
  constexpr uint32_t steps = 131072;  // pairs a lane and dispatch: four of them are a turn of the loop
  for (uint32_t first = 0; first < pass.shape.run; first += steps) {
    const Push push{pass.n, pass.lanes(), pass.shape.run, first, steps, pass.shift, (1u << pass.bits) - 1};
    recorder.dispatch(kernel, pass.lanes(), push, arguments, uint64_t(pass.lanes()) * std::min(steps, pass.shape.run));
  }
}

/// Counts the digits and scans the counts: the histogram then says where each lane's next pair of each digit goes.
void find_places(gpu::Recorder& recorder, SortScratch& scratch, const gpu::Buffer& pairs, const Pass& pass) {
  grow(recorder, scratch.histogram, quad_bytes(pass.slots()), "sort.histogram");
  recorder.fill(scratch.histogram, 0, pass.slots());
  const gpu::Kernel count("primitives/sort_count", {{0, pass.shape.group}});
  dispatch_parts(recorder, count, pass, {{"pairs", pairs}, {"histogram", scratch.histogram}});
  scan(recorder, scratch.scan, scratch.histogram, scratch.histogram, pass.slots(), ScanType::exclusive);
}

/// Moves the pairs, or with `values_only` only their values, to their places in `sorted`.
void scatter(gpu::Recorder& recorder, SortScratch& scratch, const gpu::Buffer& pairs, const gpu::Buffer& sorted,
             bool values_only, const Pass& pass) {
  const gpu::Kernel kernel("primitives/sort_scatter", {{0, pass.shape.group}, {1, values_only}, {2, pass.unstable}});
  dispatch_parts(recorder, kernel, pass, {{"pairs", pairs}, {"places", scratch.histogram}, {"sorted", sorted}});
}

/// Fills the last quad with pairs whose bits are all set, so that they are sorted last. Returns how many pairs there
/// are now.
uint32_t pad(gpu::Recorder& recorder, const gpu::Buffer& pairs, uint32_t n) {
  const uint32_t padded = (n + 3) / 4 * 4;
  recorder.fill(pairs, UINT32_MAX, 2 * (padded - n), 2 * uint64_t(n));
  return padded;
}

/// All passes, lowest digit first, each with an even share of the bits. Where `values` is given, the last pass writes
/// only values, and there.
void sort(gpu::Recorder& recorder, SortScratch& scratch, gpu::Buffer& pairs, uint32_t n, uint32_t key_bits,
          const SortOptions& options, const gpu::Buffer* values) {
  CRSH_ASSERT(key_bits <= 32, "a sort by more than 32 bits");
  CRSH_ASSERT(pairs.bytes() >= pair_bytes(n), "a sort past its buffer's end");
  CRSH_ASSERT(pair_bytes(n) <= recorder.device().limits().max_binding, "a sort of more pairs than one binding holds");
  const SortShape shape = options.shape.value_or(sort_shape(recorder.device(), n, key_bits));
  const uint32_t wanted = (key_bits + shape.digit_bits - 1) / shape.digit_bits;
  const uint32_t passes = values ? std::max(wanted, 1u) : wanted;
  if (passes > (values ? 1u : 0u)) grow(recorder, scratch.pairs, pair_bytes(n), "sort.pairs");
  const uint32_t padded = pad(recorder, pairs, n);
  for (uint32_t i = 0; i < passes; ++i) {
    const uint32_t shift = key_bits * i / passes, end = key_bits * (i + 1) / passes;
    const Pass pass{padded, shift, end - shift, shape, options.unstable};
    const bool last = values && i + 1 == passes;
    find_places(recorder, scratch, pairs, pass);
    scatter(recorder, scratch, pairs, last ? *values : scratch.pairs, last, pass);
    if (!last) std::swap(pairs, scratch.pairs);
  }
}

/// The width of a digit, in bits, for which all passes together cost the least: a pair costs as much as four elements
/// of the histogram (measured on lavapipe).
uint32_t cheapest_digit(uint64_t n, uint32_t key_bits, uint32_t lanes) {
  constexpr uint32_t widest = 13;
  uint32_t best = 1;
  uint64_t best_cost = UINT64_MAX;
  for (uint32_t passes = std::max((key_bits + widest - 1) / widest, 1u); passes <= key_bits; ++passes) {
    const uint32_t digit = (key_bits + passes - 1) / passes;
    const uint64_t cost = passes * (4 * n + (uint64_t(lanes) << digit));
    if (cost < best_cost) best = digit, best_cost = cost;
  }
  return best;
}

}  // namespace

SortShape sort_shape(const gpu::Device& device, uint32_t n, uint32_t key_bits) {
  const gpu::Tuning& tuning = device.tuning();
  const auto [length, group] = tuning.sort_runs;
  const uint32_t lanes = tuning.sort_lanes;
  if (lanes == 0) return {tuning.sort_digit_bits, length, group};
  return {cheapest_digit(n, key_bits, lanes), n / (4 * lanes) * 4 + 4, group};
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
