#include "primitives/scan.h"

#include <algorithm>

#include "crsh/assertion.h"
#include "primitives/grow.h"

namespace crsh::primitives {
namespace {

/// As the kernels of scan and compact declare it.
struct Push {
  uint32_t quads, lanes, first_lane;
};

uint64_t divide_up(uint64_t a, uint64_t b) { return (a + b - 1) / b; }

/// Lengths of all levels: the array, the sums of its runs, the sums of runs of these, and so on to a single run.
std::vector<uint64_t> level_lengths(uint64_t n, uint32_t run) {
  std::vector<uint64_t> lengths{n};
  while (lengths.back() > run) lengths.push_back(divide_up(lengths.back(), run));
  return lengths;
}

/// Makes room for the sums of every level but the array itself, with one element more for the total.
void reserve_sums(gpu::Recorder& recorder, ScanScratch& scratch, const std::vector<uint64_t>& lengths) {
  if (scratch.sums.size() + 1 < lengths.size()) scratch.sums.resize(lengths.size() - 1);
  for (size_t level = 1; level < lengths.size(); ++level)
    grow(recorder, scratch.sums[level - 1], quad_bytes(lengths[level] + 1), "scan.sums");
}

/// Calls body(first quad, push) for each part of an array of n elements that one binding can hold.
template <class Body>
void for_each_part(gpu::Recorder& recorder, uint64_t n, uint32_t run, const Body& body) {
  const uint64_t quads = divide_up(n, 4), run_quads = run / 4;
  const uint64_t part_lanes = recorder.device().limits().max_binding / 16 / run_quads / 64 * 64;
  for (uint64_t lane = 0; lane * run_quads < quads; lane += part_lanes) {
    const uint64_t part = std::min(part_lanes * run_quads, quads - lane * run_quads);
    body(lane * run_quads, Push{uint32_t(part), uint32_t(divide_up(part, run_quads)), uint32_t(lane)});
  }
}

gpu::Binding quads_of(const gpu::Buffer& buffer, uint64_t first, uint64_t count) {
  return {buffer, first * 16, count * 16};
}

/// Scans each run; `before` has the sums of all elements before each, and is null where the array is a single run.
void scan_runs(gpu::Recorder& recorder, const gpu::Buffer& source, const gpu::Buffer& destination, uint64_t n,
               const gpu::Buffer* before, ScanType type, ScanShape shape) {
  const gpu::Kernel kernel("primitives/scan_run",
                           {{0, shape.group}, {1, shape.run / 4}, {2, type == ScanType::inclusive}, {3, !before}});
  for_each_part(recorder, n, shape.run, [&](uint64_t first, const Push& push) {
    const gpu::Binding from = quads_of(source, first, push.quads), to = quads_of(destination, first, push.quads);
    recorder.dispatch(kernel, push.lanes, push,
                      {{"source", from}, {"destination", to}, {"before", before ? gpu::Binding(*before) : from}},
                      4 * uint64_t(push.quads));
  });
}

}  // namespace

void sum_runs(gpu::Recorder& recorder, const gpu::Buffer& source, uint64_t n, const gpu::Buffer& sums,
              ScanShape shape) {
  const gpu::Kernel kernel("primitives/scan_sum", {{0, shape.group}, {1, shape.run / 4}});
  for_each_part(recorder, n, shape.run, [&](uint64_t first, const Push& push) {
    recorder.dispatch(kernel, push.lanes, push, {{"source", quads_of(source, first, push.quads)}, {"sums", sums}},
                      4 * uint64_t(push.quads));
  });
}

ScanShape scan_shape(const gpu::Device& device) {
  return {device.tuning().scan_runs.length, device.tuning().scan_runs.group};
}

void scan(gpu::Recorder& recorder, ScanScratch& scratch, const gpu::Buffer& source, const gpu::Buffer& destination,
          uint64_t n, ScanType type) {
  scan(recorder, scratch, source, destination, n, type, scan_shape(recorder.device()));
}

void scan(gpu::Recorder& recorder, ScanScratch& scratch, const gpu::Buffer& source, const gpu::Buffer& destination,
          uint64_t n, ScanType type, ScanShape shape) {
  CRSH_ASSERT(n <= uint64_t(1) << 27, "a scan of more than 2^27 elements");
  CRSH_ASSERT(n == 0 || std::min(source.bytes(), destination.bytes()) >= quad_bytes(n), "a scan past its buffer's end");
  if (n == 0) return;
  const std::vector<uint64_t> lengths = level_lengths(n, shape.run);
  const size_t top = lengths.size() - 1;
  reserve_sums(recorder, scratch, lengths);
  const auto level = [&](size_t i) -> const gpu::Buffer& { return i ? scratch.sums[i - 1] : source; };
  for (size_t i = 0; i < top; ++i) sum_runs(recorder, level(i), lengths[i], level(i + 1), shape);
  for (size_t i = top; i > 0; --i)
    scan_runs(recorder, level(i), level(i), lengths[i], i < top ? &level(i + 1) : nullptr, ScanType::exclusive, shape);
  scan_runs(recorder, source, destination, n, top ? &level(1) : nullptr, type, shape);
}

}  // namespace crsh::primitives
