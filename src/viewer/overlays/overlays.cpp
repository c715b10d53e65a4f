#include "viewer/overlays/overlays.h"

#include <fmt/format.h>
#include <imgui.h>

#include "output/heat_map.h"

namespace crsh::viewer {
namespace {

constexpr ImU32 white = IM_COL32(255, 255, 255, 255), shade = IM_COL32(0, 0, 0, 170);

void draw_text(ImDrawList& list, glm::vec2 at, const std::string& text) {
  const ImVec2 size = ImGui::CalcTextSize(text.c_str());
  list.AddRectFilled({at.x - 4, at.y - 2}, {at.x + size.x + 4, at.y + size.y + 2}, shade, 3);
  list.AddText({at.x, at.y}, white, text.c_str());
}

/// Draws the heat scale with its ticks, at the picture's upper right.
void draw_heat_scale(ImDrawList& list, const Layout& layout, double end) {
  const float text = ImGui::GetFontSize(), width = std::min(16 * text, layout.high().x - layout.low().x - 5 * text);
  if (width < 6 * text) return;
  const glm::vec2 at(layout.high().x - width - 2.5f * text, layout.low().y + text);
  list.AddRectFilled({at.x - text, at.y - 0.5f * text}, {at.x + width + 2 * text, at.y + 3.6f * text}, shade, 4);
  constexpr int steps = 64;
  for (int i = 0; i < steps; ++i) {
    const auto c = output::heat_colour((i + 0.5) / steps);
    const float from = at.x + width * float(i) / steps, to = at.x + width * float(i + 1) / steps;
    list.AddRectFilled({from, at.y}, {to, at.y + text}, IM_COL32(c[0], c[1], c[2], 255));
  }
  for (const output::HeatTick& tick : output::heat_ticks(end)) {
    const float x = at.x + width * float(tick.place);
    list.AddLine({x, at.y + text}, {x, at.y + 1.3f * text}, white);
    const ImVec2 size = ImGui::CalcTextSize(tick.label.c_str());
    list.AddText({x - size.x / 2, at.y + 1.3f * text}, white, tick.label.c_str());
  }
  list.AddText({at.x, at.y + 2.4f * text}, white, "tests a pixel");
}

std::string side_text(const Side& side) {
  return fmt::format("{}: {}", side.shown->options.algorithm.preset, row_of(side.show).name);
}

void draw_split(ImDrawList& list, const Model& model, const Layout& layout) {
  const float x = layout.low().x + model.split_place * (layout.high().x - layout.low().x), text = ImGui::GetFontSize();
  list.AddLine({x, layout.low().y}, {x, layout.high().y}, white, 2);
  const float middle = (layout.low().y + layout.high().y) / 2;
  list.AddCircleFilled({x, middle}, 0.5f * text, white);
  const std::string left = side_text(model.left);
  draw_text(list, {x - ImGui::CalcTextSize(left.c_str()).x - text, layout.high().y - 2.2f * text}, left);
  if (model.right.shown) draw_text(list, {x + text, layout.high().y - 2.2f * text}, side_text(model.right));
}

}  // namespace

void draw_overlays(const Model& model, const Layout& layout, double heat) {
  if (!model.left.shown) return;
  ImDrawList& list = *ImGui::GetBackgroundDrawList();
  list.PushClipRect({layout.low().x, layout.low().y}, {layout.high().x, layout.high().y});
  draw_nodes_and_boxes(model, layout);
  if (model.split) draw_split(list, model, layout);
  if (heat > 0 && (is_heat(model.left.show) || (model.split && is_heat(model.right.show))))
    draw_heat_scale(list, layout, heat);
  list.PopClipRect();
}

}  // namespace crsh::viewer
