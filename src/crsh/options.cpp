#include "crsh/options.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "crsh/error.h"

namespace crsh {
namespace {

AlgorithmOptions brute() {
  AlgorithmOptions options;
  options.preset = "brute";
  options.tracing = Tracing::brute;
  options.compression = options.interval = options.mesh_culling = false;
  return options;
}

/// What anybody would write: rays one by one through the object hierarchy.
AlgorithmOptions bvh() {
  AlgorithmOptions options = brute();
  options.preset = "bvh";
  options.tracing = Tracing::single_rays;
  options.object_hierarchy = true;
  return options;
}

/// The device's own hierarchy and traversal.
AlgorithmOptions ray_query() {
  AlgorithmOptions options = brute();
  options.preset = ray_query_preset;
  options.tracing = Tracing::ray_query;
  return options;
}

/// Roger et al. 2007: rays as they come from screen tiles.
AlgorithmOptions rah() {
  AlgorithmOptions options;
  options.preset = "rah";
  options.ray_order = RayOrder::tiles;
  options.compression = options.mesh_culling = false;
  return options;
}

/// The paper as printed.
AlgorithmOptions crsh_2017() {
  AlgorithmOptions options;
  options.preset = "crsh-2017";
  options.keys.fill("spherical");
  options.fit = Fit::merged;
  options.interval = false;
  return options;
}

/// Our best: each kind with its best key, nodes that end where coherence does, and the tightest bound.
AlgorithmOptions crsh_best() {
  AlgorithmOptions options;
  options.preset = "crsh";
  options.levels = {5, 4, 4};
  options.compression = false;
  options.nodes = NodeCut::cut;
  options.bound = "slab-edges";
  for (size_t kind = 0; kind < kind_count; ++kind) options.keys[kind] = ray_kinds[kind].best_key;
  return options;
}

/// Nodes of rays through the object hierarchy. Here nodes may be small: they are not tested against the whole scene.
AlgorithmOptions crsh_bvh() {
  AlgorithmOptions options = crsh_best();
  options.preset = "crsh-bvh";
  options.object_hierarchy = true;
  options.mesh_culling = false;
  options.levels = {2, 2, 2};
  options.ray_order = RayOrder::tiles;
  options.cut_angle = 0.04f;
  options.cut_distance = 0.005f;
  options.keys[shared::kind_reflection] = options.keys[shared::kind_refraction] = "origin-direction";
  return options;
}

}  // namespace

const std::vector<std::string>& preset_names() {
  static const std::vector<std::string> names = {"brute", "bvh", "rah", "crsh-2017", "crsh", "crsh-bvh"};
  return names;
}

AlgorithmOptions preset(const std::string& name) {
  if (name == "brute") return brute();
  if (name == "bvh") return bvh();
  if (name == ray_query_preset) return ray_query();
  if (name == "rah") return rah();
  if (name == "crsh-2017") return crsh_2017();
  if (name == "crsh") return crsh_best();
  if (name == "crsh-bvh") return crsh_bvh();
  throw UserError(fmt::format("no such algorithm: choose {}, {}", fmt::join(preset_names(), ", "), ray_query_preset),
                  Exit::usage);
}

void require_sound(const AlgorithmOptions& options) {
  const bool groups_of_groups = std::ranges::any_of(options.levels, [](uint32_t levels) { return levels > 2; });
  if (options.tracing == Tracing::nodes && options.object_hierarchy && groups_of_groups)
    throw UserError(fmt::format("--algorithm {} has 1 or 2 levels of nodes: give --levels 2", options.preset),
                    Exit::usage);
}

}  // namespace crsh
