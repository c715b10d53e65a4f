#include "cli/render_checks.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <set>

#include "crsh/error.h"
#include "output/whole_file.h"
#include "rays/hash.h"

namespace crsh::cli {
namespace {

[[noreturn]] void misuse(const std::string& what) { throw UserError(what + " (see crsh help render)", Exit::usage); }

void check_outputs(const RenderCommand& command) {
  if (command.outputs.empty() && command.dump_rays.empty() && command.replay_rays.empty())
    misuse("-o FILE is missing: where shall the picture go");
  const auto on_stdout = std::ranges::count_if(command.outputs, &output::PathPattern::to_stdout);
  if (on_stdout + (command.stats == "-") > 1) misuse("two outputs on standard output: give one of them a file");
  if (on_stdout && ::isatty(STDOUT_FILENO)) misuse("-o -: standard output is a terminal: redirect it, or name a file");
  if (!command.frames || command.frames->first == command.frames->last) return;
  for (const output::PathPattern& pattern : command.outputs)
    if (!pattern.has_frame()) misuse(fmt::format("-o {}: several frames need {{frame}} in the path", pattern.text()));
}

/// --dump-rays writes the rays of one picture to an .npz file; --replay-rays traces rays of such a file, and makes no
/// picture.
void check_rays(const RenderCommand& command) {
  const auto& keys = command.options.algorithm.keys;
  const bool replays = !command.replay_rays.empty(), dumps = !command.dump_rays.empty();
  if (!replays && std::ranges::find(keys, rays::key_of_file) != keys.end())
    misuse("--key file: the keys are those of --replay-rays, which is missing");
  if (dumps && !command.dump_rays.ends_with(".npz"))
    misuse(fmt::format("--dump-rays {}: .npz is written", command.dump_rays));
  if ((dumps || replays) && command.frames)
    misuse("--dump-rays and --replay-rays are for one picture: give --time, not --frames");
  if (!replays) return;
  if (!command.outputs.empty()) misuse("--replay-rays makes no picture: give --stats or --dump-rays in place of -o");
  if (command.stats.empty() && !dumps)
    misuse("--replay-rays: give --stats FILE or --dump-rays FILE for what becomes of the rays");
}

/// Throws where two outputs or frames have the same file.
void check_distinct(const RenderCommand& command) {
  std::set<std::filesystem::path> seen;
  const auto add = [&](const std::string& path) {
    if (path != "-" && !seen.insert(std::filesystem::path(path).lexically_normal()).second)
      misuse(path + ": two outputs into one file");
  };
  if (!command.stats.empty()) add(command.stats);
  if (!command.dump_rays.empty()) add(command.dump_rays);
  for (const output::PathPattern& pattern : command.outputs) add(pattern.at(0));
}

}  // namespace

void check_view(const ViewOption& view, const std::string& camera) {
  if (!camera.empty() && (view.eye || view.target))
    misuse("--camera is one of the file's, --eye and --target your own: give one");
  if (view.fov_degrees && view.orthographic_height)
    misuse("--fov is of perspective, --orthographic of parallel lines: give one");
  if (view.eye && view.target && *view.eye == *view.target) misuse("--eye and --target are the same point");
}

void check_time(const RenderCommand& command) {
  if (command.seconds && command.frames) misuse("--time is for one picture, --frames for many: give one");
}

void check_combinations(const RenderCommand& command) {
  check_time(command);
  check_view(command.options.view, command.options.camera);
  check_rays(command);
  check_outputs(command);
  check_distinct(command);
}

void check_places(const RenderCommand& command) {
  if (!command.stats.empty() && command.stats != "-") output::check_writable(command.stats);
  if (!command.dump_rays.empty()) output::check_writable(command.dump_rays);
  for (const FrameTask& task : frame_tasks(command))
    for (const output::PathPattern& pattern : command.outputs)
      if (!pattern.to_stdout()) output::check_writable(pattern.at(task.number));
}

}  // namespace crsh::cli
