// What is shown, and how.

#include <imgui.h>

#include <algorithm>

#include "crsh/kinds.h"
#include "viewer/panels/panels.h"

namespace crsh::viewer {
namespace {

std::vector<std::string> show_names() {
  std::vector<std::string> names;
  for (const ShowRow& row : show_table()) names.emplace_back(row.name);
  return names;
}

void choose_show(Widgets& widgets, const std::string& name, const char* label, Show& show) {
  static const std::vector<std::string> names = show_names();
  std::string chosen;
  if (widgets.choice(name, label, std::string(row_of(show).name), names, chosen))
    show = static_cast<Show>(std::ranges::find(names, chosen) - names.begin());
  widgets.hint(std::string(row_of(show).help));
}

void choose_split(Model& model, Widgets& widgets) {
  if (widgets.check("split", "Compare side by side", model.split) && model.split) model.right.show = model.left.show;
  widgets.hint("Drag the line between the two in the picture");
  if (!model.split) return;
  choose_show(widgets, "right show", "Right: show", model.right.show);
  std::string chosen;
  if (widgets.choice("right algorithm", "Right: traced by", model.other.preset, preset_names(), chosen))
    model.other = preset(chosen);
}

/// How rays are bundled, and what they are tested against.
void choose_nodes_and_boxes(Model& model, Widgets& widgets) {
  const bool order = model.left.show == Show::order || (model.split && model.right.show == Show::order);
  widgets.check("ray nodes", "Ray nodes", model.show_nodes);
  widgets.hint("Balls around where bundled rays start, cones around where they go");
  ImGui::SameLine();
  widgets.check("object bounds", "Object bounds", model.show_bounds);
  widgets.hint("Spheres of meshes, or boxes of the object hierarchy where the algorithm has one");
  if (order || model.show_nodes) {
    std::vector<std::string> kinds;
    for (const RayKind& kind : ray_kinds) kinds.emplace_back(kind.name);
    std::string chosen;
    if (widgets.choice("of rays", "of rays", kinds[model.node_kind], kinds, chosen))
      model.node_kind = uint32_t(std::ranges::find(kinds, chosen) - kinds.begin());
  }
  if (model.show_nodes) {
    int level = int(model.nodes_level);
    if (widgets.whole("of level", "of level", level, 1, 8)) model.nodes_level = uint32_t(level);
    widgets.check("all nodes", "all, not only under the cursor", model.nodes_of_all);
  }
  if (model.show_bounds && model.has_object_hierarchy()) {
    int depth = int(model.box_depth);
    if (widgets.whole("box depth", "Boxes at depth", depth, 1, 8)) model.box_depth = uint32_t(depth);
  }
}

void choose_exposure(Model& model, Widgets& widgets) {
  float stops = model.command.exposure.value_or(0);
  if (widgets.real("exposure", "Exposure", stops, -10, 10, "%.1f stops")) model.command.exposure = stops;
}

}  // namespace

void draw_view_section(Model& model, Widgets& widgets) {
  if (!widgets.header("View", "View", true)) return;
  choose_show(widgets, "show", "Show", model.left.show);
  choose_split(model, widgets);
  choose_nodes_and_boxes(model, widgets);
  choose_exposure(model, widgets);
  if (widgets.button("frame", "Frame all")) model.frame_all();
  ImGui::SameLine();
  if (widgets.button("camera", "Next camera")) model.next_camera(), model.view_moved();
  ImGui::SameLine();
  if (widgets.button("help", "Keys")) model.keys_help = !model.keys_help;
}

}  // namespace crsh::viewer
