// The preset and its switches.

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cli/render_options.h"
#include "cli/rows.h"
#include "hierarchy/hierarchy.h"
#include "rays/hash.h"

namespace crsh::cli {
namespace {

using Json = nlohmann::ordered_json;

std::vector<std::string> kind_names() {
  std::vector<std::string> names;
  for (const RayKind& kind : ray_kinds) names.emplace_back(kind.name);
  return names;
}

/// "KIND=VALUE" or "VALUE": calls `set` with every kind that is meant, and the value.
template <class Set>
void for_kinds(const std::string& given, Set set) {
  const size_t equals = given.find('=');
  const std::string value = equals == std::string::npos ? given : given.substr(equals + 1);
  if (equals != std::string::npos) return set(parse_choice(given.substr(0, equals), kind_names()), value);
  for (size_t kind = 0; kind < kind_count; ++kind) set(kind, value);
}

/// A kind's part of a value as an object by the kinds' names.
template <class Get>
Json by_kind(Get get) {
  Json values;
  for (size_t kind = 0; kind < kind_count; ++kind) values[std::string(ray_kinds[kind].name)] = get(kind);
  return values;
}

std::vector<std::string> allowed_keys() {
  std::vector<std::string> allowed = rays::key_names();
  allowed.insert(allowed.begin(), {"best", std::string(rays::key_of_file)});
  return allowed;
}

std::string key_named(const AlgorithmOptions& algorithm, size_t kind, const std::string& name) {
  if (name == "best") return best_key(algorithm.preset, kind);
  const std::vector<std::string> allowed = allowed_keys();
  return allowed[parse_choice(name, allowed)];
}

Option algorithm_option(AlgorithmOptions& algorithm) {
  return {
      .names = "--algorithm",
      .value = "NAME",
      .help = fmt::format("Preset of the switches below, each of which changes one thing of it: {}; or {}, where the "
                          "device has VK_KHR_ray_query (its own hierarchy: the picture is near the others').",
                          fmt::join(preset_names(), ", "), ray_query_preset),
      .set = [&algorithm](const std::string& name) { algorithm = preset(name); },
      .get = [&algorithm] { return algorithm.preset; },
      .words = preset_names()};
}

Option key_option(AlgorithmOptions& algorithm) {
  return {.names = "--key",
          .value = "[KIND=]NAME",
          .help = fmt::format("Sort key of one kind of rays ({}) or of all: best, the algorithm's own; {}; file: those "
                              "of --replay-rays. Repeats.",
                              fmt::join(kind_names(), ", "), fmt::join(rays::key_names(), ", ")),
          .set =
              [&algorithm](const std::string& given) {
                for_kinds(given, [&](size_t kind, const std::string& name) {
                  algorithm.keys[kind] = key_named(algorithm, kind, name);
                });
              },
          .get =
              [&algorithm] {
                return by_kind(
                    [&](size_t kind) { return algorithm.keys[kind].empty() ? "creation" : algorithm.keys[kind]; });
              },
          .repeats = true,
          .initial = "",
          .words = allowed_keys()};
}

Option levels_option(AlgorithmOptions& algorithm) {
  return {.names = "--levels",
          .value = "[KIND=]N",
          .help = "Levels of nodes above the rays, 1 to 8; 1 or 2 of crsh-bvh. Repeats.",
          .set =
              [&algorithm](const std::string& given) {
                for_kinds(given, [&](size_t kind, const std::string& value) {
                  algorithm.levels[kind] = static_cast<uint32_t>(parse_integer(value, 1, 8));
                });
              },
          .get = [&algorithm] { return by_kind([&](size_t kind) { return algorithm.levels[kind]; }); },
          .repeats = true,
          .initial = ""};
}

Option bound_option(AlgorithmOptions& algorithm) {
  const std::vector<std::string> names = hierarchy::bound_names();
  return {.names = "--bound",
          .value = "NAME",
          .help = fmt::format("Bound of a node: {}.", fmt::join(names, ", ")),
          .set = [&algorithm, names](const std::string& name) { algorithm.bound = names[parse_choice(name, names)]; },
          .get = [&algorithm] { return algorithm.bound; },
          .initial = "",
          .words = names};
}

}  // namespace

std::string presets_help() {
  std::string text = "Algorithms:\n";
  for (const Preset& row : preset_table()) text += fmt::format("  {:<11}{}\n", row.name, row.help);
  return text;
}

OptionGroup algorithm_options(AlgorithmOptions& algorithm) {
  const auto plain = [](Option option) { return with_default("", std::move(option)); };  // the preset's
  return {
      "Algorithm (the picture is the same, bit for bit)",
      {algorithm_option(algorithm), key_option(algorithm),
       plain(choice("--ray-order", "scanline|tiles", "Order in which rays are created.", algorithm.ray_order,
                    {"scanline", "tiles"})),
       plain(on_off("--compression", "Sort runs of neighbours with one key as one.", algorithm.compression)),
       plain(choice("--nodes", "fixed|cut", "Where level-1 nodes end: after N rays, or also where coherence ends.",
                    algorithm.nodes, {"fixed", "cut"})),
       plain(real("--cut-angle", "RAD", "Cut nodes end where rays are so far from their first one's direction.",
                  algorithm.cut_angle, 0, 4)),
       plain(real("--cut-distance", "SHARE",
                  "Cut nodes end where rays begin so far from their first one, as a share of the scene's longest edge.",
                  algorithm.cut_distance, 0, 4)),
       plain(real("--least-rays", "MEAN",
                  "Rays go one by one where a sample of them, unsorted, would be cut to nodes of fewer: crsh-bvh only.",
                  algorithm.least_rays, 0, 64)),
       plain(integer("--arity", "N", "Children of a node, 2 to 64.", algorithm.arity, 2, 64)), levels_option(algorithm),
       bound_option(algorithm),
       plain(choice("--fit", "merged|all", "Bound a node's children, or all rays below it.", algorithm.fit,
                    {"merged", "all"})),
       plain(choice("--cone-test", "signed|printed",
                    "Equation 9 of sphere-cone bounds: signed rejects what lies behind a node; printed, the paper's "
                    "letter, does not. Other bounds have no cones.",
                    algorithm.cone_test, {"signed", "printed"})),
       plain(on_off("--interval", "Test also the distances that a node's rays reach.", algorithm.interval)),
       plain(on_off("--mesh-culling", "Test nodes against whole meshes first.", algorithm.mesh_culling)),
       plain(choice("--batches", "mixed|separate", "Sort a bounce's kinds of rays together, or one by one.",
                    algorithm.mixed_batches, {"separate", "mixed"}))}};
}

}  // namespace crsh::cli
