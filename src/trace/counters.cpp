#include "trace/counters.h"

#include "crsh/kinds.h"
#include "shared/counters.h"

namespace crsh::trace {

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
    row.alpha_tests += counter[shared::counter_alpha_tests];
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

}  // namespace crsh::trace
