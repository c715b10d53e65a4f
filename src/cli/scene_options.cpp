// What of `crsh render`'s options is about the picture and the scene.

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <limits>

#include "cli/render_options.h"
#include "cli/rows.h"
#include "crsh/error.h"

namespace crsh::cli {
namespace {

using Json = nlohmann::ordered_json;

std::string with_commas(const std::vector<std::string_view>& words) { return fmt::format("{}", fmt::join(words, ",")); }

Json text_or_null(const std::optional<glm::dvec3>& place) { return place ? Json(text_of(*place)) : Json(); }

Option place_row(std::string names, std::string help, std::optional<glm::dvec3>& variable) {
  return {.names = std::move(names),
          .value = "X,Y,Z",
          .help = std::move(help),
          .set = [&variable](const std::string& text) { variable = parse_place(text); },
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
  if (parts.size() < 3 || parts.size() > 5 || (parts.size() == 5 && parts[4] != "past-backs"))
    refuse("x,y,z or x,y,z,candela is allowed, finite numbers with commas between, as in 0,2.5,1,400, and past-backs");
  LightOption light{.position = parse_place(fmt::format("{},{},{}", parts[0], parts[1], parts[2])), .candela = {}};
  if (parts.size() > 3) light.candela = parse_real(parts[3], 0, std::numeric_limits<float>::max());
  light.past_backs = parts.size() == 5;
  return light;
}

Option light_row(std::vector<LightOption>& lights) {
  return {
      .names = "--light",
      .value = "X,Y,Z[,CANDELA[,past-backs]]",
      .help =
          "A point light in place of the file's lights. Without candela: as bright as suits the scene. past-backs: "
          "backs "
          "that the eye does not see do not block it, as they do not block the light of a scene without any. Repeats.",
      .set = [&lights](const std::string& text) { lights.push_back(parse_light(text)); },
      .get =
          [&lights] {
            Json list = Json::array();
            for (const LightOption& light : lights) list.push_back(text_of(light));
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

}  // namespace

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

OptionGroup scene_options(RenderCommand& command) {
  RenderOptions& options = command.options;
  return {
      "Scene and view",
      {changes_pixels(with_default("the file's default",
                                   text("--scene", "INDEX|NAME", "Which of the file's scenes.", options.scene))),
       changes_pixels(
           with_default("the usual materials",
                        text("--variant", "INDEX|NAME",
                             "Which of the file's sets of materials (KHR_materials_variants).", options.variant))),
       changes_pixels(with_default("the first, else one that sees the whole scene",
                                   text("--camera", "INDEX|NAME", "Which of the file's cameras.", options.camera))),
       place_row("--eye", "A camera of your own: where it stands.", options.view.eye),
       place_row("--target", "What it looks at.", options.view.target), up_row(options.view.up),
       fov_row(options.view.fov_degrees), orthographic_row(options.view.orthographic_height), light_row(options.lights),
       hide_row(options.hidden), allow_outside_row(command.allow_outside), lenient_row(command.lenient)}};
}

}  // namespace crsh::cli
