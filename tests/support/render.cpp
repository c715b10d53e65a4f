#include "support/render.h"

#include <fmt/format.h>

#include <bit>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <utility>
#include <vector>

#include "scene/gltf/load.h"
#include "support/device.h"

namespace crsh::test {
namespace {

const scene::Scene& loaded(const std::filesystem::path& path) {
  static std::map<std::filesystem::path, scene::Scene> scenes;
  const auto found = scenes.find(path);
  return found != scenes.end() ? found->second : scenes.emplace(path, scene::load(path)).first->second;
}

std::filesystem::path shared_folder() {
  const char* chosen = std::getenv("CRSH_SHARED_SCENES");
  return chosen && *chosen ? std::filesystem::path(chosen)
                           : std::filesystem::path(CRSH_SOURCE_DIR).parent_path() / "shared/scenes";
}

std::string difference(const Layer& a, const Layer& b, uint32_t width) {
  if (a.name != b.name || a.channels != b.channels || a.values.size() != b.values.size())
    return fmt::format("layer '{}' has another shape than layer '{}'", a.name, b.name);
  if (a.ids != b.ids) return fmt::format("layer '{}' has other numbers", a.name);
  for (size_t i = 0; i < a.values.size(); ++i) {
    if (std::bit_cast<uint32_t>(a.values[i]) == std::bit_cast<uint32_t>(b.values[i])) continue;
    const size_t pixel = i / a.channels.size();
    return fmt::format("{} at ({}, {}): {} against {}", a.channels[i % a.channels.size()], pixel % width, pixel / width,
                       a.values[i], b.values[i]);
  }
  return {};
}

/// A name and a value; floats by all their digits.
using Line = std::pair<std::string, std::string>;

Line line(const RayStatistics& row, const std::string& name, auto value) {
  return {fmt::format("{} {}: {}", row.kind, row.bounce, name), fmt::format("{}", value)};
}

std::vector<Line> hit_lines(const Statistics& statistics) {
  std::vector<Line> lines;
  for (const RayStatistics& row : statistics.rays) {
    lines.push_back(line(row, "count", row.count));
    lines.push_back(line(row, "hits", row.hits));
    lines.push_back(line(row, "digest", row.hits_digest));
  }
  return lines;
}

void add_levels(const RayStatistics& row, std::vector<Line>& lines) {
  for (const LevelStatistics& level : row.levels) {
    const std::string name = fmt::format("level {} ", level.level);
    lines.push_back(line(row, name + "nodes", level.nodes));
    lines.push_back(line(row, name + "half angles", level.half_angle_sum));
    lines.push_back(line(row, name + "radii", level.radius_sum));
    lines.push_back(line(row, name + "tests", level.tests));
    lines.push_back(line(row, name + "hits", level.hits));
  }
}

std::vector<Line> counter_lines(const Statistics& statistics) {
  std::vector<Line> lines = hit_lines(statistics);
  for (const RayStatistics& row : statistics.rays) {
    lines.push_back(line(row, "chunks", row.chunks));
    lines.push_back(line(row, "triangles", row.triangles));
    lines.push_back(line(row, "mesh tests", row.mesh_tests));
    lines.push_back(line(row, "box tests", row.box_tests));
    lines.push_back(line(row, "triangle tests", row.triangle_tests));
    add_levels(row, lines);
  }
  return lines;
}

std::string difference(const std::vector<Line>& a, const std::vector<Line>& b) {
  if (a.size() != b.size()) return fmt::format("{} counters against {}", a.size(), b.size());
  for (size_t i = 0; i < a.size(); ++i)
    if (a[i] != b[i]) return fmt::format("{} {} against {} {}", a[i].first, a[i].second, b[i].first, b[i].second);
  return {};
}

}  // namespace

Rendered render(gpu::Device& device, const scene::Scene& scene, const RenderOptions& options, double seconds) {
  Renderer renderer(borrowed(device), borrowed(scene), options);
  Picture picture = renderer.render(seconds);
  return {std::move(picture), renderer.statistics()};
}

Rendered render(const scene::Scene& scene, const RenderOptions& options, double seconds) {
  return render(device(), scene, options, seconds);
}

Rendered render_with(const std::string& algorithm, const scene::Scene& scene, RenderOptions options, double seconds) {
  options.algorithm = preset(algorithm);
  return render(scene, options, seconds);
}

gpu::DeviceRequest device_request() {
  gpu::DeviceRequest request = device().request();
  request.memory_budget = request.first_capacity = 0;
  return request;
}

const scene::Scene& own_scene(const std::string& name) {
  return loaded(std::filesystem::path(CRSH_SOURCE_DIR) / "scenes" / (name + ".glb"));
}

const scene::Scene* shared_scene(const std::string& path) {
  const std::filesystem::path file = shared_folder() / path;
  return std::filesystem::exists(file) ? &loaded(file) : nullptr;
}

std::string difference(const Picture& a, const Picture& b) {
  if (a.width != b.width || a.height != b.height || a.layers.size() != b.layers.size()) return "other sizes or layers";
  if (a.world_to_camera != b.world_to_camera || a.world_to_ndc != b.world_to_ndc) return "other cameras";
  for (size_t l = 0; l < a.layers.size(); ++l) {
    const std::string found = difference(a.layers[l], b.layers[l], a.width);
    if (!found.empty()) return found;
  }
  return {};
}

std::string difference_of_hits(const Statistics& a, const Statistics& b) {
  return difference(hit_lines(a), hit_lines(b));
}

std::string difference_of_counters(const Statistics& a, const Statistics& b) {
  return difference(counter_lines(a), counter_lines(b));
}

std::string difference(const Rendered& a, const Rendered& b) {
  const std::string hits = difference_of_hits(a.statistics, b.statistics);
  return hits.empty() ? difference(a.picture, b.picture) : hits;
}

const RayStatistics& rays_of(const Statistics& statistics, std::string_view kind, uint32_t bounce) {
  for (const RayStatistics& row : statistics.rays)
    if (row.kind == kind && row.bounce == bounce) return row;
  std::abort();
}

}  // namespace crsh::test
