#include "support/bench_run.h"

#include <doctest/doctest.h>

namespace crsh::test {

Outcome bench(std::vector<std::string> options) {
  options.insert(options.begin(), {"bench", "-q", "--size", "12x10", "--bounces", "1"});
  return crsh(options);
}

nlohmann::json bench_json(std::vector<std::string> options) {
  options.insert(options.end(), {"--json", "-"});
  const Outcome outcome = bench(options);
  CAPTURE(outcome.err);
  REQUIRE(outcome.status == 0);
  return nlohmann::json::parse(outcome.out);
}

std::vector<std::string> labels_of(const nlohmann::json& result) {
  std::vector<std::string> labels;
  for (const nlohmann::json& run : result["runs"]) labels.push_back(run["bench"]["label"]);
  return labels;
}

uint64_t sum(const nlohmann::json& run, const char* counter) {
  uint64_t total = 0;
  for (const nlohmann::json& rays : run["rays"]) total += rays[counter].get<uint64_t>();
  return total;
}

}  // namespace crsh::test
