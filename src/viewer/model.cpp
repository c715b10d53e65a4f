#include "viewer/model.h"

#include <fmt/format.h>

#include <algorithm>

#include "crsh/error.h"
#include "output/exposure.h"
#include "raster/camera.h"
#include "scene/device/world_lights.h"
#include "scene/hide.h"
#include "scene/playing.h"
#include "trace/tracers.h"

namespace crsh::viewer {
namespace {

using Clock = std::chrono::steady_clock;
using namespace std::chrono_literals;

constexpr auto rests_after = 200ms;
constexpr size_t history = 48;  // pictures

/// Puts the options that belong to a scene, as its camera and lights, back to their defaults, for a new scene.
void forget_scene(RenderOptions& options) {
  const RenderOptions fresh;
  options.scene = fresh.scene, options.camera = fresh.camera, options.animation = fresh.animation;
  options.view = fresh.view, options.lights = fresh.lights, options.hidden = fresh.hidden;
}

raster::CameraView view_of(const Model& m) {
  RenderOptions options = m.command.options;
  options.width = std::max(m.area.width, 1u), options.height = std::max(m.area.height, 1u);
  return raster::camera_view(*m.scene(), m.scene()->pose(m.seconds, m.animations()), options, m.bounds,
                             {options.width, options.height});
}

/// Gives every light of the options its intensity, so that what was chosen for this view stays when the view changes.
void settle_lights(Model& m) {
  std::vector<LightOption>& lights = m.command.options.lights;
  const raster::CameraView view = view_of(m);
  const scene::LightRig rig = scene::resolve_lights(*m.scene(), lights, m.bounds, {view.eye, view.right, view.up});
  lights.clear();
  for (const shared::Light& light : rig.fixed)
    lights.push_back({m.scene()->in_file(glm::vec3(light.position)), light.colour.x, light.colour.w != 0});
}

/// The view of the camera, which moves in the drawn world, in the file's coordinates.
ViewOption in_file(const scene::Scene& scene, ViewOption view) {
  view.eye = scene.in_file(glm::vec3(*view.eye)), view.target = scene.in_file(glm::vec3(*view.target));
  return view;
}

float usual_distance(const Model& m, const raster::CameraView& view) {
  if (m.bounds.empty()) return 1;
  const float radius = glm::length(m.bounds.high - m.bounds.low) * 0.5f;
  const float along = glm::dot((m.bounds.low + m.bounds.high) * 0.5f - view.eye, view.forward);
  return std::max(along, std::max(radius * 0.1f, 1e-3f));
}

}  // namespace

Model::Model(const Arguments& given) : arguments(given), command(given.render), other(preset("bvh")) {
  seconds = given.render.seconds.value_or(0);
  if (!given.render.scene.empty()) path = given.render.scene, load = 1;
}

const std::vector<uint32_t>& Model::animations() const {
  const std::string& which = command.options.animation;
  if (playing_.loaded == loaded && playing_.which == which) return playing_.animations;
  playing_ = {loaded, which, {}};
  if (!scene()) return playing_.animations;
  try {
    playing_.animations = scene::playing(*scene(), which).animations;
  } catch (const UserError&) {
    playing_.animations = scene::playing(*scene(), "").animations;
  }
  return playing_.animations;
}

float Model::duration() const { return scene() ? scene::duration(*scene(), animations()) : 0; }

void Model::say(const std::string& text, bool error) {
  messages.push_back({text, error, Clock::now() + (error ? 12s : 5s)});
  if (messages.size() > 4) messages.erase(messages.begin());
}

void Model::open(const std::string& new_path) {
  path = new_path;
  ++load;
}

void Model::take(const LoadedPtr& scene_) {
  const bool again = loaded && loaded->scene.path == scene_->scene.path;
  const bool first = !loaded;
  loaded = scene_;
  if (!again && !first) {
    forget_scene(command.options);
    own_view = false, seconds = 0, playing = false;
  }
  bounds = scene()->bounds(scene()->pose(0, animations()));
  command.scene = scene()->path.string();
  if (again) {
    try {
      (void)scene::hidden_instances(*scene(), command.options.hidden);
    } catch (const UserError&) {
      command.options.hidden.clear();
    }
    return;
  }
  settle_lights(*this);
  if (!scene()->unsupported.empty()) say(fmt::format("left out: {}", scene()->unsupported.front()));
}

void Model::take_pictures(const News& latest) {
  news = latest;
  const bool ours = news.left && loaded && news.left->scene == loaded->number;
  left.shown = ours ? news.left : left.shown;
  right.shown = two_pictures() ? news.right : left.shown;
  left.node_frame = news.left_node_frame;
  right.node_frame = news.right_node_frame;
  if (!left.shown || left.shown->serial == history_serial || left.shown->statistics.frames.empty()) return;
  history_serial = left.shown->serial;
  const FrameTime& time = left.shown->statistics.frames.back();
  for (size_t stage = 0; stage < stage_count; ++stage) {
    stage_history[stage].push_back(float(time.stage_ms[stage]));
    if (stage_history[stage].size() > history) stage_history[stage].pop_front();
  }
}

void Model::begin_own_view() {
  if (own_view || !scene()) return;
  const raster::CameraView view = view_of(*this);
  camera = orbit_of(view, usual_distance(*this, view), command.options.view.up);
  own_view = true;
}

void Model::view_moved() { moved = Clock::now(); }

void Model::next_camera() {
  if (!scene() || scene()->cameras.empty()) return say("the scene has no cameras of its own");
  const uint32_t count = uint32_t(scene()->cameras.size());
  camera_index = own_view ? camera_index % count : (camera_index + 1) % count;
  own_view = false;
  command.options.view = {};
  command.options.camera = std::to_string(camera_index);
  const std::string& name = scene()->cameras[camera_index].name;
  say(fmt::format("camera {} of {}{}", camera_index + 1, count, name.empty() ? "" : ": " + name));
}

void Model::frame_all() {
  begin_own_view();
  if (!scene()) return;
  camera.frame(scene()->bounds(scene()->pose(seconds, animations())), aspect());
  view_moved();
}

void Model::change_projection() {
  begin_own_view();
  if (!scene()) return;
  camera.change_projection(scene()->bounds(scene()->pose(seconds, animations())));
  say(camera.orthographic ? "orthographic" : "perspective");
  view_moved();
}

bool Model::fine() const {
  const auto is_fine = [this](const ShownPtr& shown) { return shown && shown->fine && shown->wish == wish_number; };
  return !wish_moves && is_fine(left.shown) && (!two_pictures() || is_fine(news.right));
}

/// The news may be older than the wish: what rests is named by its number.
bool Model::rests() const { return !wish_moves && wish_number && news.rests_at == wish_number; }

double Model::exposure() const {
  if (command.exposure || !left.shown) return command.exposure.value_or(0);
  return output::automatic_exposure(*left.shown->picture.find(""));
}

bool Model::moving() const { return playing || Clock::now() - moved < rests_after; }

bool Model::has_object_hierarchy() const { return trace::tracer_of(command.options.algorithm).needs.object_hierarchy; }

Wish Model::wish() const {
  Wish wish;
  wish.path = path;
  wish.which = command.options.scene;
  wish.allow_outside = command.allow_outside;
  wish.lenient = command.lenient;
  wish.load = load;
  wish.scene = loaded ? loaded->number : 0;
  RenderOptions& options = wish.options = command.options;
  options.width = std::max(area.width, 1u), options.height = std::max(area.height, 1u);
  options.samples = 1;
  options.layers = {LayerId::beauty};
  options.layers.add(row_of(left.show).layers);
  if (split) options.layers.add(row_of(right.show).layers);
  if (exr_wanted) options.layers.add(command.options.layers);
  if (own_view) options.view = scene() ? in_file(*scene(), camera.view()) : camera.view(), options.camera.clear();
  const bool order = left.show == Show::order || (split && right.show == Show::order);
  const bool boxes = show_bounds && has_object_hierarchy();
  if (order || show_nodes || boxes) wish.node_kind = node_kind;
  wish.seconds = seconds;
  wish.moving = moving();
  wish.budget_ms = arguments.budget_ms;
  wish.max_samples = arguments.max_samples;
  if (two_pictures()) wish.other = other;
  return wish;
}

}  // namespace crsh::viewer
