#include "frame/counters.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "crsh/kinds.h"
#include "shared/counters.h"

namespace crsh {
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

}  // namespace

Counters::Counters(gpu::Device& device, uint32_t bounces) : rows_((bounces + 1) * static_cast<uint32_t>(kind_count)) {
  buffer_ = gpu::Buffer(device, uint64_t(rows_) * shared::counters_per_row * sizeof(glm::uvec2), "counters");
}

uint32_t Counters::row(uint32_t bounce, uint32_t kind) {
  return (bounce * static_cast<uint32_t>(kind_count) + kind) * shared::counters_per_row;
}

void Counters::clear(gpu::Recorder& recorder) const {
  recorder.fill(buffer_, 0, uint64_t(rows_) * shared::counters_per_row * 2);
}

void Counters::add_to(gpu::Recorder& recorder, Statistics& statistics) const {
  const auto values = recorder.read<uint64_t>(buffer_, uint64_t(rows_) * shared::counters_per_row);
  for (uint32_t r = 0; r < rows_; ++r) {
    const uint64_t* counter = &values[uint64_t(r) * shared::counters_per_row];
    RayStatistics& row = statistics.rays[r];
    row.mesh_tests += counter[shared::counter_mesh_tests];
    row.box_tests += counter[shared::counter_box_tests];
    row.triangle_tests += counter[shared::counter_triangle_tests];
    row.hits += counter[shared::counter_ray_hits];
    row.hits_digest += counter[shared::counter_digest];
    for (LevelStatistics& level : row.levels) {
      level.tests += counter[shared::counter_level_tests + level.level - 1];
      level.hits += counter[shared::counter_level_hits + level.level - 1];
    }
  }
}

std::vector<RayStatistics> empty_rows(uint32_t bounces, uint64_t triangles) {
  std::vector<RayStatistics> rows;
  for (uint32_t bounce = 0; bounce <= bounces; ++bounce)
    for (const RayKind& kind : ray_kinds)
      rows.push_back({.kind = std::string(kind.name), .bounce = bounce, .triangles = triangles, .levels = {}});
  return rows;
}

void add_batch(gpu::Recorder& recorder, const rays::Batch& batch, const coherence::Order& order,
               hierarchy::Hierarchy& hierarchy, uint32_t bounce, Statistics& statistics) {
  std::vector<std::vector<glm::vec2>> spreads;
  for (uint32_t l = 0; l < hierarchy.depth; ++l) spreads.push_back(hierarchy::spreads(recorder, hierarchy, l));
  for (size_t s = 0; s < batch.segments.size(); ++s) {
    RayStatistics& row = row_of(statistics, bounce, batch.segments[s].kind);
    row.count += batch.segments[s].count;
    row.chunks += s < order.chunks.size() ? order.chunks[s] : 0;
    for (uint32_t l = 0; l < hierarchy.depth; ++l)
      if (hierarchy.levels[l].segments[s].count)
        add_nodes(spreads[l], hierarchy.levels[l].segments[s], level_of(row, l + 1));
  }
}

}  // namespace crsh
