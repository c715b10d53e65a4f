// Sums of counters, and the JSON of --stats.

#include <doctest/doctest.h>

#include "crsh/statistics.h"
#include "output/json_text.h"
#include "output/stats_json.h"

namespace crsh {
namespace {

RayStatistics example() {
  RayStatistics rays{.kind = "shadow", .bounce = 1, .count = 10, .hits = 4, .hits_digest = 0xABCDEF, .triangles = 100};
  rays.mesh_tests = 7;
  rays.box_tests = 5;
  rays.triangle_tests = 80;
  rays.levels = {{.level = 2, .nodes = 2, .half_angle_sum = 0.5, .radius_sum = 3, .tests = 200, .hits = 20},
                 {.level = 1, .nodes = 4, .tests = 160, .hits = 10}};
  return rays;
}

TEST_CASE("paper_tests are all levels' and the exact ones, total_tests the objects' besides") {
  CHECK(example().paper_tests() == 440);
  CHECK(example().object_tests() == 12);
  CHECK(example().total_tests() == 452);
  CHECK(example().levels[0].misses() == 180);
}

nlohmann::ordered_json json_of(const Statistics& statistics) {
  output::RunDescription run{
      .command = {"crsh", "render"}, .scene = "a.glb", .width = 4, .height = 3, .algorithm = "rah"};
  run.options = {{"bounces", 4}};
  run.device.name = "device";
  run.world_to_camera[3] = {0, 0, 5, 1};
  return nlohmann::ordered_json::parse(output::json_text(output::stats_json(run, statistics)));
}

TEST_CASE("the JSON has every member of schema crsh-stats/1, in its order") {
  Statistics statistics;
  statistics.rays = {example()};
  const auto json = json_of(statistics);
  std::vector<std::string> members;
  for (const auto& [name, value] : json.items()) members.push_back(name);
  CHECK(members == std::vector<std::string>{"schema", "version", "commit", "command", "options", "device", "host",
                                            "scene", "camera", "image", "algorithm", "frames", "frame_ms",
                                            "pipeline_ms", "stages", "rays", "object_hierarchy", "memory"});
  CHECK(json["schema"] == "crsh-stats/1");
  for (const char* name : {"name", "driver", "driver_version", "api_version", "type", "subgroup_size"})
    CHECK(json["device"].contains(name));
  for (const char* name : {"path", "triangles", "meshes", "instances", "lights"}) CHECK(json["scene"].contains(name));
  CHECK(json["image"] == nlohmann::ordered_json{{"width", 4}, {"height", 3}, {"samples", 1}});
  CHECK(json["host"]["threads"] > 0);
  CHECK(json["camera"]["eye"] == nlohmann::ordered_json{0.0, 0.0, -5.0});
}

TEST_CASE("the rays' members are there, the digest as 16 hexadecimal digits") {
  Statistics statistics;
  statistics.rays = {example()};
  const auto rays = json_of(statistics)["rays"][0];
  std::vector<std::string> members;
  for (const auto& [name, value] : rays.items()) members.push_back(name);
  CHECK(members == std::vector<std::string>{"kind", "bounce", "count", "hits", "hits_digest", "chunks",
                                            "brute_force_tests", "mesh_tests", "box_tests", "object_tests", "levels",
                                            "triangle_tests", "alpha_tests", "paper_tests", "total_tests"});
  CHECK(rays["hits_digest"] == "0000000000abcdef");
  CHECK(rays["brute_force_tests"] == 1000);
  CHECK(rays["levels"][0]["mean_half_angle"] == 0.25);
  CHECK(rays["levels"][0]["mean_radius"] == 1.5);
  CHECK(rays["levels"][0]["misses"] == 180);
}

TEST_CASE("counters are exact beyond 53 bits") {
  Statistics statistics;
  statistics.rays = {example()};
  statistics.rays[0].mesh_tests = (uint64_t(1) << 63) + 1;
  statistics.device_peak_bytes = UINT64_MAX;
  const auto json = json_of(statistics);
  CHECK(json["rays"][0]["mesh_tests"].get<uint64_t>() == (uint64_t(1) << 63) + 1);
  CHECK(json["memory"]["device_peak_bytes"].get<uint64_t>() == UINT64_MAX);
}

TEST_CASE("times are summed up over frames, for all ten stages, also without any frame") {
  Statistics statistics;
  CHECK(json_of(statistics)["frame_ms"]["median"] == 0);
  for (const double time : {4.0, 1.0, 3.0, 8.0}) {
    FrameTime frame{.total_ms = time, .pipeline_ms = time == 4 ? 2.0 : 0.0};
    frame.stage_ms[8] = time / 2;
    statistics.frames.push_back(frame);
  }
  const auto json = json_of(statistics);
  CHECK(json["frames"] == 4);
  CHECK(json["frame_ms"] == nlohmann::ordered_json{{"min", 1.0}, {"median", 3.5}, {"mean", 4.0}, {"max", 8.0}});
  CHECK(json["pipeline_ms"]["max"] == 2.0);
  CHECK(json["pipeline_ms"]["min"] == 0.0);
  CHECK(json["stages"].size() == 10);
  CHECK(json["stages"][8]["name"] == "shading");
  CHECK(json["stages"][8]["ms"]["max"] == 4.0);
}

}  // namespace
}  // namespace crsh
