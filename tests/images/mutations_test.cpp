// Each fault that can be switched on turns a comparison red; the names are those of tests/README.md.

#include <doctest/doctest.h>

#include <string>

#include "support/render.h"

namespace crsh::test {
namespace {

/// What brute force and the preset differ in while `mutation` is at work.
std::string difference_under(const std::string& mutation, const std::string& algorithm, const std::string& name) {
  RenderOptions options;
  options.width = 64;
  options.height = 48;
  options.bounces = 2;
  const Rendered truth = render_with("crsh", own_scene(name), options);
  options.mutation = mutation;
  return difference(truth, render_with(algorithm, own_scene(name), options));
}

TEST_CASE("the comparison of algorithms turns red when cones are too narrow") {
  CHECK(difference_under("narrow-cones", "crsh", "cornell") != "");
}

TEST_CASE("the comparison of algorithms turns red when pairs are dropped") {
  CHECK(difference_under("dropped-pairs", "crsh", "cornell") != "");
  CHECK(difference_under("dropped-pairs", "rah", "cornell") != "");
}

/// Hits do not depend on the order of rays; tests/stages/sort_test.cpp and coherence_test.cpp turn red.
TEST_CASE("the comparison of counters turns red when the sort is unstable, and no hit or pixel changes") {
  RenderOptions options;
  options.width = 64;
  options.height = 48;
  options.bounces = 0;
  const Rendered stable = render_with("crsh-2017", own_scene("cornell"), options);
  options.mutation = "unstable-sort";
  const Rendered unstable = render_with("crsh-2017", own_scene("cornell"), options);
  CHECK(difference(stable, unstable) == "");
  CHECK(difference_of_counters(stable.statistics, unstable.statistics) != "");
}

}  // namespace
}  // namespace crsh::test
