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

std::string with_commas(const std::vector<std::string_view>& words) { return fmt::format("{}", fmt::join(words, ",")); }

Json text_or_null(const std::optional<glm::vec3>& vector) { return vector ? Json(text_of(*vector)) : Json(); }

Option vector_row(std::string names, std::string help, std::optional<glm::vec3>& variable) {
  return {.names = std::move(names),
          .value = "X,Y,Z",
          .help = std::move(help),
          .set = [&variable](const std::string& text) { variable = parse_vector(text); },
          .get = [&variable] { return text_or_null(variable); },
          .pixels = true};
}

void set_size(const std::string& text, RenderOptions& options) {
  const std::vector<std::string> sides = split(text, 'x');
  try {
    if (sides.size() != 2) refuse("");
    options.width = static_cast<uint32_t>(parse_integer(sides[0], 1, output::longest_side));
    options.height = static_cast<uint32_t>(parse_integer(sides[1], 1, output::longest_side));
  } catch (const UserError&) {
    refuse(fmt::format("WIDTHxHEIGHT is allowed, each from 1 to {}, as in 640x480", output::longest_side));
  }
}

Option size_row(RenderOptions& options) {
  return {
      .names = "--size",
      .value = "WxH",
      .help = "Size in pixels.",
      .set = [&options](const std::string& text) { set_size(text, options); },
      .get = [&options] { return options.width ? Json(fmt::format("{}x{}", options.width, options.height)) : Json(); },
      .pixels = true,
      .initial = "height 512, the camera's aspect"};
}

/// R,G,B of light: not negative.
glm::vec3 parse_radiance(const std::string& text) {
  const glm::vec3 radiance = parse_vector(text);
  if (glm::any(glm::lessThan(radiance, glm::vec3(0)))) refuse("none or R,G,B is allowed, none of them negative");
  return radiance;
}

Option background_row(std::optional<glm::vec3>& background) {
  return {.names = "--background",
          .value = "none|R,G,B",
          .help = "Radiance where nothing is, in cd/m2; none: transparent.",
          .set =
              [&background](const std::string& text) {
                background = text == "none" ? std::nullopt : std::optional(parse_radiance(text));
              },
          .get = [&background] { return background ? text_of(*background) : "none"; },
          .pixels = true};
}

std::vector<std::string> kind_names() {
  std::vector<std::string> names;
  for (const RayKind& kind : ray_kinds) names.emplace_back(kind.name);
  return names;
}

Option rays_row(PerKind<bool>& rays) {
  return {.names = "--rays",
          .value = "LIST",
          .help = "Kinds of rays to cast, with commas between; none: no rays.",
          .set =
              [&rays](const std::string& text) {
                PerKind<bool> chosen(false);
                if (text != "none")
                  for (const std::string& name : split(text, ',')) chosen[parse_choice(name, kind_names())] = true;
                rays = chosen;
              },
          .get =
              [&rays] {
                std::vector<std::string_view> chosen;
                for (size_t kind = 0; kind < kind_count; ++kind)
                  if (rays[kind]) chosen.push_back(ray_kinds[kind].name);
                return chosen.empty() ? "none" : with_commas(chosen);
              },
          .pixels = true,
          .words = kind_names()};
}

OptionGroup picture_options(RenderOptions& options) {
  return {
      "Picture",
      {size_row(options), changes_pixels(integer("--samples", "N", "Samples a pixel.", options.samples, 1, 65536)),
       changes_pixels(integer("--seed", "N", "Chooses other places for the samples.", options.seed, 0, UINT32_MAX)),
       changes_pixels(
           integer("--bounces", "N", "Generations of reflection and refraction, 0 to 64.", options.bounces, 0, 64)),
       rays_row(options.rays),
       changes_pixels(flag("--override-mirror", "Let every surface also reflect like a perfect mirror (for measuring).",
                           options.override_mirror)),
       background_row(options.background)}};
}

