#include "viewer/args.h"

#include <algorithm>
#include <array>

#include "cli/render_checks.h"
#include "cli/rows.h"
#include "crsh/error.h"
#include "output/whole_file.h"
#include "rays/hash.h"

namespace crsh::viewer {
namespace {

using cli::Option;

/// Tests a submit, fewer than `crsh render` has, so that the window gets the device often enough.
constexpr uint64_t submit_work = uint64_t(1) << 22;

/// Options of `crsh render` that make no sense for one picture in a window.
constexpr std::array left_out = {"output", "stats", "dump-rays", "replay-rays", "progress", "verbose", "frames", "fps"};

const std::string epilogue =
    "Examples:\n"
    "  crsh-view scene.glb\n"
    "  crsh-view scene.glb --algorithm crsh-2017 --budget 30\n"
    "  crsh-view scene.glb --after 16 --save picture.png --print-command\n"
    "\nIn the window, H shows all keys.\n";

cli::OptionGroup viewer_options(Arguments& a) {
  const auto after = [&a](const std::string& text) {
    a.after = static_cast<uint32_t>(cli::parse_integer(text, 1, 1000000));
  };
  return {"Viewer",
          {cli::real("--budget", "MS",
                     "Milliseconds that a frame may take while the camera moves: its resolution falls until it fits.",
                     a.budget_ms, 1, 10000),
           cli::flag("--watch", "Load the scene anew when its file changes.", a.watch),
           cli::text("--script", "FILE", "Do what this file lists (src/viewer/README.md), then end.", a.script),
           {.names = "--after", .value = "N", .help = "End after N presented frames of full refinement.", .set = after},
           cli::text("--screenshot", "FILE.png", "At the end, save the whole window.", a.screenshot),
           cli::text("--save", "FILE", "At the end, save what F12 saves (.png), or Shift+F12 (.exr).", a.save),
           cli::flag("--print-command", "At the end, print the command line that C copies.", a.print_command)}};
}

std::vector<cli::OptionGroup> options_of(Arguments& a) {
  std::vector<cli::OptionGroup> groups = {viewer_options(a)};
  for (cli::OptionGroup& group : cli::render_options(a.render)) {
    std::erase_if(group.options,
                  [](const Option& option) { return std::ranges::find(left_out, option.key()) != left_out.end(); });
    for (Option& option : group.options)
      if (option.key() == "samples") option.initial = "64, one after the other while the picture rests";
    if (!group.options.empty()) groups.push_back(std::move(group));
  }
  return groups;
}

cli::Command command_of(Arguments& a) {
  return {.name = "view",
          .summary = "Shows a glTF scene (.gltf or .glb) in a window, and how its rays are traced.",
          .call = "crsh-view",
          .help = "crsh-view --help",
          .positionals = {{.name = "SCENE",
                           .required = false,
                           .set = [&a](const std::string& path) { a.render.scene = path; }}},
          .groups = options_of(a),
          .epilogue = epilogue,
          .run = {}};
}

void check(const Arguments& a) {
  cli::check_view(a.render.options.view, a.render.options.camera);
  const auto& keys = a.render.options.algorithm.keys;
  if (std::ranges::find(keys, rays::key_of_file) != keys.end())
    throw UserError("--key file: only crsh render --replay-rays has keys of a file", Exit::usage);
  if (!a.save.empty() && !a.save.ends_with(".png") && !a.save.ends_with(".exr"))
    throw UserError("--save " + a.save + ": .png or .exr is written", Exit::usage);
}

}  // namespace

std::optional<Arguments> parse_arguments(const std::vector<std::string>& arguments) {
  Arguments a;
  a.render.options.samples = 0;  // unless it is given
  a.render.options.submit_work = submit_work;
  const cli::Command command = command_of(a);
  if (!cli::parse(command, arguments)) {
    output::write_stdout(cli::help_of(command));
    return {};
  }
  if (a.render.options.samples) a.max_samples = a.render.options.samples;
  a.render.options.samples = 1;
  const bool ends = !a.script.empty() || !a.screenshot.empty() || !a.save.empty() || a.print_command;
  if (ends && !a.after) a.after = 1;
  check(a);
  return a;
}

}  // namespace crsh::viewer
