#include "bench/counters.h"

#include <fmt/format.h>

#include <algorithm>

namespace crsh::bench {
namespace {

/// Calls `visit(name, value of a, value of b)` for every counter that adds up over frames.
template <class Rays, class OtherRays, class Visit>
void for_counters(Rays& a, OtherRays& b, Visit visit) {
  visit("count", a.count, b.count), visit("hits", a.hits, b.hits), visit("hits_digest", a.hits_digest, b.hits_digest);
  visit("chunks", a.chunks, b.chunks), visit("mesh_tests", a.mesh_tests, b.mesh_tests);
  visit("box_tests", a.box_tests, b.box_tests), visit("triangle_tests", a.triangle_tests, b.triangle_tests);
  for (size_t level = 0; level < std::min(a.levels.size(), b.levels.size()); ++level) {
    visit("nodes", a.levels[level].nodes, b.levels[level].nodes);
    visit("tests", a.levels[level].tests, b.levels[level].tests);
    visit("level's hits", a.levels[level].hits, b.levels[level].hits);
  }
}

}  // namespace

Statistics difference(const Statistics& after, const Statistics& before) {
  Statistics result = after;
  for (size_t row = 0; row < result.rays.size() && row < before.rays.size(); ++row) {
    RayStatistics& rays = result.rays[row];
    for_counters(rays, before.rays[row], [](const char*, uint64_t& value, uint64_t less) { value -= less; });
    for (size_t level = 0; level < std::min(rays.levels.size(), before.rays[row].levels.size()); ++level) {
      rays.levels[level].half_angle_sum -= before.rays[row].levels[level].half_angle_sum;
      rays.levels[level].radius_sum -= before.rays[row].levels[level].radius_sum;
    }
  }
  result.frames.erase(result.frames.begin(), result.frames.begin() + static_cast<std::ptrdiff_t>(before.frames.size()));
  return result;
}

Statistics times(const Statistics& one, uint64_t frames) {
  Statistics result = one;
  for (RayStatistics& rays : result.rays) {
    for_counters(rays, rays, [&](const char*, uint64_t& value, uint64_t) { value *= frames; });
    for (LevelStatistics& level : rays.levels)
      level.half_angle_sum *= double(frames), level.radius_sum *= double(frames);
  }
  return result;
}

std::string first_difference(const Statistics& a, const Statistics& b) {
  if (a.rays.size() != b.rays.size()) return "kinds of rays";
  std::string found;
  for (size_t row = 0; row < a.rays.size(); ++row) {
    const RayStatistics &one = a.rays[row], &other = b.rays[row];
    const auto compare = [&](const char* name, uint64_t x, uint64_t y) {
      if (x != y && found.empty()) found = fmt::format("{} {}: {} is {} and {}", one.kind, one.bounce, name, x, y);
    };
    compare("levels", one.levels.size(), other.levels.size());
    for_counters(one, other, compare);
  }
  return found;
}

Statistics as_brute_force(Statistics statistics) {
  for (RayStatistics& rays : statistics.rays) {
    rays.levels.clear();
    rays.chunks = rays.mesh_tests = rays.box_tests = 0;
    rays.triangle_tests = rays.count * rays.triangles;
  }
  statistics.object_hierarchy = {};
  statistics.frames.clear();
  statistics.device_peak_bytes = 0;
  return statistics;
}

uint64_t brute_force_tests(const Statistics& statistics) {
  uint64_t sum = 0;
  for (const RayStatistics& rays : statistics.rays) sum += rays.count * rays.triangles;
  return sum;
}

}  // namespace crsh::bench
