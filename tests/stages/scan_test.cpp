// Prefix sums against std::exclusive_scan and std::inclusive_scan.

#include <doctest/doctest.h>

#include <numeric>
#include <vector>

#include "patterns.h"
#include "primitives/grow.h"
#include "primitives/scan.h"
#include "support/device.h"

using namespace crsh;
using namespace crsh::primitives;

namespace {

std::vector<uint32_t> twin(const std::vector<uint32_t>& values, ScanType kind) {
  std::vector<uint32_t> sums(values.size());
  if (kind == ScanType::exclusive) std::exclusive_scan(values.begin(), values.end(), sums.begin(), 0u);
  else std::inclusive_scan(values.begin(), values.end(), sums.begin());
  return sums;
}

/// Uploads with room for whole quads, whose last words hold rubbish.
gpu::Buffer upload_quads(std::vector<uint32_t> values) {
  values.resize(quad_bytes(values.size()) / 4, 0xDEADBEEF);
  return gpu::upload(test::device(), values, "values");
}

std::vector<uint32_t> scanned(const std::vector<uint32_t>& values, ScanType kind, ScanShape shape, bool in_place) {
  gpu::Recorder recorder(test::device());
  ScanScratch scratch;
  const gpu::Buffer source = upload_quads(values), other = upload_quads(std::vector<uint32_t>(values.size()));
  const gpu::Buffer& destination = in_place ? source : other;
  scan(recorder, scratch, source, destination, values.size(), kind, shape);
  return recorder.read<uint32_t>(destination, values.size());
}

std::vector<ScanShape> shapes() { return {scan_shape(test::device()), {4, 64}, {16, 64}, {1024, 8}}; }

}  // namespace

TEST_CASE("a scan agrees with the standard library's for every length, kind, shape and in place") {
  for (const uint32_t n : test::lengths) {
    const std::vector<uint32_t> values = test::numbers(test::Pattern::random, n, 32);
    for (const ScanType kind : {ScanType::exclusive, ScanType::inclusive}) {
      const std::vector<uint32_t> expected = twin(values, kind);
      for (const ScanShape& shape : shapes())
        for (const bool in_place : {false, true}) {
          CAPTURE(n);
          CAPTURE(int(kind));
          CAPTURE(shape.run);
          CAPTURE(in_place);
          CHECK(scanned(values, kind, shape, in_place) == expected);
        }
    }
  }
}

TEST_CASE("an exclusive scan of one element more leaves the total there") {
  for (const uint32_t n : {1u, 7u, 8u, 257u, 65'537u}) {
    const std::vector<uint32_t> values(n, 3);
    gpu::Recorder recorder(test::device());
    ScanScratch scratch;
    std::vector<uint32_t> longer = values;
    longer.push_back(0xBADBAD);
    const gpu::Buffer buffer = upload_quads(longer);
    scan(recorder, scratch, buffer, buffer, n + 1, ScanType::exclusive);
    CAPTURE(n);
    CHECK(recorder.read<uint32_t>(buffer, 1, n)[0] == 3 * n);
  }
}

TEST_CASE("a scan's scratch serves longer and shorter arrays in turn, also within one submit") {
  gpu::Recorder recorder(test::device());
  ScanScratch scratch;
  std::vector<gpu::Buffer> buffers;
  const std::vector<uint32_t> sizes = {70'000, 3, 300'000, 1'000, 70'000};
  for (const uint32_t n : sizes) buffers.push_back(upload_quads(test::numbers(test::Pattern::random, n, 32, n)));
  for (size_t i = 0; i < sizes.size(); ++i)
    scan(recorder, scratch, buffers[i], buffers[i], sizes[i], ScanType::inclusive);
  for (size_t i = 0; i < sizes.size(); ++i) {
    const auto values = test::numbers(test::Pattern::random, sizes[i], 32, sizes[i]);
    CHECK(recorder.read<uint32_t>(buffers[i], sizes[i]) == twin(values, ScanType::inclusive));
  }
}

TEST_CASE("a scan of more elements than one binding holds is right across the border") {
  gpu::Recorder recorder(test::device());
  ScanScratch scratch;
  const uint64_t held = std::min<uint64_t>(test::device().limits().max_binding / 4, 1u << 25), n = held + 5;
  const gpu::Buffer buffer(test::device(), quad_bytes(n), "long");
  recorder.fill(buffer, 1, n);
  scan(recorder, scratch, buffer, buffer, n, ScanType::inclusive);
  const std::vector<uint32_t> border = recorder.read<uint32_t>(buffer, 10, n - 10);
  for (uint64_t i = 0; i < 10; ++i) CHECK(border[i] == n - 10 + i + 1);
}