Option fov_row(std::optional<float>& degrees) {
  return {.names = "--fov",
          .value = "DEG",
          .help = "Vertical field of view in degrees.",
          .set = [&degrees](const std::string& text) { degrees = parse_real(text, 0.01f, 179.9f); },
          .get = [&degrees] { return degrees ? json_of(*degrees) : Json(); },
          .pixels = true};
}

Option orthographic_row(std::optional<float>& height) {
  return {.names = "--orthographic",
          .value = "METRES",
          .help = "Look along parallel lines, at so many metres from the picture's lower edge to its upper one.",
          .set = [&height](const std::string& text) { height = parse_real(text, 1e-6f, 1e9f); },
          .get = [&height] { return height ? json_of(*height) : Json(); },
          .pixels = true};
}

Option up_row(glm::vec3& up) {
  return {.names = "--up",
          .value = "X,Y,Z",
          .help = "What is up in the picture.",
          .set =
              [&up](const std::string& text) {
                up = parse_vector(text);
                if (up == glm::vec3(0)) refuse("a direction is allowed, not 0,0,0");
              },
          .get = [&up] { return text_of(up); },
          .pixels = true};
}

LightOption parse_light(const std::string& text) {
  const std::vector<std::string> parts = split(text, ',');
  if (parts.size() != 3 && parts.size() != 4)
    refuse("x,y,z or x,y,z,candela is allowed, finite numbers with commas between, as in 0,2.5,1,400");
  LightOption light{.position = parse_vector(fmt::format("{},{},{}", parts[0], parts[1], parts[2])), .candela = {}};
  if (parts.size() == 4) light.candela = parse_real(parts[3], 0, std::numeric_limits<float>::max());
  return light;
}

std::string light_text(const LightOption& light) {
  return text_of(light.position) + (light.candela ? fmt::format(",{}", *light.candela) : "");
}

Option light_row(std::vector<LightOption>& lights) {
  return {
      .names = "--light",
      .value = "X,Y,Z[,CANDELA]",
      .help = "A point light in place of the file's lights. Without candela: as bright as suits the scene. Repeats.",
      .set = [&lights](const std::string& text) { lights.push_back(parse_light(text)); },
      .get =
          [&lights] {
            Json list = Json::array();
            for (const LightOption& light : lights) list.push_back(light_text(light));
            return lights.empty() ? Json() : list;
          },
      .repeats = true,
      .pixels = true,
      .initial = "the file's lights, else one beside the camera"};
}

Option hide_row(std::vector<std::string>& hidden) {
  return {
      .names = "--hide",
      .value = "INDEX|NAME",
      .help = "Leave out an object: its index (Object.id less 1), or the name of a node with all below it. Repeats.",
      .set = [&hidden](const std::string& text) { hidden.push_back(text); },
      .get = [&hidden] { return hidden.empty() ? Json() : Json(hidden); },
      .repeats = true,
      .pixels = true};
}

OptionGroup scene_options(RenderCommand& command) {
  RenderOptions& options = command.options;
  return {"Scene and view",
          {changes_pixels(with_default("the file's default",
                                       text("--scene", "INDEX|NAME", "Which of the file's scenes.", options.scene))),
           changes_pixels(with_default("the first, else one that sees the whole scene",
                                       text("--camera", "INDEX|NAME", "Which of the file's cameras.", options.camera))),
           vector_row("--eye", "A camera of your own: where it stands.", options.view.eye),
           vector_row("--target", "What it looks at.", options.view.target), up_row(options.view.up),
           fov_row(options.view.fov_degrees), orthographic_row(options.view.orthographic_height),
           light_row(options.lights), hide_row(options.hidden), allow_outside_row(command.allow_outside)}};
}

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
       changes_pixels(with_default("the first", text("--animation", "INDEX|NAME", "Which of the file's animations.",
                                                     command.options.animation)))}};
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
