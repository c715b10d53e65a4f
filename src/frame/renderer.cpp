#include "crsh/renderer.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>

#include "crsh/assertion.h"
#include "crsh/error.h"
#include "frame/built.h"
#include "frame/state.h"
#include "scene/device/device_materials.h"
#include "scene/playing.h"

namespace crsh {
namespace {

using Clock = std::chrono::steady_clock;

/// Pairs of a candidate list where memory is short: two batches of triangles.
constexpr uint64_t frugal_pairs = 65536;

/// Adds what a frame counted to the run's sums.
void add(Statistics& sum, const Statistics& frame) {
  for (size_t r = 0; r < frame.rays.size(); ++r) {
    RayStatistics& to = sum.rays[r];
    const RayStatistics& from = frame.rays[r];
    to.count += from.count;
    to.hits += from.hits;
    to.hits_digest += from.hits_digest;
    to.chunks += from.chunks;
    to.mesh_tests += from.mesh_tests;
    to.box_tests += from.box_tests;
    to.triangle_tests += from.triangle_tests;
    to.alpha_tests += from.alpha_tests;
    if (to.levels.size() < from.levels.size()) to.levels.resize(from.levels.size());
    for (size_t l = 0; l < from.levels.size(); ++l) {
      LevelStatistics& level = to.levels[l];
      level.level = from.levels[l].level;
      level.nodes += from.levels[l].nodes;
      level.half_angle_sum += from.levels[l].half_angle_sum;
      level.radius_sum += from.levels[l].radius_sum;
      level.tests += from.levels[l].tests;
      level.hits += from.levels[l].hits;
    }
  }
}

/// Whether every triangle blocks shadow rays, and is seen from its back, too.
bool all_plain(const scene::Scene& scene) {
  for (uint32_t i = 0; i < scene.materials.size(); ++i)
    if (scene::flagged_material(scene, i) != i) return false;
  return true;
}

/// Applies options: sets all state that depends on them. Throws before it changes anything.
void apply(Renderer::State& s, RenderOptions options) {
  trace::require_sound(options.algorithm);
  trace::require_device(s.device, options.algorithm);
  scene::Playing playing = scene::playing(s.scene, options.animation);
  const scene::Pose pose = s.scene.pose(0, playing.animations);
  const scene::Bounds bounds = s.scene.bounds(pose);
  const raster::ImageSize size = raster::image_size(s.scene, options);
  options.width = size.width;
  options.height = size.height;
  const raster::CameraView view = raster::camera_view(s.scene, pose, options, bounds, size);
  scene::LightRig lights = scene::resolve_lights(s.scene, options.lights, bounds, {view.eye, view.right, view.up});
  if (!s.counters || options.bounces != s.options.bounces) s.counters.emplace(s.device, options.bounces);
  s.animations = std::move(playing.animations);
  s.notes = s.gpu_scene.notes;
  if (!playing.note.empty()) s.notes.push_back(playing.note);
  s.first_bounds = bounds;
  s.size = size;
  s.lights = std::move(lights);
  s.options = std::move(options);
  s.chosen_view = raster::chosen_view(s.scene, s.options, bounds, size);
  s.statistics = {};
  s.statistics.triangles = s.gpu_scene.triangle_count;
  s.statistics.meshes = s.scene.meshes.size();
  s.statistics.instances = s.scene.instances.size();
  s.statistics.rays = trace::empty_rows(s.options.bounces, s.gpu_scene.triangle_count);
}

void load(Renderer::State& s) {
  s.gpu_scene = scene::upload(s.device, s.scene);
  s.structures.plain = all_plain(s.scene);
  apply(s, s.options);
}

/// Frees all lists that grew while frames were rendered.
void drop_lists(Renderer::State& s) {
  s.recorder.submit();
  s.paths = {};
  s.batch = {};
}

/// Fills what state.dump asks for, and counts to state.frame_statistics.
using Frame = std::function<void()>;

/// Tries to render a frame. Counters, times and rays start from nothing, so that a second try counts nothing twice.
void attempt(Renderer::State& s, const Frame& frame) {
  s.placing = false;
  s.frame_statistics = {};
  s.frame_statistics.rays = trace::empty_rows(s.options.bounces, s.gpu_scene.triangle_count);
  if (s.dump.rays) *s.dump.rays = {};
  if (s.dump.nodes) s.dump.nodes->clear();
  s.dump.rays_seen = 0;
  s.counters->clear(s.recorder);
  s.recorder.submit();
  (void)s.recorder.profiler().take_milliseconds();
  (void)s.recorder.take_pipeline_milliseconds();
  const Clock::time_point start = Clock::now();
  frame();
  const double elapsed = std::chrono::duration<double, std::milli>(Clock::now() - start).count();
  s.counters->add_to(s.recorder, s.frame_statistics);
  s.frame_statistics.frames.push_back(
      {elapsed, s.recorder.profiler().take_milliseconds(), s.recorder.take_pipeline_milliseconds()});
}

/// Tries again with smaller portions where a generation outgrew a binding.
void attempt_in_portions(Renderer::State& s, const Frame& frame) {
  for (;;) {
    try {
      return attempt(s, frame);
    } catch (const PortionTooLarge&) {
      drop_lists(s);
      s.portion /= 2;
    }
  }
}

/// The least memory that this frame needs, MiB: measured, by rendering it frugally without a bound.
uint64_t least_memory(Renderer::State& s, const Frame& frame) {
  drop_lists(s);
  s.structures.objects = {};  // its build is measured, too
  s.max_pairs = frugal_pairs;
  s.device.forget_peak();
  attempt_in_portions(s, frame);
  return (s.device.peak_bytes() >> 20) + 1;
}

/// Ends a run that does not fit `budget`, with a line that says how much it needs. `s` must be loaded, under another
/// budget if need be.
[[noreturn]] void refuse_budget(Renderer::State& s, const Frame& frame, uint64_t budget) {
  s.device.set_memory_budget(0);
  const uint64_t least = least_memory(s, frame);
  s.device.set_memory_budget(budget);
  throw UserError(
      fmt::format("a memory budget of {} MiB is too little for this scene and size; it needs at least {} MiB",
                  budget >> 20, least),
      Mend::more_memory);
}

[[noreturn]] void report(const gpu::OutOfMemory& shortage, Mend mend) {
  const std::string limit = shortage.available ? fmt::format("the budget allows {} MiB", shortage.available >> 20)
                                               : std::string("the device has no more");
  throw UserError(fmt::format("out of device memory: '{}' would bring it to {} MiB, and {}", shortage.name,
                              (shortage.needed >> 20) + 1, limit),
                  mend);
}

/// Adds a frame that was rendered to the run's statistics.
void finish(Renderer::State& s) {
  s.statistics.lights = s.gpu_scene.light_count;
  add(s.statistics, s.frame_statistics);
  const objects::Hierarchy& objects = s.structures.objects;
  s.statistics.object_hierarchy = {objects.builds + s.structures.device_objects.builds, objects.refits, objects.cost};
  s.statistics.frames.push_back(s.frame_statistics.frames.front());
  s.statistics.device_peak_bytes = std::max(s.statistics.device_peak_bytes, s.device.peak_bytes());
}

/// Renders a frame. Where memory is short, tries once more with short lists.
void run(Renderer::State& s, const Frame& frame) {
  try {
    attempt_in_portions(s, frame);
    return finish(s);
  } catch (const gpu::OutOfMemory&) {
    drop_lists(s);
    s.max_pairs = frugal_pairs;
  }
  try {
    attempt_in_portions(s, frame);
    return finish(s);
  } catch (const gpu::OutOfMemory& shortage) {
    if (shortage.available) refuse_budget(s, frame, s.device.request().memory_budget);
    report(shortage, Mend::smaller_image);
  }
}

}  // namespace

Renderer::Renderer(DevicePtr device, ScenePtr scene, const RenderOptions& options) {
  CRSH_ASSERT(device && scene, "a renderer needs a device and a scene");
  state_ = std::make_unique<State>(device, scene, options);
  try {
    load(*state_);
    return;
  } catch (const gpu::OutOfMemory& shortage) {
    if (!shortage.available) report(shortage, Mend::smaller_scene_or_other_device);
  }
  const uint64_t budget = device->request().memory_budget;
  try {
    device->set_memory_budget(0);
    state_ = std::make_unique<State>(device, scene, options);
    load(*state_);
    const Frame first_frame = [this] { (void)render_frame(*state_, 0, {}); };
    refuse_budget(*state_, first_frame, budget);
  } catch (const gpu::OutOfMemory& shortage) {
    device->set_memory_budget(budget);
    report(shortage, Mend::smaller_image);
  }
}

Renderer::~Renderer() = default;
Renderer::Renderer(Renderer&&) noexcept = default;
Renderer& Renderer::operator=(Renderer&&) noexcept = default;

Picture Renderer::render(double seconds, const Progress& progress, RayTable* dump) {
  Picture picture;
  state_->dump.rays = dump;
  run(*state_, [&] { picture = render_frame(*state_, seconds, progress); });
  if (dump) dump->width = picture.width, dump->height = picture.height, dump->centre = centre();
  return picture;
}

void Renderer::replay(const RayTable& rays, double seconds, RayTable* dump) {
  state_->dump.rays = dump;
  run(*state_, [&] { replay_rays(*state_, rays, seconds); });
}

Picture Renderer::refine(double seconds, const Progress& progress) {
  Picture picture;
  state_->dump.rays = nullptr;
  attempt(*state_, [&] { picture = refine_frame(*state_, seconds, progress); });
  finish(*state_);
  return picture;
}

void Renderer::change(const RenderOptions& options) { apply(*state_, options); }

void Renderer::forget_objects() { state_->structures.objects = {}; }

void Renderer::on_submit(std::function<void()> call) {
  if (!call) return state_->recorder.on_submit({});
  state_->recorder.on_submit([state = state_.get(), call = std::move(call)] {
    if (!state->placing) call();
  });
}

void Renderer::watch_nodes(std::vector<RayNode>* nodes) { state_->dump.nodes = nodes; }

std::vector<ObjectBox> Renderer::object_boxes(uint32_t depth) {
  if (!trace::tracer_of(state_->options.algorithm).needs.object_hierarchy) return {};
  return crsh::object_boxes(state_->recorder, state_->structures.objects, depth);
}

const Statistics& Renderer::statistics() const { return state_->statistics; }
const RenderOptions& Renderer::options() const { return state_->options; }
const std::optional<ViewOption>& Renderer::chosen_view() const { return state_->chosen_view; }
const std::vector<LightOption>& Renderer::chosen_lights() const { return state_->lights.chosen; }
glm::dvec3 Renderer::centre() const { return state_->scene.origin; }
const std::vector<std::string>& Renderer::notes() const { return state_->notes; }

}  // namespace crsh
