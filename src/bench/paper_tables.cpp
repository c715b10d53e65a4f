#include "bench/paper_tables.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <span>

namespace crsh::bench {
namespace {

/// "sponza: 256.71 K shadow rays (k = 0)".
std::string rays_of(const SceneResults& scene, const RayFilter& filter) {
  std::vector<std::string> parts;
  for (const RayStatistics& rays : scene.results.front().counters.rays)
    if (rays.count && is_counted(rays, filter))
      parts.push_back(fmt::format("{} {} (k = {})", count_text(rays.count), rays.kind, rays.bounce));
  return fmt::format("{}: {} rays", scene.name, parts.empty() ? "no" : fmt::format("{}", fmt::join(parts, ", ")));
}

std::string counted_note(const SceneResults& scene) {
  for (const Result& result : scene.results)
    if (!result.counted_from.empty())
      return fmt::format("Brute force was counted, not traced: rays (as cast under {}) x triangles.\n",
                         result.counted_from);
  return "";
}

std::string printed_note(const SceneResults& scene) {
  const auto as_printed = [](const Result& result) {
    return result.variant.options.algorithm.cone_test == ConeTest::as_printed;
  };
  return std::ranges::any_of(scene.results, as_printed)
             ? "cone-test=printed is equation 9 to the letter, which lets through what lies behind a node.\n"
             : "";
}

/// A row a variant with a figure a scene, where `cell` gives that of a result.
template <class Cell>
std::vector<std::string> row_over_scenes(const std::vector<SceneResults>& scenes, std::string name, size_t variant,
                                         Cell cell) {
  std::vector<std::string> row = {std::move(name)};
  for (const SceneResults& scene : scenes) cell(scene, scene.results[variant], row);
  return row;
}

/// SH, RE, RF.
std::string abbreviation(std::string_view kind) {
  static const std::map<std::string_view, std::string> known = {
      {"shadow", "SH"}, {"reflection", "RE"}, {"refraction", "RF"}};
  const auto found = known.find(kind);
  return found == known.end() ? upper(kind) : found->second;
}

/// Sums for one kind of rays over all counted bounces, by level; level 0 has the rays themselves.
struct KindLevels {
  struct Level {
    uint64_t tests = 0, hits = 0;
  };
  std::map<uint32_t, Level> levels;
  uint64_t rays = 0;
};

KindLevels levels_of(const Result& result, std::string_view kind, const RayFilter& filter) {
  KindLevels sums;
  for (const RayStatistics& rays : result.counters.rays) {
    if (rays.kind != kind || !is_counted(rays, filter)) continue;
    sums.rays += rays.count;
    sums.levels[0].tests += rays.triangle_tests;
    for (const LevelStatistics& level : rays.levels) {
      sums.levels[level.level].tests += level.tests;
      sums.levels[level.level].hits += level.hits;
    }
  }
  return sums;
}

bool has_nodes(const Result& result) {
  return std::ranges::any_of(result.counters.rays, [](const RayStatistics& rays) { return !rays.levels.empty(); });
}

uint32_t top_level(const SceneResults& scene, const RayFilter& filter) {
  uint32_t top = 0;
  for (const Result& result : scene.results)
    for (const RayKind& kind : ray_kinds)
      for (const auto& [level, sums] : levels_of(result, kind.name, filter).levels)
        if (sums.tests) top = std::max(top, level);
  return top;
}

/// "# SH INTERSECTIONS", "# SH MISSES" and "# SH HITS" of one kind, levels from the top.
void add_kind(Table& table, const KindLevels& sums, std::string_view kind, uint32_t top) {
  std::vector<std::string> tests, misses, hits;
  for (const auto& [row, name] : {std::pair{&tests, "INTERSECTIONS"}, {&misses, "MISSES"}, {&hits, "HITS"}})
    row->push_back(fmt::format("# {} {}", abbreviation(kind), name));
  for (uint32_t level = top + 1; level-- > 0;) {
    const auto found = sums.levels.find(level);
    const bool here = found != sums.levels.end() && found->second.tests;
    tests.push_back(here ? count_text(found->second.tests) : "");
    misses.push_back(here && level ? count_text(found->second.tests - found->second.hits) : "");
    hits.push_back(here && level ? count_text(found->second.hits) : "");
  }
  for (auto* row : {&tests, &misses, &hits}) table.rows.push_back(std::move(*row));
}

constexpr std::array paper_stages = {Stage::ray_creation, Stage::ray_compression, Stage::ray_sorting,
                                     Stage::ray_decompression, Stage::hierarchy_creation};
constexpr std::array costly_stages = {Stage::hierarchy_traversal, Stage::final_intersection};
constexpr std::array other_stages = {Stage::object_hierarchy, Stage::raster, Stage::shading};

double median_of_sums(const Result& result, std::span<const Stage> stages) {
  std::vector<double> values;
  for (const FrameTime& frame : result.counters.frames) {
    values.push_back(0);
    for (const Stage stage : stages) values.back() += frame.stage_ms[static_cast<size_t>(stage)];
  }
  return median(std::move(values));
}

/// The paper's name.
std::string name_of(Stage stage) {
  return upper(stage_names[static_cast<size_t>(stage)]) + (stage == Stage::final_intersection ? " TESTS" : "");
}

void add_times(Table& table, const std::vector<SceneResults>& scenes, size_t variant) {
  const auto add = [&](const std::string& name, auto milliseconds) {
    table.rows.push_back(row_over_scenes(scenes, name, variant, [&](const auto&, const Result& result, auto& row) {
      row.push_back(ms_text(milliseconds(result)));
    }));
  };
  const auto add_stage = [&](Stage stage) {
    add(name_of(stage), [stage](const Result& result) { return stage_median(result, stage); });
  };
  table.rows.push_back({row_name(scenes.front().results[variant])});
  std::ranges::for_each(paper_stages, add_stage);
  std::ranges::for_each(costly_stages, add_stage);
  std::ranges::for_each(other_stages, add_stage);
  if (has_object_hierarchy(scenes.front().results[variant].variant))
    add("OBJECT HIERARCHY, FIRST FRAME",
        [](const Result& result) { return result.first_frame.stage_ms[static_cast<size_t>(Stage::object_hierarchy)]; });
  add("ALL SECONDARY COST", secondary_median);
  add("WHOLE FRAME", [](const Result& result) { return frame_median(result); });
}

/// How many times faster than the `reference`th variant.
void add_ratios(Table& table, const std::vector<SceneResults>& scenes, size_t variant, size_t reference) {
  const auto& first = scenes.front().results;
  const auto add = [&](const std::string& name, auto milliseconds) {
    std::vector<std::string> row = {name};
    for (const SceneResults& scene : scenes)
      row.push_back(ratio_text(milliseconds(scene.results[reference]), milliseconds(scene.results[variant])));
    table.rows.push_back(std::move(row));
  };
  table.rows.push_back(
      {fmt::format("{} vs {}", row_name(first[variant]), upper(first[reference].variant.options.algorithm.preset))});
  for (const Stage stage : costly_stages)
    if (stage_median(first[reference], stage) > 0)
      add(name_of(stage), [stage](const Result& result) { return stage_median(result, stage); });
  add("BOTH TOGETHER", tracing_median);
  add("ALL SECONDARY COST", secondary_median);
}

/// The first variant of a preset.
std::optional<size_t> variant_named(const std::vector<SceneResults>& scenes, std::string_view preset) {
  const auto& results = scenes.front().results;
  for (size_t i = 0; i < results.size(); ++i)
    if (results[i].variant.options.algorithm.preset == preset) return i;
  return {};
}

bool is_timed(const std::vector<SceneResults>& scenes, size_t variant) {
  return std::ranges::all_of(
      scenes, [&](const SceneResults& scene) { return !scene.results[variant].counters.frames.empty(); });
}

/// How many frames were timed: "58", or "7 to 58" where scenes differ.
std::string frames_text(const std::vector<SceneResults>& scenes) {
  size_t least = SIZE_MAX, most = 0;
  for (const SceneResults& scene : scenes)
    for (const Result& result : scene.results) {
      const size_t frames = result.counters.frames.size();
      if (frames) least = std::min(least, frames), most = std::max(most, frames);
    }
  return least < most ? fmt::format("{} to {}", least, most) : std::to_string(most);
}

}  // namespace

bool is_counted(const RayStatistics& rays, const RayFilter& filter) {
  const auto fits = [&](const CountedRays& wanted) {
    return ray_kinds[wanted.kind].name == rays.kind && (!wanted.bounce || *wanted.bounce == rays.bounce);
  };
  return filter.empty() || std::ranges::any_of(filter, fits);
}

std::string row_name(const Result& result) {
  const std::string& preset = result.variant.options.algorithm.preset;
  const std::string rest = result.variant.label.substr(std::min(preset.size(), result.variant.label.size()));
  if (preset == "brute") return "Brute Force" + rest;
  if (preset == "rah") return "RAH Algorithm" + rest;
  if (preset.starts_with("crsh")) return fmt::format("Our Algorithm ({})", result.variant.label);
  return fmt::format("Single rays ({})", result.variant.label);
}

Sums sums_of(const Result& result, const RayFilter& filter) {
  Sums sums;
  for (const RayStatistics& rays : result.counters.rays) {
    if (!is_counted(rays, filter)) continue;
    sums.rays += rays.count;
    sums.brute_force += rays.count * rays.triangles;
    sums.paper += rays.paper_tests();
    sums.total += rays.total_tests();
  }
  return sums;
}

double stage_median(const Result& result, Stage stage) {
  std::vector<double> values;
  for (const FrameTime& frame : result.counters.frames) values.push_back(frame.stage_ms[static_cast<size_t>(stage)]);
  return median(std::move(values));
}

double tracing_median(const Result& result) { return median_of_sums(result, costly_stages); }

double secondary_median(const Result& result) {
  std::vector<Stage> stages(paper_stages.begin(), paper_stages.end());
  stages.insert(stages.end(), costly_stages.begin(), costly_stages.end());
  return median_of_sums(result, stages);
}

double frame_median(const Result& result) {
  std::vector<double> values;
  for (const FrameTime& frame : result.counters.frames) values.push_back(frame.total_ms);
  return median(std::move(values));
}

Table table_1(const std::vector<SceneResults>& scenes, const RayFilter& filter) {
  const auto is_film = [](const SceneResults& scene) { return scene.results.front().variant.seconds.size() > 1; };
  const std::string_view frames = std::ranges::any_of(scenes, is_film) ? "all frames" : "one frame";
  Table table{.title = fmt::format("Table 1: global rendering performance, intersection tests of {}", frames),
              .columns = {"ALGORITHM"}};
  for (const SceneResults& scene : scenes) {
    table.spans.push_back({upper(scene.name), 3});
    table.columns.insert(table.columns.end(), {"TOTAL # ISECT", "RELATIVE %", "EVERYTHING %"});
  }
  for (size_t variant = 0; variant < scenes.front().results.size(); ++variant)
    table.rows.push_back(row_over_scenes(
        scenes, row_name(scenes.front().results[variant]), variant, [&](const auto&, const Result& result, auto& row) {
          const Sums sums = sums_of(result, filter);
          row.insert(row.end(), {count_text(sums.paper), percent_text(sums.paper, sums.brute_force),
                                 percent_text(sums.total, sums.brute_force)});
        }));
  for (const SceneResults& scene : scenes) table.note += rays_of(scene, filter) + "\n";
  table.note += counted_note(scenes.front()) + printed_note(scenes.front());
  table.note +=
      "TOTAL # ISECT counts as the paper: nodes and rays against triangles. EVERYTHING adds tests of meshes and boxes.";
  return table;
}

Table table_2(const SceneResults& scene, const RayFilter& filter) {
  Table table{.title = fmt::format("Table 2: {}, rendering details", scene.name), .columns = {""}};
  const uint32_t top = top_level(scene, filter);
  for (uint32_t level = top; level > 0; --level) table.columns.push_back(fmt::format("LEVEL {}", level));
  table.columns.emplace_back("RAYS");
  for (const Result& result : scene.results) {
    if (!has_nodes(result)) continue;
    table.rows.push_back({row_name(result)});
    for (const RayKind& kind : ray_kinds)
      if (const KindLevels sums = levels_of(result, kind.name, filter); sums.rays)
        add_kind(table, sums, kind.name, top);
  }
  table.note = "Tests of a level's nodes against triangles; RAYS: of single rays against triangles.";
  return table;
}

Table table_3(const std::vector<SceneResults>& scenes) {
  Table table{.title = "", .columns = {"TIME (MS)"}};
  for (const SceneResults& scene : scenes) table.columns.push_back(upper(scene.name));
  const size_t variants = scenes.front().results.size();
  for (size_t variant = 0; variant < variants; ++variant)
    if (is_timed(scenes, variant)) add_times(table, scenes, variant);
  for (const char* rival : {"rah", "bvh"})
    if (const auto reference = variant_named(scenes, rival); reference && is_timed(scenes, *reference))
      for (size_t variant = 0; variant < variants; ++variant)
        if (variant != *reference && is_timed(scenes, variant) && !is_brute(scenes.front().results[variant].variant))
          add_ratios(table, scenes, variant, *reference);
  table.title = fmt::format("Table 3: render times, medians of {} interleaved frames", frames_text(scenes));
  table.note =
      "vs: how many times faster. ALL SECONDARY COST: from ray creation to final intersection, without the object "
      "hierarchy.";
  return table;
}

}  // namespace crsh::bench
