// The table of tracers, row by row: what it promises those who add one.

#include <doctest/doctest.h>

#include <algorithm>
#include <set>

#include "crsh/error.h"
#include "support/kinds.h"
#include "trace/tracers.h"

namespace crsh {
namespace {

using doctest::Contains;
using trace::Tracer;

std::vector<std::string> every_preset() {
  std::vector<std::string> names = preset_names();
  names.emplace_back(ray_query_preset);
  return names;
}

/// Whether whatever `other` needs is there where what `tracer` needs is.
bool covers(const trace::Needs& tracer, const trace::Needs& other) {
  return tracer.object_hierarchy >= other.object_hierarchy && tracer.device_hierarchy >= other.device_hierarchy &&
         tracer.sorted_rays >= other.sorted_rays;
}

TEST_CASE("tracers have names of their own, by which they are found") {
  std::set<std::string_view> names;
  for (const Tracer& tracer : trace::tracers()) {
    CHECK(names.insert(tracer.name).second);
    CHECK(&trace::tracer_named(tracer.name) == &tracer);
  }
}

TEST_CASE("every tracer runs, with a scratch of its own") {
  for (const Tracer& tracer : trace::tracers()) {
    CAPTURE(tracer.name);
    REQUIRE(bool(tracer.run));
    REQUIRE(bool(tracer.scratch));
    CHECK(tracer.scratch().get() != nullptr);
    CHECK(tracer.scratch() != tracer.scratch());
  }
}

TEST_CASE("every preset names a tracer and gives it what it needs, and every tracer is some preset's") {
  std::set<std::string_view> named;
  for (const std::string& name : every_preset()) {
    CAPTURE(name);
    const AlgorithmOptions options = preset(name);
    const Tracer& tracer = trace::tracer_of(options);
    named.insert(tracer.name);
    CHECK_NOTHROW(trace::require_sound(options));
    const bool sorts = std::ranges::any_of(options.keys, [](const std::string& key) { return !key.empty(); });
    CHECK(tracer.needs.sorted_rays >= sorts);  // keys without effect would mislead
  }
  CHECK(named.size() == trace::tracers().size());
}

TEST_CASE("only one hierarchy over the objects is needed at once, and levels only of nodes") {
  for (const Tracer& tracer : trace::tracers()) {
    CAPTURE(tracer.name);
    CHECK_FALSE((tracer.needs.object_hierarchy && tracer.needs.device_hierarchy));
    CHECK(tracer.needs.max_levels >= 1);
    CHECK((tracer.needs.sorted_rays || tracer.needs.max_levels == UINT32_MAX));
  }
}

TEST_CASE("scattered rays go to a tracer that needs no nodes and finds all else there") {
  for (const Tracer& tracer : trace::tracers()) {
    if (tracer.scattered.empty()) continue;
    CAPTURE(tracer.name);
    const Tracer& other = trace::tracer_named(tracer.scattered);
    CHECK(tracer.needs.sorted_rays);
    CHECK_FALSE(other.needs.sorted_rays);
    CHECK(other.scattered.empty());
    CHECK(covers(tracer.needs, other.needs));
  }
}

TEST_CASE("nodes go through the object hierarchy on one or two levels") {
  AlgorithmOptions options = preset("crsh-bvh");
  CHECK(trace::tracer_of(options).needs.object_hierarchy);
  CHECK_NOTHROW(trace::require_sound(options));
  options.levels = test::in_turn<uint32_t>({1, 2});
  CHECK_NOTHROW(trace::require_sound(options));
  options.levels = test::in_turn<uint32_t>({2, 3});
  CHECK_THROWS_WITH_AS(trace::require_sound(options), Contains("choose fewer levels"), UserError);
  options = preset("crsh");
  options.levels.fill(8);
  CHECK_NOTHROW(trace::require_sound(options));
}

}  // namespace
}  // namespace crsh
