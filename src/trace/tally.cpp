#include "trace/tally.h"

#include <cmath>
#include <numbers>

#include "crsh/kinds.h"
#include "trace/counters.h"

namespace crsh::trace {
namespace {

RayStatistics& row_of(Statistics& statistics, uint32_t bounce, uint32_t kind) {
  return statistics.rays[bounce * kind_count + kind];
}

/// The entry of a level; levels stand from the top down.
LevelStatistics& level_of(RayStatistics& row, uint32_t level) {
  while (row.levels.size() < level)
    row.levels.insert(row.levels.begin(), LevelStatistics{.level = static_cast<uint32_t>(row.levels.size()) + 1});
  return row.levels[row.levels.size() - level];
}

/// Adds the nodes of a segment to a level's means.
void add_nodes(const std::vector<glm::vec2>& spreads, hierarchy::Range range, LevelStatistics& level) {
  level.nodes += range.count;
  for (uint32_t i = range.first; i < range.end(); ++i) {
    const float tangent = spreads[i].x;
    level.half_angle_sum += tangent < 1e30f ? std::atan(double(tangent)) : std::numbers::pi / 2;
    level.radius_sum += spreads[i].y;
  }
}

/// For each level of nodes the spread of every node.
std::vector<std::vector<glm::vec2>> spreads_of(gpu::Recorder& recorder, const Traced& traced) {
  std::vector<std::vector<glm::vec2>> spreads;
  for (uint32_t l = 0; l < traced.depth(); ++l)
    spreads.push_back(hierarchy::spreads(recorder, traced.bundle->hierarchy, l));
  return spreads;
}

void add_to_statistics(gpu::Recorder& recorder, const Traced& traced, Statistics& statistics) {
  const std::vector<rays::Segment>& segments = traced.in.batch.segments;
  const auto spreads = spreads_of(recorder, traced);
  for (size_t s = 0; s < segments.size(); ++s) {
    RayStatistics& row = row_of(statistics, traced.in.bounce, segments[s].kind);
    row.count += segments[s].count;
    row.chunks += traced.bundle ? traced.bundle->order.chunks[s] : 0;
    for (uint32_t l = 0; l < traced.depth(); ++l)
      if (const hierarchy::Range nodes = traced.bundle->hierarchy.levels[l].segments[s]; nodes.count)
        add_nodes(spreads[l], nodes, level_of(row, l + 1));
  }
}

void digest(gpu::Recorder& recorder, const Traced& traced) {
  const RayNames& names = traced.in.names;
  for (const rays::Segment& segment : traced.in.batch.segments)
    intersection::digest(recorder, intersection_in(traced.in, segment.kind), segment, names.first_surface, names.pixels,
                         names.paths);
}

/// The tests of the batch's rays and nodes, by pixel.
void share_tests(gpu::Recorder& recorder, const Traced& traced, const TestsByPixel& tests) {
  const In& in = traced.in;
  const hierarchy::AccountIn account{in.batch, traced.hierarchy(), in.workspace.bundle.order.order,
                                     in.names.first_surface, in.names.pixels};
  for (uint32_t type = 0; type < shared::tests_count; ++type)
    if (in.wanted[type]) in.workspace.account.share(recorder, account, type, *tests[type]);
}

}  // namespace

void tally(gpu::Recorder& recorder, const Traced& traced, const TestsByPixel& tests, Statistics& statistics) {
  digest(recorder, traced);
  share_tests(recorder, traced, tests);
  add_to_statistics(recorder, traced, statistics);
}

}  // namespace crsh::trace
