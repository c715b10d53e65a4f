#include "bench/report.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>

#include "bench/heat_figures.h"
#include "bench/svg.h"
#include "crsh/version.h"
#include "output/stats_json.h"

namespace crsh::bench {
namespace {

const char* const style = R"(<style>
:root{color-scheme:light}
body{font:15px/1.45 system-ui,sans-serif;color:#1a1a1a;background:#fff;max-width:1200px;
margin:0 auto;padding:0 16px 48px}
h1{font-size:1.6em;margin:.8em 0 .2em}h2{font-size:1.25em;margin:2em 0 .5em;border-bottom:1px solid #bbb}
h3{font-size:1.05em;margin:1.4em 0 .4em}
pre{white-space:pre-wrap;overflow-wrap:anywhere;background:#f3f3f3;padding:8px 10px;font-size:13px}
.wide{overflow-x:auto}table{border-collapse:collapse;font-size:13.5px;font-variant-numeric:tabular-nums}
th,td{padding:2px 7px;text-align:right;white-space:nowrap}
th:first-child,td:first-child{text-align:left;padding-left:2px}
thead th{border-bottom:1px solid #555;font-weight:600}thead .span th{border-bottom:0;text-align:left;padding-left:28px}
th:first-child,td:first-child{position:sticky;left:0;background:#fff}
tbody .group td{font-weight:600;padding-top:9px;border-bottom:1px solid #ddd}
tbody tr:not(.group):hover{background:#f0f5fa}
.note{font-size:13px;color:#444;margin:.4em 0 0}
.chart{display:block;max-width:760px;margin:8px 0;font-size:12px;overflow:visible}
.legend{display:flex;flex-wrap:wrap;gap:4px 16px;font-size:12.5px;margin:4px 0;max-width:760px}
.legend span{display:inline-flex;align-items:center;gap:6px}
.figures{display:grid;grid-template-columns:repeat(auto-fill,minmax(max(165px,23%),1fr));gap:14px}
figure{margin:0}figure img{width:100%;height:auto;display:block;image-rendering:auto}
figcaption{font-size:13px;margin-top:3px}
.scale{max-width:420px;margin:10px 0}.scale img{width:100%;height:14px;display:block}
.scale div{position:relative;height:18px;font-size:12px}
.scale span{position:absolute;transform:translateX(-50%)}.scale span:first-child{transform:none}
.scale span:last-child{transform:translateX(-100%)}
dl{display:grid;grid-template-columns:auto 1fr;gap:2px 14px;margin:.6em 0}dt{color:#555}
dd{margin:0;overflow-wrap:anywhere}
</style>
)";

std::string row_html(const std::vector<std::string>& cells, size_t columns) {
  if (cells.size() == 1 && columns > 1)
    return fmt::format("<tr class='group'><td colspan='{}'>{}</td></tr>\n", columns, escaped(cells[0]));
  std::string html = "<tr>";
  for (const std::string& cell : cells) html += fmt::format("<td>{}</td>", escaped(cell));
  return html + "</tr>\n";
}

std::string note_html(const std::string& note) {
  std::string html = escaped(note);
  for (size_t at = 0; (at = html.find('\n', at)) != std::string::npos; at += 4) html.replace(at, 1, "<br>");
  return note.empty() ? "" : fmt::format("<p class='note'>{}</p>\n", html);
}

std::string table_html(const Table& table) {
  std::string html = fmt::format("<h3>{}</h3>\n<div class='wide'><table><thead>\n", escaped(table.title));
  if (!table.spans.empty()) {
    html += "<tr class='span'><th></th>";
    for (const Span& span : table.spans)
      html += fmt::format("<th colspan='{}'>{}</th>", span.columns, escaped(span.text));
    html += "</tr>\n";
  }
  html += "<tr>";
  for (const std::string& column : table.columns) html += fmt::format("<th>{}</th>", escaped(column));
  html += "</tr></thead><tbody>\n";
  for (const auto& row : table.rows) html += row_html(row, table.columns.size());
  return html + "</tbody></table></div>\n" + note_html(table.note);
}

/// The words quoted so that a shell takes them apart again as they were given.
std::string command_line(const std::vector<std::string>& words) {
  std::vector<std::string> quoted;
  for (const std::string& word : words) {
    const bool plain = !word.empty() && word.find_first_not_of(
                                            "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789-_./,:=+") ==
                                            std::string::npos;
    std::string inner = word;
    for (size_t at = 0; (at = inner.find('\'', at)) != std::string::npos; at += 4) inner.replace(at, 1, "'\\''");
    quoted.push_back(plain ? word : "'" + inner + "'");
  }
  return fmt::format("{}", fmt::join(quoted, " "));
}

std::string machine_html(const Description& description) {
  const gpu::DeviceInfo& device = description.device;
  const auto host = output::host_json();
  return fmt::format(
      "<dl><dt>device</dt><dd>{} ({} {}), {}, Vulkan {}, subgroups of {}</dd><dt>processor</dt><dd>{}, {} threads</dd>"
      "<dt>program</dt><dd>crsh {} ({})</dd><dt>frames</dt><dd>{}{} of each, in turn, after {} for warming up; times "
      "are "
      "medians</dd></dl>\n",
      escaped(device.name), escaped(device.driver), escaped(device.driver_version), escaped(device.type),
      escaped(device.api_version), device.subgroup_size, escaped(host["cpu"].get<std::string>()),
      host["threads"].get<unsigned>(), version, commit, description.schedule.budget_seconds > 0 ? "at most " : "",
      description.schedule.repeat, description.schedule.warmup);
}

/// The tests of each level as bars: of objects first, of single rays last.
BarGroup levels_of(const Result& result, const RayFilter& filter) {
  uint64_t objects = 0, rays_tests = 0;
  std::map<uint32_t, uint64_t, std::greater<>> levels;
  for (const RayStatistics& rays : result.counters.rays) {
    if (!is_counted(rays, filter)) continue;
    objects += rays.object_tests();
    rays_tests += rays.triangle_tests;
    for (const LevelStatistics& level : rays.levels) levels[level.level] += level.tests;
  }
  BarGroup group{row_name(result), {{"objects", double(objects), count_text(objects), 4}}};
  for (const auto& [level, tests] : levels)
    group.bars.push_back({fmt::format("level {}", level), double(tests), count_text(tests), 1});
  group.bars.push_back({"rays", double(rays_tests), count_text(rays_tests), 0});
  return group;
}

std::string levels_html(const SceneResults& scene, const RayFilter& filter) {
  std::vector<BarGroup> groups;
  for (const Result& result : scene.results) groups.push_back(levels_of(result, filter));
  const std::string title = fmt::format("{}: tests a level", scene.name);
  return fmt::format(
      "<h3>{}</h3>\n{}<p class='legend'><span>{}nodes or rays against meshes and boxes</span><span>{}nodes against "
      "triangles</span>"
      "<span>{}rays against triangles</span></p>\n",
      escaped(title), bars_svg(groups, title), swatch(4), swatch(1), swatch(0));
}

std::string times_html(const SceneResults& scene) {
  std::vector<Stack> stacks;
  for (const Result& result : scene.results) {
    if (result.counters.frames.empty() || is_brute(result.variant)) continue;
    Stack stack{row_name(result), "", {}};
    double sum = 0;
    for (size_t stage = 0; stage < stage_count; ++stage) {
      stack.parts.push_back(stage_median(result, static_cast<Stage>(stage)));
      sum += stack.parts.back();
    }
    stack.label = ms_text(sum) + " ms";
    stacks.push_back(std::move(stack));
  }
  const std::vector<std::string> names(stage_names.begin(), stage_names.end());
  const std::string title = fmt::format("{}: time a stage", scene.name);
  return fmt::format("<h3>{}</h3>\n{}", escaped(title), stacks_svg(stacks, names, "ms", title));
}

/// Which variant has the least: "fewest tests: crsh; least time: bvh".
template <class Value>
std::string least(const SceneResults& scene, Value value) {
  const Result* best = nullptr;
  for (const Result& result : scene.results)
    if (value(result) > 0 && (!best || value(result) < value(*best))) best = &result;
  return best ? best->variant.label : "none";
}

std::string sections(const std::vector<Table>& tables) {
  std::string html;
  for (const Table& table : tables) html += table_html(table);
  return html;
}

std::string verdicts_html(const Report& report) {
  std::string html = "<p>";
  for (const SceneResults& scene : report.scenes) html += escaped(verdict(scene, report.filter)) + "<br>\n";
  return html + "</p>\n";
}

std::string scene_html(const SceneResults& scene, const RayFilter& filter) {
  return fmt::format("<h2>{}</h2>\n<p class='note'>{}</p>\n", escaped(scene.name), escaped(scene.path)) +
         heat_figures_html(scene) + levels_html(scene, filter) + times_html(scene) + table_html(table_2(scene, filter));
}

std::string sweeps_html(const std::vector<ChartSection>& sweeps) {
  std::string html;
  for (const ChartSection& section : sweeps)
    html += fmt::format("<h3>{}</h3>\n", escaped(section.title)) + section.svg + table_html(section.table);
  return html.empty() ? "" : "<h2>Growth</h2>\n" + html;
}

}  // namespace

std::string verdict(const SceneResults& scene, const RayFilter& filter) {
  return fmt::format("{}: fewest tests, everything counted: {}; shortest frame: {}.", scene.name,
                     least(scene, [&](const Result& result) { return double(sums_of(result, filter).total); }),
                     least(scene, [](const Result& result) { return frame_median(result); }));
}

std::string report_html(const Report& report) {
  std::vector<std::string> names;
  for (const SceneResults& scene : report.scenes) names.push_back(escaped(scene.name));
  const std::string title = fmt::format("crsh bench: {}", fmt::join(names, ", "));
  std::string html = fmt::format(
      "<!DOCTYPE html>\n<html lang='en'><head><meta charset='utf-8'><meta name='viewport' "
      "content='width=device-width,initial-scale=1'>"
      "<title>{}</title>\n{}</head><body>\n{}<h1>{}</h1>\n",
      title, style, pattern_definitions(), title);
  html += fmt::format("<pre>{}</pre>\n", escaped(command_line(report.description.command))) +
          machine_html(report.description);
  html += "<h2>Tests and times</h2>\n" + verdicts_html(report) + table_html(table_1(report.scenes, report.filter));
  html += table_html(table_3(report.scenes)) + sections(report.others);
  if (!report.ablations.empty()) html += "<h2>What each part is worth</h2>\n" + sections(report.ablations);
  html += sweeps_html(report.sweeps);
  for (const SceneResults& scene : report.scenes) html += scene_html(scene, report.filter);
  return html + "</body></html>\n";
}

}  // namespace crsh::bench
