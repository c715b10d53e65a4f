#include "cli/render_options.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <limits>

#include "cli/rows.h"
#include "crsh/error.h"

namespace crsh::cli {
namespace {

using Json = nlohmann::ordered_json;
constexpr uint64_t mebibyte = uint64_t(1) << 20;

FrameRange parse_frames(const std::string& text) {
  const std::string allowed = "FIRST..LAST is allowed, 0 to 999999, as in 0..47";
  const size_t dots = text.find("..");
  if (dots == std::string::npos) refuse(allowed);
  FrameRange range;
  try {
    range.first = static_cast<uint32_t>(parse_integer(text.substr(0, dots), 0, 999999));
    range.last = static_cast<uint32_t>(parse_integer(text.substr(dots + 2), 0, 999999));
  } catch (const UserError&) {
    refuse(allowed);
  }
  if (range.last < range.first) refuse("the last frame comes before the first");
  return range;
}

Option frames_row(std::optional<FrameRange>& frames) {
  return {.names = "--frames",
          .value = "A..B",
          .help = "Render frames A to B, both included. Frame N is at N / fps seconds.",
          .set = [&frames](const std::string& text) { frames = parse_frames(text); },
          .get = [&frames] { return frames ? Json(fmt::format("{}..{}", frames->first, frames->last)) : Json(); }};
}

/// The time is no attribute by itself, because each frame has its own: see frame_tasks.
Option time_row(std::optional<float>& seconds) {
  return {
      .names = "--time",
      .value = "SECONDS",
      .help = "Render the scene at this time of its animation.",
      .set = [&seconds](const std::string& text) { seconds = parse_real(text, 0, std::numeric_limits<float>::max()); },
      .get = [&seconds] { return seconds ? json_of(*seconds) : Json(); },
      .pixels = true,
      .initial = "0"};
}

OptionGroup time_options(RenderCommand& command) {
  return {
      "Time",
      {time_row(command.seconds),
       frames_row(command.frames),
       {.names = "--fps",
        .value = "N",
        .help = "Frames a second.",
        .set = [&fps = command.frames_per_second](const std::string& text) { fps = parse_real(text, 0.001f, 100000); },
        .get = [&fps = command.frames_per_second] { return json_of(fps); }},
       changes_pixels(with_default(
           "those that move different things",
           text("--animation", "INDEX|NAME|all", "Which of the file's animations.", command.options.animation)))}};
}

Option memory_row(uint64_t& bytes) {
  return {.names = "--max-memory",
          .value = "MIB",
          .help = "Device memory to use at most, in MiB.",
          .set = [&bytes](const std::string& text) { bytes = parse_integer(text, 1, uint64_t(1) << 24) * mebibyte; },
          .get = [&bytes] { return bytes ? Json(bytes / mebibyte) : Json(); }};
}

Option mutation_row(std::optional<std::string>& mutation) {
  return {.names = "--mutation",
          .value = "NAME",
          .help = "A fault to switch on.",
          .set = [&mutation](const std::string& text) { mutation = text; },
          .get = [&mutation] { return mutation ? Json(*mutation) : Json(); },
          .pixels = true,
          .hidden = true};
}

OptionGroup device_options(RenderCommand& command) {
  auto& device = command.device;
  return {"Device",
          {with_default("a GPU before a software device",
                        text("--device", "INDEX|NAME|UUID", "See crsh info.", device.selector)),
           with_default("no limit", memory_row(device.memory_budget)),
           integer("--submit-work", "TESTS",
                   "Tests that are given to the device at once, 65536 or more: less keeps a desktop responsive.",
                   command.options.submit_work, uint64_t(1) << 16, uint64_t(1) << 40),
           flag("--validation", "Run with the Vulkan validation layers.", device.validation),
           hidden(not_effective(integer("--first-capacity", "BYTES", "First size of growing buffers.",
                                        device.first_capacity, 1, uint64_t(1) << 40))),
           mutation_row(command.options.mutation)}};
}

Option exposure_row(std::optional<float>& exposure) {
  return {.names = "--exposure",
          .value = "EV|auto",
          .help = "Brightness of a PNG in stops; EXR files keep the light as it is.",
          .set =
              [&exposure](const std::string& text) {
                exposure = text == "auto" ? std::nullopt : std::optional(parse_real(text, -64, 64));
              },
          .get = [&exposure] { return exposure ? json_of(*exposure) : Json("auto"); }};
}

Option output_row(std::vector<output::PathPattern>& outputs) {
  return {
      .names = "-o,--output",
      .value = "FILE",
      .help =
          "Where the picture goes: .exr, .png, or - for PNG on standard output. {frame} becomes the frame's number in "
          "four digits, {frame:N} in N. Repeats.",
      .set = [&outputs](const std::string& path) { outputs.emplace_back(path); },
      .repeats = true};
}

OptionGroup output_options(RenderCommand& command) {
  return {
      "Output",
      {output_row(command.outputs), exposure_row(command.exposure), layers_option(command.options.layers),
       not_effective(choice("--ids", "float|uint", "Type of Object.id and Material.id in an EXR; float: exact to 2^24.",
                            command.ids, {"float", "uint"})),
       not_effective(text("--stats", "FILE|-", "Write counters and times of the run as JSON.", command.stats)),
       not_effective(text("--dump-rays", "FILE.npz",
                          "Write every ray with its key, sorted place and hit as arrays of NumPy's. Needs no -o.",
                          command.dump_rays)),
       not_effective(text("--replay-rays", "FILE.npz",
                          "Trace these rays in place of a picture's: for --stats and --dump-rays, without -o.",
                          command.replay_rays)),
       with_default("auto: a bar on a terminal; json: all that is said, an object a line",
                    not_effective(choice("--progress", "auto|json|none", "Say on standard error how far the render is.",
                                         command.progress, {"auto", "json", "none"}))),
       not_effective(flag("-q,--quiet", "Say nothing but errors.", command.quiet)),
       not_effective(flag("-v,--verbose", "Say how long each stage took.", command.verbose))}};
}

}  // namespace

std::vector<OptionGroup> render_options(RenderCommand& command) {
  return {output_options(command),
          picture_options(command.options),
          scene_options(command),
          time_options(command),
          algorithm_options(command.options.algorithm),
          device_options(command)};
}

output::Attributes attributes_of(RenderCommand& command, double seconds) {
  nlohmann::ordered_json values = effective_options(render_options(command), true);
  values["time"] = seconds;
  output::Attributes attributes;
  for (const auto& [name, value] : values.items()) attributes.emplace_back("crsh:" + name, text_of(value));
  return attributes;
}

std::vector<FrameTask> frame_tasks(const RenderCommand& command) {
  if (!command.frames) return {{0, command.seconds.value_or(0)}};
  std::vector<FrameTask> tasks;
  for (uint32_t number = command.frames->first; number <= command.frames->last; ++number)
    tasks.push_back({number, number / double(command.frames_per_second)});
  return tasks;
}

}  // namespace crsh::cli
