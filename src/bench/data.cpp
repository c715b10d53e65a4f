#include "bench/data.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "bench/counters.h"
#include "crsh/version.h"
#include "output/stats_json.h"

namespace crsh::bench {
namespace {

using Json = nlohmann::ordered_json;

Json run_json(const Description& description, const SceneResults& scene, const Result& result) {
  const output::RunDescription run{.command = description.command,
                                   .options = description.effective(result.variant),
                                   .device = description.device,
                                   .scene = scene.path,
                                   .world_to_camera = result.world_to_camera,
                                   .world_to_ndc = result.world_to_ndc,
                                   .width = result.width,
                                   .height = result.height,
                                   .samples = result.variant.options.samples,
                                   .algorithm = result.variant.options.algorithm.preset};
  const bool traced = result.counted_from.empty();
  Json json = output::stats_json(run, times(result.counters, std::max<uint64_t>(result.passes(), 1)));
  json["bench"] = {{"scene", scene.name},
                   {"label", result.variant.label},
                   {"vary", result.variant.vary},
                   {"traced", traced},
                   {"timed", !result.counters.frames.empty()},
                   {"rays_counted_with", traced ? Json() : Json(result.counted_from)},
                   {"places", result.places}};
  return json;
}

/// A field of a CSV file: quoted where it must be.
std::string field(const std::string& text) {
  if (text.find_first_of(",\"\n") == std::string::npos) return text;
  std::string quoted = "\"";
  for (const char c : text) quoted += c == '"' ? "\"\"" : std::string(1, c);
  return quoted + "\"";
}

/// Counters of rays, by the names in the statistics.
using Counters = std::vector<std::pair<std::string, uint64_t>>;

Counters counters_of(const RayStatistics& rays) {
  uint64_t level_tests = 0;
  for (const LevelStatistics& level : rays.levels) level_tests += level.tests;
  return {{"count", rays.count},
          {"hits", rays.hits},
          {"brute_force_tests", rays.count * rays.triangles},
          {"mesh_tests", rays.mesh_tests},
          {"box_tests", rays.box_tests},
          {"object_tests", rays.object_tests()},
          {"level_tests", level_tests},
          {"triangle_tests", rays.triangle_tests},
          {"paper_tests", rays.paper_tests()},
          {"total_tests", rays.total_tests()}};
}

std::string row_start(const SceneResults& scene, const Result& result) {
  return fmt::format("{},{},{},{}", field(scene.name), field(result.variant.label),
                     field(result.variant.options.algorithm.preset), result.counters.triangles);
}

std::string counter_fields(const Counters& counters) {
  std::string text;
  for (const auto& [name, value] : counters) text += fmt::format(",{}", value);
  return text;
}

std::string time_fields(const Result& result) {
  if (result.counters.frames.empty()) return fmt::format(",{}", std::string(stage_count, ','));
  std::string text = fmt::format(",{:.4f}", frame_median(result));
  for (size_t stage = 0; stage < stage_count; ++stage)
    text += fmt::format(",{:.4f}", stage_median(result, static_cast<Stage>(stage)));
  return text;
}

std::string rows_of(const SceneResults& scene, const Result& result) {
  const std::string start = row_start(scene, result), no_times(stage_count + 1, ',');
  Counters sums = counters_of(RayStatistics());
  std::string text;
  for (const RayStatistics& rays : result.counters.rays) {
    if (!rays.count) continue;
    const Counters counters = counters_of(rays);
    for (size_t i = 0; i < sums.size(); ++i) sums[i].second += counters[i].second;
    text += fmt::format("{},{},{}{}{}\n", start, rays.kind, rays.bounce, counter_fields(counters), no_times);
  }
  return text + fmt::format("{},all,{}{}\n", start, counter_fields(sums), time_fields(result));
}

std::string header() {
  std::string text = "scene,label,algorithm,triangles,kind,bounce";
  for (const auto& [name, value] : counters_of(RayStatistics())) text += "," + name;
  text += ",frame_ms";
  for (const std::string_view stage : stage_names) {
    text += fmt::format(",{}_ms", stage);
    std::ranges::replace(text, ' ', '_');
  }
  return text + "\n";
}

}  // namespace

nlohmann::ordered_json bench_json(const Description& description, const std::vector<SceneResults>& scenes) {
  Json runs = Json::array();
  for (const SceneResults& scene : scenes)
    for (const Result& result : scene.results) runs.push_back(run_json(description, scene, result));
  return {{"schema", "crsh-bench/1"},
          {"version", version},
          {"commit", commit},
          {"command", description.command},
          {"repeat", description.schedule.repeat},
          {"warmup", description.schedule.warmup},
          {"budget_s", description.schedule.budget_seconds},
          {"runs", std::move(runs)}};
}

std::string bench_csv(const std::vector<SceneResults>& scenes) {
  std::string text = header();
  for (const SceneResults& scene : scenes)
    for (const Result& result : scene.results) text += rows_of(scene, result);
  return text;
}

}  // namespace crsh::bench
