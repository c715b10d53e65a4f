// Tests by ray and by node, shared out to pixels, against exact fractions.

#include <doctest/doctest.h>

#include <bit>
#include <cmath>
#include <numeric>

#include "hierarchy/account.h"
#include "primitives/grow.h"
#include "support/cases.h"
#include "support/device.h"

namespace crsh {
namespace {

constexpr double unit = 1.0 / (1 << shared::tests_fraction_bits);

/// Two segments of rays in some order over nodes of uneven sizes, two pixels a surface apart.
struct Bundles {
  gpu::Recorder recorder{test::device()};
  test::Random random{77};
  rays::Batch batch;
  hierarchy::Hierarchy hierarchy;
  std::vector<uint32_t> order;
  std::vector<glm::uvec2> node_rays;
  gpu::Buffer gpu_order, pixels, tests;

  Bundles() {
    batch.segments = {{.kind = 0, .light = 0, .first = 0, .count = 700},
                      {.kind = 1, .light = 0, .first = 700, .count = 300}};
    batch.count = batch.surfaces = 1000;
    order.resize(1000);
    std::iota(order.begin(), order.end(), 0u);
    for (uint32_t i = 0; i < 700; ++i) std::swap(order[i], order[random.below(700)]);
    batch.slots = gpu::upload(test::device(), order, "slots");  // any permutation
    gpu_order = gpu::upload(test::device(), order, "order");
    std::vector<glm::vec4> surfaces;
    for (uint32_t i = 0; i < 1000; ++i) surfaces.emplace_back(0, 0, 0, std::bit_cast<float>(i));
    pixels = gpu::upload(test::device(), surfaces, "pixels");
    add_level();
    tests = gpu::upload(test::device(), std::vector<uint64_t>(1000), "tests");
  }

  void add_level() {
    hierarchy.levels.resize(1);
    hierarchy.depth = 1;
    hierarchy::Level& level = hierarchy.levels[0];
    for (const rays::Segment& segment : batch.segments) {
      const auto first = static_cast<uint32_t>(node_rays.size());
      for (uint32_t ray = segment.first; ray < segment.first + segment.count;) {
        const uint32_t end = std::min(ray + 1 + random.below(40), segment.first + segment.count);
        node_rays.emplace_back(ray, end);
        ray = end;
      }
      level.segments.push_back({first, static_cast<uint32_t>(node_rays.size()) - first});
    }
    level.count = static_cast<uint32_t>(node_rays.size());
    level.rays = gpu::upload(test::device(), node_rays, "rays of nodes");
  }

  [[nodiscard]] std::vector<uint64_t> shared_out(const hierarchy::Account& account, uint32_t kind) {
    account.share(recorder, {batch, hierarchy, gpu_order, 0, pixels}, kind, tests);
    return recorder.read<uint64_t>(tests, 1000);
  }
};

/// The slots of one kind and level of an account.
void write(const hierarchy::Account& account, uint32_t kind, uint32_t level, const std::vector<uint32_t>& values) {
  gpu::upload_bytes(test::device(), account.buffer_or(gpu::Buffer()), account.first(kind, level) * sizeof(uint32_t),
                    values.data(), values.size() * sizeof(uint32_t));
}

std::vector<uint32_t> random_tests(test::Random& random, size_t count) {
  std::vector<uint32_t> tests(count);
  for (uint32_t& value : tests) value = random.below(4) == 0 ? 0 : random.below(UINT32_MAX);
  return tests;
}

TEST_CASE("a node's tests are shared equally among its rays, and none is lost" * doctest::test_suite("subset")) {
  Bundles bundles;
  hierarchy::Account account;
  account.begin(bundles.recorder, {true, true, true}, 1000, bundles.hierarchy);
  bundles.recorder.submit();
  const std::vector<uint32_t> tests = random_tests(bundles.random, bundles.node_rays.size());
  write(account, shared::tests_node, 1, tests);
  const std::vector<uint64_t> pixels = bundles.shared_out(account, shared::tests_node);
  for (size_t node = 0; node < tests.size(); ++node) {
    const glm::uvec2 range = bundles.node_rays[node];
    const double share = double(tests[node]) / (range.y - range.x);
    uint64_t sum = 0;
    for (uint32_t position = range.x; position < range.y; ++position) {
      const uint64_t pixel = pixels[bundles.order[bundles.order[position]]];  // slots are the same permutation
      CHECK(std::abs(double(pixel) * unit - share) < 1.001 * unit);
      sum += pixel;
    }
    CHECK(sum == uint64_t(tests[node]) << shared::tests_fraction_bits);
  }
}

TEST_CASE("rays keep their own tests, and sums carry past 32 bits") {
  Bundles bundles;
  hierarchy::Account account;
  account.begin(bundles.recorder, {true, false, true}, 1000, bundles.hierarchy);
  bundles.recorder.submit();
  const std::vector<uint32_t> tests = random_tests(bundles.random, 1000);
  write(account, shared::tests_object, 0, tests);
  (void)bundles.shared_out(account, shared::tests_object);
  const std::vector<uint64_t> twice = bundles.shared_out(account, shared::tests_object);
  for (uint32_t ray = 0; ray < 1000; ++ray)
    CHECK(twice[bundles.order[ray]] == uint64_t(tests[ray]) << (shared::tests_fraction_bits + 1));
}

TEST_CASE("an account that nobody wants takes no memory and no kernel") {
  gpu::Recorder recorder(test::device());
  hierarchy::Account account;
  const gpu::Buffer stand_in(test::device(), 16, "stand-in");
  account.begin(recorder, {}, 1000, {});
  CHECK(&account.buffer_or(stand_in) == &stand_in);
  CHECK(account.kernel("hierarchy/share_rays").constants.empty());
  CHECK(account.first(shared::tests_node, 3) == 0);
}

}  // namespace
}  // namespace crsh
