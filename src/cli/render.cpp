// crsh render: loads, renders, writes.

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <memory>

#include "cli/command.h"
#include "cli/load_scene.h"
#include "cli/mend.h"
#include "cli/render_checks.h"
#include "cli/render_options.h"
#include "cli/say.h"
#include "cli/values.h"
#include "crsh/error.h"
#include "crsh/renderer.h"
#include "gpu/device.h"
#include "output/exposure.h"
#include "output/exr.h"
#include "output/json_text.h"
#include "output/png.h"
#include "output/progress.h"
#include "output/ray_file.h"
#include "output/stats_json.h"
#include "output/whole_file.h"
#include "rays/hash.h"
#include "scene/hide.h"
#include "scene/scene.h"

namespace crsh::cli {
namespace {

const std::string examples =
    "Examples:\n"
    "  crsh render scene.glb -o picture.png\n"
    "  crsh render scene.glb -o picture.exr -o picture.png --size 1920x1080 --samples 4\n"
    "  crsh render scene.glb -o picture.png --eye 0,1.5,4 --target 0,1,0 --light 2,3,2\n"
    "  crsh render scene.glb -o 'film-{frame}.png' --frames 0..47 --fps 24\n"
    "  crsh render scene.glb -o - --quiet > picture.png\n"
    "  crsh render scene.glb -o picture.exr --algorithm crsh-2017 --stats counters.json\n";

/// What a run keeps from frame to frame.
struct Run {
  RenderCommand& command;
  Renderer& renderer;
  output::Progress& progress;
  std::optional<double> exposure;  ///< of PNG files, once known: an automatic one is the first frame's
  uint64_t clamped = 0;            ///< half values, in all files
  uint64_t exr_pixels = 0;         ///< of all files
  RayTable rays = {};              ///< for --dump-rays
  [[nodiscard]] RayTable* dump() { return command.dump_rays.empty() ? nullptr : &rays; }
};

std::string line_of(const output::ExposureAdvice& advice) {
  if (!advice.better) return advice.reason;
  return fmt::format("{}: --exposure {} mends it (or --exposure auto)", advice.reason, *advice.better);
}

/// Settles the exposure by the first picture, and says so when it shows little.
double exposure_of(Run& run, const Layer& beauty) {
  if (run.exposure) return *run.exposure;
  const auto& asked = run.command.exposure;
  run.exposure = asked ? double(*asked) : output::automatic_exposure(beauty);
  run.progress.clear();
  if (!asked) say(run.command, fmt::format("exposure: {}", *run.exposure));
  if (const auto advice = output::exposure_advice(beauty, *run.exposure)) say(run.command, line_of(*advice));
  return *run.exposure;
}

void write_picture(Run& run, const Picture& picture, const output::PathPattern& pattern, const FrameTask& task) {
  const std::string path = pattern.at(task.number);
  if (pattern.format() == output::Format::exr) {
    run.clamped += output::write_exr(path, picture, picture_layers(run.command.options.layers),
                                     attributes_of(run.command, task.seconds), run.command.ids);
    run.exr_pixels += uint64_t(picture.width) * picture.height;
  } else {
    const Layer& beauty = *picture.find("");
    const std::string bytes = output::encode_png(beauty, picture.width, picture.height, exposure_of(run, beauty));
    pattern.to_stdout() ? output::write_stdout(bytes) : output::write_whole(path, bytes);
  }
  run.progress.written(path);
}

void write_dump(Run& run) {
  output::write_rays(run.command.dump_rays, run.rays);
  run.progress.written(run.command.dump_rays);
}

/// Renders all frames; returns the last picture without its layers, for the statistics.
Picture render_frames(Run& run) {
  Picture picture;
  const std::vector<FrameTask> tasks = frame_tasks(run.command);
  for (uint32_t index = 0; index < tasks.size(); ++index) {
    const FrameTask& task = tasks[index];
    const auto progress = [&](double done) { run.progress.update(task.number, index, done); };
    picture = run.renderer.render(task.seconds, progress, run.dump());
    run.progress.update(task.number, index, 1);
    for (const output::PathPattern& pattern : run.command.outputs) write_picture(run, picture, pattern, task);
    if (run.dump()) write_dump(run);
  }
  run.progress.clear();
  picture.layers.clear();
  return picture;
}

/// The rays of --replay-rays, of the kinds that --rays has.
RayTable read_replay(const RenderCommand& command) {
  const RayTable all = output::read_rays(command.replay_rays);
  const auto& keys = command.options.algorithm.keys;
  if (all.key.empty() && std::ranges::find(keys, rays::key_of_file) != keys.end())
    throw UserError(fmt::format("{}: has no array 'key', which --key file needs", command.replay_rays));
  std::vector<uint32_t> rows;
  for (uint32_t row = 0; row < all.size(); ++row)
    if (command.options.rays[all.kind[row]]) rows.push_back(row);
  return rows_of(all, rows);
}

/// Raises `bounces` so that there are counters for every bounce of these rays.
void count_bounces_of(const RayTable& rays, uint32_t& bounces) {
  for (const uint32_t bounce : rays.bounce) bounces = std::max(bounces, bounce);
}

void replay(Run& run, const RayTable& rays) {
  run.renderer.replay(rays, frame_tasks(run.command).front().seconds, run.dump());
  if (run.dump()) write_dump(run);
}

void write_stats(const Run& run, const gpu::Device& device, const Picture& last, const std::vector<std::string>& line) {
  const RenderCommand& command = run.command;
  const output::RunDescription description{.command = line,
                                           .options = effective_options(render_options(run.command)),
                                           .device = device.info(),
                                           .scene = command.scene,
                                           .world_to_camera = last.world_to_camera,
                                           .world_to_ndc = last.world_to_ndc,
                                           .width = last.width,
                                           .height = last.height,
                                           .samples = command.options.samples,
                                           .algorithm = command.options.algorithm.preset,
                                           .replayed = !command.replay_rays.empty()};
  const std::string text = output::json_text(output::stats_json(description, run.renderer.statistics()));
  command.stats == "-" ? output::write_stdout(text) : output::write_whole(command.stats, text);
}

/// A highlight or two beyond what half floats hold is nothing to be alarmed at; more than every thousandth pixel is.
void say_clamped(const Run& run) {
  const bool matters = run.clamped * 1000 > run.exr_pixels;
  if (run.clamped && (matters || run.command.verbose))
    say(run.command, fmt::format("{} values beyond 65504, the largest half, were clamped to it", run.clamped));
}

/// Milliseconds a stage, the mean over all frames. Pipelines are made in the first one alone.
void say_stage_times(const RenderCommand& command, const Statistics& statistics) {
  if (!command.verbose || statistics.frames.empty()) return;
  const auto row = [&](std::string_view name, double sum) {
    say(command, fmt::format("{:<20}{:>12.2f} ms", name, sum / double(statistics.frames.size())));
  };
  double total = 0, pipelines = 0;
  for (const FrameTime& frame : statistics.frames) total += frame.total_ms, pipelines += frame.pipeline_ms;
  for (size_t stage = 0; stage < stage_count; ++stage) {
    double sum = 0;
    for (const FrameTime& frame : statistics.frames) sum += frame.stage_ms[stage];
    row(stage_names[stage], sum);
  }
  row("pipelines", pipelines);
  row("frame, wall clock", total);
}

void say_what_runs(const RenderCommand& command, const scene::Scene& scene, const gpu::DeviceInfo& device) {
  if (!scene.unsupported.empty())
    say(command, fmt::format("{}: not supported and left out: {}", command.scene, fmt::join(scene.unsupported, "; ")));
  say(command, fmt::format("device: {} ({} {}), {}", device.name, device.driver, device.driver_version, device.type));
}

/// The camera and the lights as options to paste, and more.
void say_what_was_chosen(const RenderCommand& command, const Renderer& renderer) {
  if (renderer.chosen_view()) say(command, "no camera was given: " + option_of(*renderer.chosen_view()));
  const std::string why = command.options.lights.empty() ? "the scene has no light: " : "";
  for (const LightOption& light : renderer.chosen_lights()) say(command, why + option_of(light));
  for (const std::string& note : renderer.notes()) say(command, note);
}

/// Drops layers that no output file holds, so that they are not rendered.
void drop_unused_layers(RenderCommand& command) {
  const auto is_exr = [](const output::PathPattern& pattern) { return pattern.format() == output::Format::exr; };
  if (std::ranges::none_of(command.outputs, is_exr)) command.options.layers = {LayerId::beauty};
}

scene::LoadOptions load_options(const RenderCommand& command) {
  return {.scene = command.options.scene,
          .reach = reach_of(command.allow_outside),
          .variant = command.options.variant,
          .lenient = command.lenient};
}

void run_render(RenderCommand& command, const std::vector<std::string>& line) {
  check_combinations(command);
  check_places(command);
  drop_unused_layers(command);
  const auto scene = std::make_shared<scene::Scene>(load_scene(command.scene, load_options(command)));
  scene::hide(*scene, command.options.hidden);
  const RayTable rays = command.replay_rays.empty() ? RayTable() : read_replay(command);
  count_bounces_of(rays, command.options.bounces);
  if (command.progress == ProgressChoice::json)
    command.device.on_validation = [&command](const std::string& message) { say(command, message); };
  const auto device = std::make_shared<gpu::Device>(command.device);
  say_what_runs(command, *scene, device->info());
  Renderer renderer(device, scene, command.options);
  say_what_was_chosen(command, renderer);
  command.options = renderer.options();

  const auto frames = static_cast<uint32_t>(frame_tasks(command).size());
  output::Progress progress(progress_mode(command), frames);
  Run run{command, renderer, progress, {}};
  Picture last;
  command.replay_rays.empty() ? void(last = render_frames(run)) : replay(run, rays);
  say_clamped(run);
  if (!command.stats.empty()) write_stats(run, *device, last, line);
  say_stage_times(command, renderer.statistics());
}

}  // namespace

Command render_command() {
  auto command = std::make_shared<RenderCommand>();
  return {.name = "render",
          .summary = "Renders a glTF scene (.gltf or .glb) to OpenEXR or PNG.",
          .positionals = {{.name = "SCENE", .set = [command](const std::string& path) { command->scene = path; }}},
          .groups = render_options(*command),
          .epilogue = presets_help() + "\n" + layers_help() + "\n" + examples,
          .run = [command](const std::vector<std::string>& line) { run_render(*command, line); }};
}

}  // namespace crsh::cli
