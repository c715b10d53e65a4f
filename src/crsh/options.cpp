#include "crsh/options.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>

#include "crsh/error.h"

namespace crsh {
namespace {

AlgorithmOptions brute() {
  AlgorithmOptions options;
  options.tracer = "brute";
  options.compression = options.interval = options.mesh_culling = false;
  return options;
}

/// Rays one by one through the object hierarchy, as in common ray tracers.
AlgorithmOptions bvh() {
  AlgorithmOptions options = brute();
  options.tracer = "single-rays";
  return options;
}

/// The device's own hierarchy and traversal.
AlgorithmOptions ray_query() {
  AlgorithmOptions options = brute();
  options.tracer = "ray-query";
  return options;
}

/// Roger et al. 2007: rays as they come from screen tiles.
AlgorithmOptions rah() {
  AlgorithmOptions options;
  options.ray_order = RayOrder::tiles;
  options.compression = options.mesh_culling = false;
  return options;
}

/// The paper as printed, but for equation 9's sign (ConeTest): no ray goes where it makes the difference, and the
/// figures do not decide (on Sponza the paper has 2.38% of brute force, the sign 2.21%, the letter 2.51%). The bench
/// counts both.
AlgorithmOptions crsh_2017() {
  AlgorithmOptions options;
  options.keys.fill("spherical");
  options.fit = Fit::merged;
  options.interval = false;
  return options;
}

/// Our best: each kind with its best key, nodes that end where coherence does, and the tightest bound.
AlgorithmOptions crsh_best() {
  AlgorithmOptions options;
  options.compression = false;
  options.nodes = NodeCut::cut;
  options.bound = "slab-edges";
  for (uint32_t kind = 0; kind < kind_count; ++kind) {
    options.keys[kind] = ray_kinds[kind].best_key;
    options.levels[kind] = ray_kinds[kind].shares_origin ? 5 : 4;
  }
  return options;
}

/// Nodes of rays through the object hierarchy. Here nodes may be small: they are not tested against the whole scene.
AlgorithmOptions crsh_bvh() {
  AlgorithmOptions options = crsh_best();
  options.tracer = "object-nodes";
  options.mesh_culling = false;
  options.levels.fill(2);
  options.ray_order = RayOrder::tiles;
  options.cut_angle = 0.04f;
  options.cut_distance = 0.005f;
  for (uint32_t kind = 0; kind < kind_count; ++kind)
    if (!ray_kinds[kind].shares_origin) options.keys[kind] = "origin-direction";
  return options;
}

constexpr auto presets = std::to_array<Preset>({
    {"brute", "every ray against every triangle", brute},
    {"bvh", "rays one by one through a hierarchy over the triangles", bvh},
    {"rah", "nodes of rays as they come from the screen's tiles", rah},
    {"crsh-2017", "the paper's: sorted by direction, nodes of 8 rays", crsh_2017},
    {"crsh", "our best keys, nodes and bounds, without a hierarchy over triangles", crsh_best},
    {"crsh-bvh", "the same nodes through the hierarchy over triangles", crsh_bvh},
    {ray_query_preset, "the device's own hierarchy (VK_KHR_ray_query)", ray_query, false},
});

}  // namespace

std::span<const Preset> preset_table() { return presets; }

const std::vector<std::string>& preset_names() {
  static const std::vector<std::string> names = [] {
    std::vector<std::string> everywhere;
    for (const Preset& row : presets)
      if (row.everywhere) everywhere.emplace_back(row.name);
    return everywhere;
  }();
  return names;
}

AlgorithmOptions preset(std::string_view name) {
  const auto row = std::ranges::find(presets, name, &Preset::name);
  if (row == presets.end()) {
    std::vector<std::string_view> names;
    for (const Preset& other : presets) names.push_back(other.name);
    throw UserError(fmt::format("no such algorithm: choose {}", fmt::join(names, ", ")), Exit::usage);
  }
  AlgorithmOptions options = row->options();
  options.preset = name;
  return options;
}

std::string best_key(std::string_view preset_name, size_t kind) {
  const std::string own = preset(preset_name).keys[kind];
  return own.empty() ? std::string(ray_kinds[kind].best_key) : own;
}

}  // namespace crsh
