#include "output/stats_json.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <numeric>
#include <thread>

#include "crsh/version.h"

namespace crsh::output {
namespace {

using Json = nlohmann::ordered_json;

/// {"min","median","mean","max"}; all 0 where there are no values.
Json summary(std::vector<double> values) {
  if (values.empty()) values = {0};
  std::ranges::sort(values);
  const size_t half = values.size() / 2;
  const double median = values.size() % 2 ? values[half] : (values[half - 1] + values[half]) / 2;
  const double mean = std::accumulate(values.begin(), values.end(), 0.0) / double(values.size());
  return {{"min", values.front()}, {"median", median}, {"mean", mean}, {"max", values.back()}};
}

/// Of one of a frame's times.
using Milliseconds = double FrameTime::*;

Json times_json(const std::vector<FrameTime>& frames, Milliseconds time) {
  std::vector<double> values;
  for (const FrameTime& frame : frames) values.push_back(frame.*time);
  return summary(std::move(values));
}

Json stages_json(const std::vector<FrameTime>& frames) {
  Json stages = Json::array();
  for (size_t stage = 0; stage < stage_count; ++stage) {
    std::vector<double> values;
    for (const FrameTime& frame : frames) values.push_back(frame.stage_ms[stage]);
    stages.push_back({{"name", stage_names[stage]}, {"ms", summary(std::move(values))}});
  }
  return stages;
}

Json level_json(const LevelStatistics& level) {
  const double nodes = level.nodes ? double(level.nodes) : 1;
  return {{"level", level.level},
          {"nodes", level.nodes},
          {"mean_half_angle", level.half_angle_sum / nodes},
          {"mean_radius", level.radius_sum / nodes},
          {"tests", level.tests},
          {"hits", level.hits},
          {"misses", level.misses()}};
}

Json rays_json(const RayStatistics& rays) {
  Json levels = Json::array();
  for (const LevelStatistics& level : rays.levels) levels.push_back(level_json(level));
  return {{"kind", rays.kind},
          {"bounce", rays.bounce},
          {"count", rays.count},
          {"hits", rays.hits},
          {"hits_digest", fmt::format("{:016x}", rays.hits_digest)},
          {"chunks", rays.chunks},
          {"brute_force_tests", rays.count * rays.triangles},
          {"mesh_tests", rays.mesh_tests},
          {"box_tests", rays.box_tests},
          {"object_tests", rays.object_tests()},
          {"levels", std::move(levels)},
          {"triangle_tests", rays.triangle_tests},
          {"alpha_tests", rays.alpha_tests},
          {"paper_tests", rays.paper_tests()},
          {"total_tests", rays.total_tests()}};
}

std::string processor_name() {
  std::ifstream file("/proc/cpuinfo");
  for (std::string line; std::getline(file, line);)
    if (line.starts_with("model name")) return line.substr(std::min(line.size(), line.find(':') + 2));
  return "unknown";
}

/// Four rows, as in the EXR's attribute: a point is a row vector, and is multiplied from the left.
Json matrix_json(const glm::dmat4& matrix) {
  Json rows = Json::array();
  for (int row = 0; row < 4; ++row) rows.push_back({matrix[row].x, matrix[row].y, matrix[row].z, matrix[row].w});
  return rows;
}

Json camera_json(const RunDescription& run) {
  const glm::dmat4 camera_to_world = glm::inverse(run.world_to_camera);
  const glm::dvec4 eye = camera_to_world[3], forward = camera_to_world[2];
  return {{"eye", {eye.x, eye.y, eye.z}},
          {"forward", {forward.x, forward.y, forward.z}},
          {"world_to_camera", matrix_json(run.world_to_camera)},
          {"world_to_ndc", matrix_json(run.world_to_ndc)}};
}

}  // namespace

Json device_json(const gpu::DeviceInfo& device) {
  return {{"name", device.name},
          {"driver", device.driver},
          {"driver_version", device.driver_version},
          {"api_version", device.api_version},
          {"type", device.type},
          {"subgroup_size", device.subgroup_size}};
}

Json host_json() { return {{"cpu", processor_name()}, {"threads", std::thread::hardware_concurrency()}}; }

Json stats_json(const RunDescription& run, const Statistics& statistics) {
  Json rays = Json::array();
  for (const RayStatistics& row : statistics.rays) rays.push_back(rays_json(row));
  return {
      {"schema", "crsh-stats/1"},
      {"version", version},
      {"commit", commit},
      {"command", run.command},
      {"options", run.options},
      {"device", device_json(run.device)},
      {"host", host_json()},
      {"scene",
       {{"path", run.scene},
        {"triangles", statistics.triangles},
        {"meshes", statistics.meshes},
        {"instances", statistics.instances},
        {"lights", statistics.lights}}},
      {"camera", run.replayed ? Json() : camera_json(run)},
      {"image", run.replayed ? Json() : Json{{"width", run.width}, {"height", run.height}, {"samples", run.samples}}},
      {"algorithm", run.algorithm},
      {"frames", statistics.frames.size()},
      {"frame_ms", times_json(statistics.frames, &FrameTime::total_ms)},
      {"pipeline_ms", times_json(statistics.frames, &FrameTime::pipeline_ms)},
      {"stages", stages_json(statistics.frames)},
      {"rays", std::move(rays)},
      {"object_hierarchy",
       {{"builds", statistics.object_hierarchy.builds},
        {"refits", statistics.object_hierarchy.refits},
        {"sah_cost", statistics.object_hierarchy.sah_cost}}},
      {"memory", {{"device_peak_bytes", statistics.device_peak_bytes}}}};
}

}  // namespace crsh::output
