#include "viewer/panels/panels.h"

#include <imgui.h>

namespace crsh::viewer {
namespace {

constexpr ImGuiWindowFlags fixed = ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoTitleBar |
                                   ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoNav;

bool begin_panel(const char* name, float left, float width, float height) {
  ImGui::SetNextWindowPos({left, 0});
  ImGui::SetNextWindowSize({width, height});
  return ImGui::Begin(name, nullptr, fixed);
}

void draw_left(Model& model, Widgets& widgets, bool with_measures) {
  draw_view_section(model, widgets);
  draw_algorithm_section(model, widgets);
  if (with_measures) draw_measures(model, widgets);
  draw_rays_section(model, widgets);
  draw_scene_section(model, widgets);
}

}  // namespace

Layout layout_of(const Model& model, glm::vec2 window, float text) {
  Layout layout{.window = window};
  layout.status = window.y > 12 * text ? text * 1.9f : 0;
  layout.bottom = layout.status * (model.animations().empty() ? 1.0f : 2.0f);
  if (model.panels && window.x > 34 * text) layout.left = 20 * text;
  if (model.panels && window.x > 72 * text) layout.right = 23 * text;
  return layout;
}

void draw_panels(Model& model, Widgets& widgets, const Layout& layout) {
  const float height = layout.window.y - layout.bottom;
  if (layout.left > 0 && begin_panel("controls", 0, layout.left, height)) draw_left(model, widgets, layout.right == 0);
  if (layout.left > 0) ImGui::End();
  if (layout.right > 0 && begin_panel("measures", layout.window.x - layout.right, layout.right, height))
    draw_measures(model, widgets);
  if (layout.right > 0) ImGui::End();
  if (layout.status > 0) draw_bottom(model, widgets, layout);
  draw_messages(model, layout);
  draw_keys_help(model, layout);
}

}  // namespace crsh::viewer
