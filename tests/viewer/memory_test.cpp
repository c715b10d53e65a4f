// Memory over many frames and resizes.

#include <doctest/doctest.h>

#include <cstdio>

#include "viewer/view.h"

namespace crsh {
namespace {

using test::lines_with;

struct Bytes {
  unsigned long long device = 0, host = 0;
};

Bytes parsed(const std::string& line) {
  Bytes bytes;
  REQUIRE(std::sscanf(line.c_str(), "memory: device %llu host %llu", &bytes.device, &bytes.host) == 2);
  return bytes;
}

TEST_CASE("memory does not grow over 1,000 frames and 50 resizes") {
  // Twice: what grows once to its largest, pools and caches among it, is there after the first half.
  std::string half = "orbit 500\n";
  for (int i = 0; i < 25; ++i)
    half += "resize " + std::to_string(200 + 8 * (i % 5)) + " " + std::to_string(160 + 8 * (i % 3)) + "\nwait\n";
  half += "resize 200 160\nwait\nprint-memory\n";
  const test::Outcome outcome = test::view(test::cornell, "resize 200 160\nwait\n" + half + half,
                                           {"--bounces", "0", "--samples", "1", "--budget", "5", "--quiet"});
  CAPTURE(outcome.err);
  REQUIRE(outcome.status == 0);
  const auto lines = lines_with(outcome.out, "memory: ");
  REQUIRE(lines.size() == 2);
  const Bytes first = parsed(lines[0]), second = parsed(lines[1]);
  MESSAGE(lines[0], "; ", lines[1]);
  CHECK(second.device <= first.device + first.device / 50);  // lists grow with the most rays that were seen
  CHECK(second.host < first.host + (8ull << 20));
}

}  // namespace
}  // namespace crsh
