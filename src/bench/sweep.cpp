#include "bench/sweep.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "bench/svg.h"
#include "crsh/error.h"

namespace crsh::bench {
namespace {

constexpr double max_triangles = 1e6;

/// A scene and what changes of the variants' options at one size.
struct Size {
  double size = 0;
  uint32_t cuts = 1;  ///< of each triangle's edges
  std::function<void(RenderOptions&)> change = [](RenderOptions&) {};
};

std::vector<Size> triangle_sizes(const scene::Scene& scene) {
  const double triangles = double(std::max<uint64_t>(scene.triangle_count(), 1));
  const auto last = static_cast<uint32_t>(std::max(1.0, std::round(std::sqrt(max_triangles / triangles))));
  std::vector<Size> sizes;
  for (uint32_t n = 1; n < last; n *= 2) sizes.push_back({triangles * n * n, n});
  // Leaves out the size before the last where it is nearly the same.
  if (sizes.size() > 1 && sizes.back().cuts * 3 > last * 2) sizes.pop_back();
  sizes.push_back({triangles * last * last, last});
  return sizes;
}

std::vector<Size> pixel_sizes(const RenderOptions& options) {
  std::vector<Size> sizes;
  for (const double scale : {0.5, 1.0, 2.0}) {
    const auto scaled = [scale](uint32_t side) {
      return side ? std::max(1u, static_cast<uint32_t>(std::lround(side * scale))) : 0;
    };
    const double width = options.width ? options.width : options.height;
    sizes.push_back({width * options.height * scale * scale, 1, [scaled](RenderOptions& changed) {
                       changed.width = scaled(changed.width);
                       changed.height = scaled(changed.height);
                     }});
  }
  return sizes;
}

/// A light in the middle, and the others on a circle around it, a seventh of a turn apart.
std::vector<LightOption> ring(const glm::dvec3& middle, float radius, uint32_t count) {
  std::vector<LightOption> lights = {{middle, {}}};
  for (uint32_t i = 1; i < count; ++i) {
    const float angle = 2 * std::numbers::pi_v<float> * float(i) / 7;
    lights.push_back({middle + glm::dvec3(radius * glm::vec3(std::cos(angle), 0, std::sin(angle))), {}});
  }
  return lights;
}

/// Lights on a small ring, the first at its middle: where --light puts it, or below the ceiling.
std::vector<Size> light_sizes(const scene::Scene& scene, const RenderOptions& options) {
  const scene::Bounds bounds = scene.bounds(scene.pose(0, {}));
  const glm::vec3 extent = bounds.high - bounds.low;
  const glm::dvec3 middle = options.lights.empty() ? scene.in_file(bounds.low + glm::vec3(0.5f, 0.8f, 0.5f) * extent)
                                                   : options.lights.front().position;
  const float radius = 0.04f * glm::length(extent);
  std::vector<Size> sizes;
  for (const uint32_t count : {1u, 2u, 4u, 8u})
    sizes.push_back({double(count), 1, [=](RenderOptions& changed) { changed.lights = ring(middle, radius, count); }});
  return sizes;
}

std::vector<Size> sizes_of(SweepAxis axis, const scene::Scene& scene, const RenderOptions& options) {
  if (axis == SweepAxis::triangles) return triangle_sizes(scene);
  return axis == SweepAxis::pixels ? pixel_sizes(options) : light_sizes(scene, options);
}

double tests_of(const Result& result) { return double(sums_of(result, {}).total); }

/// The variants that are worth running at this size, by the tests of the last one.
std::vector<Variant> affordable(const std::vector<Variant>& variants, const std::vector<SweepStep>& steps,
                                double size) {
  std::vector<Variant> chosen;
  for (const Variant& variant : variants) {
    if (is_brute(variant) || !variant.timed) continue;
    if (!steps.empty()) {
      const auto same = [&](const Result& result) { return result.variant.label == variant.label; };
      const auto last = std::ranges::find_if(steps.back().results, same);
      if (last == steps.back().results.end() || tests_of(*last) * size / steps.back().size > max_sweep_tests) continue;
    }
    chosen.push_back(variant);
  }
  return chosen;
}

struct Figures {
  double tests = 0, tracing = 0, secondary = 0, build = 0, raster = 0;
};

Figures figures_of(const Result& result) {
  return {tests_of(result), tracing_median(result), secondary_median(result),
          result.first_frame.stage_ms[static_cast<size_t>(Stage::object_hierarchy)],
          stage_median(result, Stage::raster)};
}

/// A label's steps: sizes and figures.
using Line = std::vector<std::pair<double, Figures>>;

std::vector<std::pair<std::string, Line>> lines_of(const std::vector<SweepStep>& steps) {
  std::vector<std::pair<std::string, Line>> lines;
  for (const SweepStep& step : steps)
    for (const Result& result : step.results) {
      const std::string name = row_name(result);
      auto found = std::ranges::find_if(lines, [&](const auto& line) { return line.first == name; });
      if (found == lines.end()) found = lines.insert(lines.end(), {name, {}});
      found->second.emplace_back(step.size, figures_of(result));
    }
  return lines;
}

std::vector<std::string> growth_row(const Line& line) {
  const auto& [size, last] = line.back();
  const auto& [first_size, first] = line.front();
  return {fmt::format("growth, {}", ratio_text(size, first_size)),
          ratio_text(last.tests, first.tests),
          ratio_text(last.tracing, first.tracing),
          ratio_text(last.secondary, first.secondary),
          ratio_text(last.build, first.build),
          ratio_text(last.raster, first.raster)};
}

}  // namespace

std::vector<SweepStep> sweep(SweepAxis axis, gpu::Device& device, const scene::Scene& scene,
                             const std::vector<Variant>& variants, const Schedule& schedule, const Progress& progress) {
  std::vector<SweepStep> steps;
  const std::vector<Size> sizes = sizes_of(axis, scene, variants.front().options);
  for (size_t i = 0; i < sizes.size(); ++i) {
    const scene::Scene finer = subdivided(scene, sizes[i].cuts);
    std::vector<Variant> chosen = affordable(variants, steps, sizes[i].size);
    for (Variant& variant : chosen) sizes[i].change(variant.options);
    const auto part = [&](double done) { progress((double(i) + done) / double(sizes.size())); };
    steps.push_back({sizes[i].size, measure(device, finer, chosen, schedule, part)});
  }
  return steps;
}

ChartSection sweep_section(SweepAxis axis, const std::string& scene, const std::vector<SweepStep>& steps) {
  const std::string& name = sweep_names[static_cast<size_t>(axis)];
  ChartSection section{.title = fmt::format("{}: growth with {}", scene, name), .svg = {}, .table = {}};
  section.table = {.title = fmt::format("Growth with {}: {}", name, scene),
                   .columns = {upper(name), "ALL TESTS", "TRACING MS", "SECONDARY MS", "BUILD MS", "RASTER MS"}};
  std::vector<Curve> curves;
  for (const auto& [label, line] : lines_of(steps)) {
    section.table.rows.push_back({label});
    Curve curve{label, {}};
    for (const auto& [size, figures] : line) {
      section.table.rows.push_back({count_text(static_cast<uint64_t>(size)),
                                    count_text(static_cast<uint64_t>(figures.tests)), ms_text(figures.tracing),
                                    ms_text(figures.secondary), ms_text(figures.build), ms_text(figures.raster)});
      if (figures.tracing > 0) curve.points.emplace_back(size, figures.tracing);
    }
    section.table.rows.push_back(growth_row(line));
    curves.push_back(std::move(curve));
  }
  section.table.note = fmt::format(
      "TRACING: traversal and intersection; SECONDARY: from ray creation to there, sorting and ray hierarchy included; "
      "BUILD: the object hierarchy in the first frame.\nA line ends where the next size would need more than {} tests "
      "a frame.",
      count_text(static_cast<uint64_t>(max_sweep_tests)));
  section.svg = curves_svg(curves, name, "tracing, ms", section.title);
  return section;
}

}  // namespace crsh::bench
