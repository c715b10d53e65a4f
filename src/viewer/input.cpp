#include "viewer/input.h"

#include <GLFW/glfw3.h>
#include <imgui.h>

#include <cmath>
#include <numbers>

#include "scene/hide.h"
#include "viewer/pick.h"

namespace crsh::viewer {
namespace {

constexpr float wheel_step = 0.88f;
constexpr float near_split = 6;  // as near to the line between two pictures it can be dragged
constexpr float right_angle = float(std::numbers::pi) / 2;

/// A point of the window as a place in the picture, -1..1 an axis, y up.
glm::vec2 place_in(const Layout& layout, glm::vec2 at) {
  const glm::vec2 share = (at - layout.low()) / (layout.high() - layout.low());
  return {2 * share.x - 1, 1 - 2 * share.y};
}

bool is_inside(const Layout& layout, glm::vec2 at) {
  return glm::all(glm::greaterThanEqual(at, layout.low())) && glm::all(glm::lessThan(at, layout.high()));
}

void set_pivot(Model& model, glm::vec2 place) {
  if (!model.scene()) return;
  model.begin_own_view();
  const auto hidden = scene::hidden_instances(*model.scene(), model.command.options.hidden);
  const scene::Pose pose = model.scene()->pose(model.seconds, model.animations());
  const auto point = pick(*model.scene(), pose, hidden, model.camera.sight(place, model.aspect()));
  if (!point) return;
  model.camera.look_at(*point);
  model.view_moved();
}

void fly(Model& model, const Window& window) {
  const auto pull = [&](int forth, int back) { return float(window.is_down(forth)) - float(window.is_down(back)); };
  const glm::vec3 by(pull('D', 'A'), pull('E', 'Q'), pull('W', 'S'));
  if (by == glm::vec3(0) || !model.scene()) return;
  model.begin_own_view();
  const float size = model.bounds.empty() ? 1 : glm::length(model.bounds.high - model.bounds.low);
  const float speed = size * (window.shift() ? 0.8f : 0.2f);  // a second
  model.camera.fly(by * (speed * std::min(ImGui::GetIO().DeltaTime, 0.1f)));
  model.view_moved();
}

void look_from(Model& model, float yaw, float pitch) {
  model.begin_own_view();
  model.camera.turn_to(yaw, pitch);
  model.view_moved();
}

}  // namespace

void Input::begin_drag(const Model& model, const Window& window, const Layout& layout) {
  const ImGuiIO& io = ImGui::GetIO();
  const glm::vec2 at(io.MousePos.x, io.MousePos.y);
  if (io.WantCaptureMouse || !is_inside(layout, at) || !model.scene()) return;
  const float line = layout.low().x + model.split_place * (layout.high().x - layout.low().x);
  const bool left = ImGui::IsMouseClicked(0), middle = ImGui::IsMouseClicked(2);
  if (left && model.split && std::abs(at.x - line) <= near_split) drag_ = Drag::split;
  else if (middle || (left && window.shift())) drag_ = Drag::pan;
  else if (left) drag_ = Drag::orbit;
}

void Input::drag(Model& model, const Layout& layout) const {
  const ImGuiIO& io = ImGui::GetIO();
  const glm::vec2 delta(io.MouseDelta.x, io.MouseDelta.y), size = layout.high() - layout.low();
  if (delta == glm::vec2(0)) return;
  if (drag_ == Drag::split)
    return void(model.split_place = glm::clamp((io.MousePos.x - layout.low().x) / size.x, 0.0f, 1.0f));
  model.begin_own_view();
  if (drag_ == Drag::orbit) model.camera.orbit(delta / size.y);
  else model.camera.pan(delta / size.y);
  model.view_moved();
}

void Input::handle_pointer(Model& model, const Window& window, const Layout& layout) {
  const ImGuiIO& io = ImGui::GetIO();
  if (!io.MouseDown[0] && !io.MouseDown[2]) drag_ = Drag::none;
  if (drag_ == Drag::none) begin_drag(model, window, layout);
  if (drag_ != Drag::none) drag(model, layout);
  const glm::vec2 at(io.MousePos.x, io.MousePos.y);
  if (io.WantCaptureMouse || !is_inside(layout, at) || !model.scene()) return;
  if (io.MouseWheel != 0) {
    model.begin_own_view();
    model.camera.zoom(std::pow(wheel_step, io.MouseWheel), place_in(layout, at), model.aspect());
    model.view_moved();
  }
  if (ImGui::IsMouseDoubleClicked(0)) set_pivot(model, place_in(layout, at));
}

void Input::handle_key(Model& model, const KeyPress& press, std::vector<Action>& actions) {
  switch (press.key) {
    case GLFW_KEY_ENTER:
    case GLFW_KEY_KP_ENTER: return model.frame_all();
    case '1':
    case GLFW_KEY_KP_1: return look_from(model, 0, 0);
    case '3':
    case GLFW_KEY_KP_3: return look_from(model, right_angle, 0);
    case '7':
    case GLFW_KEY_KP_7: return look_from(model, 0, right_angle);
    case '5':
    case GLFW_KEY_KP_5: return model.change_projection();
    case GLFW_KEY_TAB: return model.next_camera(), model.view_moved();
    case GLFW_KEY_SPACE: return void(model.playing = !model.animations().empty() && !model.playing);
    case 'H': return void(model.keys_help = !model.keys_help);
    case 'N': return void(model.panels = !model.panels);
    case GLFW_KEY_ESCAPE: return void(model.keys_help = false);
    case GLFW_KEY_F5: return model.path.empty() ? void() : model.open(model.path);
    case GLFW_KEY_F12: return actions.push_back(press.shift ? Action::save_exr : Action::save_png);
    case 'C': return actions.push_back(Action::copy_command);
    default: break;
  }
}

std::vector<Action> Input::handle(Model& model, Window& window, const Layout& layout) {
  std::vector<Action> actions;
  handle_pointer(model, window, layout);
  const std::vector<KeyPress> keys = window.take_keys();
  if (ImGui::GetIO().WantTextInput) return actions;
  for (const KeyPress& press : keys) handle_key(model, press, actions);
  fly(model, window);
  return actions;
}

}  // namespace crsh::viewer
