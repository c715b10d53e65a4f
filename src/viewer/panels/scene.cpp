// Rays, lights, and the tree of objects.

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <numbers>

#include "crsh/kinds.h"
#include "scene/hide.h"
#include "viewer/panels/panels.h"

namespace crsh::viewer {
namespace {

void draw_light(LightOption& light, size_t index) {
  ImGui::PushID(int(index));
  ImGui::SetNextItemWidth(-1);
  ImGui::DragScalarN("##place", ImGuiDataType_Double, &light.position.x, 3, 0.05f, nullptr, nullptr, "%.2f m");
  ImGui::SetNextItemWidth(-1);
  float candela = light.candela.value_or(0);
  if (ImGui::DragFloat("##candela", &candela, std::max(candela * 0.01f, 0.01f), 0, 1e9f, "%.4g candela"))
    light.candela = std::max(candela, 0.0f);
  ImGui::PopID();
}

/// Adds a light where the eye is, with the intensity that the light of a scene without any gets.
void add_light(Model& model) {
  model.begin_own_view();
  const glm::vec3 at = model.camera.eye(), middle = (model.bounds.low + model.bounds.high) * 0.5f;
  const float distance = model.bounds.empty() ? 1 : std::max(glm::distance(at, middle), 1e-3f);
  model.command.options.lights.push_back(
      {model.scene() ? model.scene()->in_file(at) : glm::dvec3(at), float(std::numbers::pi) * distance * distance});
}

void draw_lights(Model& model, Widgets& widgets) {
  std::vector<LightOption>& lights = model.command.options.lights;
  if (lights.empty() && model.scene())
    for (const scene::Light& light : model.scene()->lights) {
      const char* unit = light.type == scene::LightType::directional ? "lux" : "candela";
      ImGui::BulletText("%s: %.4g %s", light.name.empty() ? "light" : light.name.c_str(), double(light.intensity),
                        unit);
    }
  for (size_t i = 0; i < lights.size(); ++i) draw_light(lights[i], i);
  if (widgets.button("add light", lights.empty() ? "A light here in their place" : "One more here")) add_light(model);
  widgets.hint("A light where the eye is");
  if (lights.empty()) return;
  ImGui::SameLine();
  if (widgets.button("remove light", "Remove") &&
      (lights.size() > 1 || (model.scene() && !model.scene()->lights.empty())))
    lights.pop_back();
}

/// Hides objects, by their index because names need not be unique.
void set_hidden(Model& model, const std::vector<bool>& hidden) {
  model.command.options.hidden.clear();
  for (size_t i = 0; i < hidden.size(); ++i)
    if (hidden[i]) model.command.options.hidden.push_back(std::to_string(i));
}

std::string name_of(const scene::Scene& scene, size_t instance) {
  const std::string& node = scene.nodes[scene.instances[instance].node].name;
  const std::string& mesh = scene.meshes[scene.instances[instance].mesh].name;
  return !node.empty() ? node : !mesh.empty() ? mesh : fmt::format("object {}", instance);
}

/// Draws the scene's nodes with their instances below them, from the roots down.
class Tree {
 public:
  Tree(const scene::Scene& scene, std::vector<bool>& hidden, Widgets& widgets)
      : scene_(scene), hidden_(hidden), widgets_(widgets), children_(scene.nodes.size()), own_(scene.nodes.size()) {
    for (uint32_t n = 0; n < scene.nodes.size(); ++n)
      if (scene.nodes[n].parent) children_[*scene.nodes[n].parent].push_back(n);
    for (uint32_t i = 0; i < scene.instances.size(); ++i) own_[scene.instances[i].node].push_back(i);
  }

  bool draw() {
    for (uint32_t n = 0; n < scene_.nodes.size(); ++n)
      if (!scene_.nodes[n].parent) draw_node(n);
    return changed_;
  }

 private:
  void draw_instance(uint32_t i) {
    bool visible = !hidden_[i];
    const std::string name = fmt::format("object {}", i);
    if (widgets_.check(name, name_of(scene_, i).c_str(), visible)) hidden_[i] = !visible, changed_ = true;
    widgets_.hint(fmt::format("{} triangles", scene_.meshes[scene_.instances[i].mesh].triangles.size()));
  }

  [[nodiscard]] bool has_objects(uint32_t n) const {
    return !own_[n].empty() || std::ranges::any_of(children_[n], [this](uint32_t child) { return has_objects(child); });
  }

  void draw_node(uint32_t n) {
    if (!has_objects(n)) return;
    for (const uint32_t i : own_[n]) draw_instance(i);
    if (std::ranges::none_of(children_[n], [this](uint32_t child) { return has_objects(child); })) return;
    const std::string& name = scene_.nodes[n].name;
    ImGui::PushID(int(n));
    ImGui::SetNextItemOpen(true, ImGuiCond_Once);
    const bool open = ImGui::TreeNodeEx(name.empty() ? "group" : name.c_str(), ImGuiTreeNodeFlags_SpanAvailWidth);
    if (open) {
      for (const uint32_t child : children_[n]) draw_node(child);
      ImGui::TreePop();
    }
    ImGui::PopID();
  }

  const scene::Scene& scene_;
  std::vector<bool>& hidden_;
  Widgets& widgets_;
  std::vector<std::vector<uint32_t>> children_, own_;
  bool changed_ = false;
};

}  // namespace

void draw_rays_section(Model& model, Widgets& widgets) {
  if (!widgets.header("Rays", "Rays and lights", false)) return;
  RenderOptions& options = model.command.options;
  int bounces = int(options.bounces);
  if (widgets.whole("bounces", "Bounces", bounces, 0, 16)) options.bounces = uint32_t(bounces);
  for (size_t kind = 0; kind < kind_count; ++kind)
    widgets.check(std::string(ray_kinds[kind].name), std::string(ray_kinds[kind].name).c_str(), options.rays[kind]);
  widgets.check("override mirror", "Everything a mirror besides", options.override_mirror);
  draw_lights(model, widgets);
}

void draw_scene_section(Model& model, Widgets& widgets) {
  if (!widgets.header("Scene", "Scene", false) || !model.scene()) return;
  const scene::Scene& scene = *model.scene();
  ImGui::TextWrapped("%s", scene.path.filename().string().c_str());
  std::vector<bool> hidden = scene::hidden_instances(scene, model.command.options.hidden);
  const bool any = std::ranges::find(hidden, true) != hidden.end();
  if (any && widgets.button("show all", "Show all")) hidden.assign(hidden.size(), false), set_hidden(model, hidden);
  if (Tree(scene, hidden, widgets).draw()) set_hidden(model, hidden);
}

}  // namespace crsh::viewer
