// What the picture took: time by stage, and counters by level as in the paper's Table 2.

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>

#include "crsh/kinds.h"
#include "viewer/panels/panels.h"

namespace crsh::viewer {
namespace {

/// A number in a few characters: 12,345,678 as "12.3 M".
std::string brief(double count) {
  if (count >= 1e10) return fmt::format("{:.1f} G", count / 1e9);
  if (count >= 1e8) return fmt::format("{:.0f} M", count / 1e6);
  if (count >= 1e6) return fmt::format("{:.1f} M", count / 1e6);
  if (count >= 1e4) return fmt::format("{:.1f} k", count / 1e3);
  return fmt::format("{:.0f}", count);
}

std::string percent(double part, double whole) {
  return whole > 0 ? fmt::format("{:.2f}%", 100 * part / whole) : std::string("-");
}

double brute_force(const RayStatistics& row) { return double(row.count) * double(row.triangles); }

struct Totals {
  double rays = 0, tests = 0, brute = 0;
};

Totals totals_of(const Statistics& statistics) {
  Totals totals;
  for (const RayStatistics& row : statistics.rays) {
    totals.rays += double(row.count);
    totals.tests += double(row.total_tests());
    totals.brute += brute_force(row);
  }
  return totals;
}

void draw_totals(const char* label, const Shown& shown) {
  const Totals totals = totals_of(shown.statistics);
  ImGui::Text("%s%s: %s rays, %s tests,", label, shown.options.algorithm.preset.c_str(), brief(totals.rays).c_str(),
              brief(totals.tests).c_str());
  ImGui::Text("   %s of brute force; %.0f ms", percent(totals.tests, totals.brute).c_str(), shown.milliseconds);
}

void draw_stage(const Model& model, size_t stage, float ms, float longest) {
  const auto& history = model.stage_history[stage];
  const std::vector<float> values(history.begin(), history.end());
  ImGui::TableNextRow();
  ImGui::TableNextColumn();
  ImGui::TextUnformatted(stage_names[stage].data());
  ImGui::TableNextColumn();
  ImGui::ProgressBar(longest > 0 ? ms / longest : 0, {-1, ImGui::GetFontSize()}, fmt::format("{:.1f} ms", ms).c_str());
  ImGui::TableNextColumn();
  ImGui::PlotLines(("##" + std::string(stage_names[stage])).c_str(), values.data(), int(values.size()), 0, nullptr, 0,
                   FLT_MAX, {-1, ImGui::GetFontSize()});
}

void draw_times(const Model& model, Widgets& widgets) {
  if (!widgets.header("Time", "Time of each stage", true) || model.left.shown->statistics.frames.empty()) return;
  const FrameTime& time = model.left.shown->statistics.frames.back();
  const float longest = float(*std::ranges::max_element(time.stage_ms));
  if (!ImGui::BeginTable("times", 3)) return;
  ImGui::TableSetupColumn("stage", ImGuiTableColumnFlags_WidthFixed, ImGui::GetFontSize() * 8.6f);
  ImGui::TableSetupColumn("ms", ImGuiTableColumnFlags_WidthStretch, 1.4f);
  ImGui::TableSetupColumn("history", ImGuiTableColumnFlags_WidthStretch, 1);
  for (size_t stage = 0; stage < stage_count; ++stage) draw_stage(model, stage, float(time.stage_ms[stage]), longest);
  ImGui::EndTable();
}

void cell(const std::string& text) {
  ImGui::TableNextColumn();
  ImGui::TextUnformatted(text.c_str());
}

/// Draws the tests of a kind and bounce: levels from the top, then rays against triangles, then tests against objects.
void draw_row(const RayStatistics& row) {
  const double brute = brute_force(row);
  const auto line = [&](const std::string& what, const std::string& nodes, double tests, const std::string& hits) {
    ImGui::TableNextRow();
    cell(what), cell(nodes), cell(brief(tests)), cell(hits), cell(percent(tests, brute));
  };
  for (const LevelStatistics& level : row.levels)
    line(fmt::format("level {}", level.level), brief(double(level.nodes)), double(level.tests),
         percent(double(level.hits), double(level.tests)));
  line("rays", brief(double(row.count)), double(row.triangle_tests), "");
  if (row.object_tests()) line("objects", "", double(row.object_tests()), "");
  line("all", "", double(row.total_tests()), "");
}

void draw_counters(const Model& model, Widgets& widgets) {
  if (!widgets.header("Counters", "Tests a level (one sample)", true)) return;
  for (const RayStatistics& row : model.left.shown->statistics.rays) {
    if (row.count == 0) continue;
    const std::string title = fmt::format("{} rays, bounce {}", row.kind, row.bounce);
    ImGui::SetNextItemOpen(row.bounce == 0, ImGuiCond_Once);
    const bool open = ImGui::TreeNodeEx(title.c_str(), ImGuiTreeNodeFlags_SpanAvailWidth);
    widgets.note(title);
    if (!open) continue;
    if (ImGui::BeginTable("levels", 5, ImGuiTableFlags_RowBg | ImGuiTableFlags_SizingStretchProp)) {
      for (const char* column : {"", "nodes", "tests", "hit", "of brute"}) ImGui::TableSetupColumn(column);
      ImGui::TableHeadersRow();
      draw_row(row);
      ImGui::EndTable();
    }
    ImGui::TreePop();
  }
}

}  // namespace

void draw_measures(Model& model, Widgets& widgets) {
  if (!model.left.shown) return;
  if (widgets.header("Total", "Total (one sample)", true)) {
    draw_totals(model.split ? "left: " : "", *model.left.shown);
    if (model.split && model.right.shown) draw_totals("right: ", *model.right.shown);
  }
  draw_times(model, widgets);
  draw_counters(model, widgets);
}

}  // namespace crsh::viewer
