#include "hierarchy/hierarchy.h"

#include <algorithm>
#include <bit>

#include "hierarchy/grouping.h"
#include "primitives/grow.h"
#include "shared/limits.h"
#include "shared/node.h"
#include "shared/ray.h"

namespace crsh::hierarchy {
namespace {

/// Where nodes may hold more rays than this, their bounds are merged from the level below and not fitted to the rays:
/// the lane that fits a bound loops over all its rays, and lavapipe 22.3 ends loops after 65,535 turns.
constexpr uint64_t max_fitted_rays = 8192;

/// The constants in which a bound's file says its size and how it is merged, by constant_id (shaders/hierarchy/bounds).
constexpr uint32_t bound_bytes_id = 9, bound_merge_fits_id = 10;
/// What a bound with cones can be told; others have no such constant, and then it does nothing.
constexpr uint32_t cone_test_as_printed_id = 11;

/// Every bound has a shader of this name.
constexpr std::string_view prefix = "hierarchy/fit@", suffix = ".comp";

uint32_t declared(const std::string& bound, uint32_t constant_id) {
  return gpu::declared_constant(std::string(prefix) + bound + std::string(suffix), constant_id);
}

uint32_t depth_of(const In& in) {
  uint32_t depth = 0;
  for (size_t s = 0; s < in.segments.size(); ++s) depth = std::max(depth, wanted_levels(in, s));
  return depth;
}

/// Each segment's rays: the children of level 1.
std::vector<Range> ray_ranges(const In& in) {
  std::vector<Range> ranges;
  for (const rays::Segment& segment : in.segments) ranges.push_back({segment.first, segment.count});
  return ranges;
}

/// Whether a level's bounds are fitted to all rays below; else they are merged from the bounds of their children.
bool is_fitted(const AlgorithmOptions& options, uint32_t index) {
  uint64_t rays_a_node = 1;
  for (uint32_t l = 0; l <= index && rays_a_node <= max_fitted_rays; ++l) rays_a_node *= options.arity;
  return options.fit == Fit::all && rays_a_node <= max_fitted_rays && !declared(options.bound, bound_merge_fits_id);
}

/// Makes the bounds of one level.
void bound(gpu::Recorder& recorder, const In& in, Hierarchy& out, uint32_t index) {
  Level& level = out.levels[index];
  primitives::grow(recorder, level.nodes, uint64_t(level.count) * declared(in.options.bound, bound_bytes_id), "nodes");
  primitives::grow(recorder, level.intervals, level.count * sizeof(shared::Interval), "node intervals");
  const std::vector<std::pair<uint32_t, uint32_t>> constants = {
      {0, std::bit_cast<uint32_t>(in.narrow_cones ? 0.99f : 1.0f)}};
  const std::string variant = "@" + in.options.bound;
  if (is_fitted(in.options, index)) {
    recorder.dispatch(
        {"hierarchy/fit" + variant, constants}, level.count, level.count,
        {{"rays", in.sorted_rays}, {"ranges", level.rays}, {"nodes", level.nodes}, {"intervals", level.intervals}},
        out.rays);
  } else if (index == 0) {
    recorder.dispatch(
        {"hierarchy/merge_rays" + variant, constants}, level.count, level.count,
        {{"rays", in.sorted_rays}, {"ranges", level.children}, {"nodes", level.nodes}, {"intervals", level.intervals}},
        out.rays);
  } else {
    const Level& below = out.levels[index - 1];
    recorder.dispatch({"hierarchy/merge_nodes" + variant, constants}, level.count, level.count,
                      {{"rays", in.sorted_rays},
                       {"ranges", level.children},
                       {"nodes", level.nodes},
                       {"intervals", level.intervals},
                       {"child_nodes", below.nodes},
                       {"child_intervals", below.intervals}},
                      below.count);
  }
}

}  // namespace

std::vector<std::string> bound_names() {
  std::vector<std::string> names;
  for (const std::string_view file : gpu::embedded_files())
    if (file.starts_with(prefix) && file.ends_with(suffix))
      names.emplace_back(file.substr(prefix.size(), file.size() - prefix.size() - suffix.size()));
  return names;
}

Range Level::children_of(Range wanted) const {
  if (wanted.count == 0) return {};
  if (!cut_children.empty()) {
    const uint32_t first = cut_children[wanted.first].x;
    return {first, cut_children[wanted.end() - 1].y - first};
  }
  const auto boundary = [&](uint32_t node, uint32_t past) {  // first child of the node `past` places after `node`
    size_t s = 0;
    while (s + 1 < segments.size() && node >= segments[s].end()) ++s;
    const uint32_t child = child_segments[s].first + (node + past - segments[s].first) * max_children;
    return std::min(child, child_segments[s].end());
  };
  const uint32_t first = boundary(wanted.first, 0);
  return {first, boundary(wanted.end() - 1, 1) - first};
}

void build(gpu::Recorder& recorder, const In& in, Hierarchy& out) {
  recorder.stage(Stage::hierarchy_creation);
  out.depth = depth_of(in);
  out.bound = in.options.bound;
  out.rays = 0;
  if (out.levels.size() < out.depth) out.levels.resize(out.depth);
  std::vector<Range> below = ray_ranges(in);
  for (const Range& range : below) out.rays = std::max(out.rays, range.end());
  for (uint32_t index = 0; index < out.depth; ++index) {
    group(recorder, in, below, index, out);
    bound(recorder, in, out, index);
    below = out.levels[index].segments;
  }
}

std::vector<std::pair<uint32_t, uint32_t>> test_constants(const AlgorithmOptions& options) {
  if (options.cone_test == ConeTest::with_sign) return {};
  return {{cone_test_as_printed_id, 1}};
}

std::vector<glm::vec2> spreads(gpu::Recorder& recorder, Hierarchy& hierarchy, uint32_t index) {
  const Level& level = hierarchy.levels[index];
  primitives::grow(recorder, hierarchy.spreads, level.count * sizeof(glm::vec2), "node spreads");
  recorder.dispatch("hierarchy/spread@" + hierarchy.bound, level.count, level.count,
                    {{"nodes", level.nodes}, {"spreads", hierarchy.spreads}});
  return recorder.read<glm::vec2>(hierarchy.spreads, level.count);
}

std::vector<shared::Node> outlines(gpu::Recorder& recorder, Hierarchy& hierarchy, uint32_t index) {
  const Level& level = hierarchy.levels[index];
  primitives::grow(recorder, hierarchy.outlines, level.count * sizeof(shared::Node), "node outlines");
  recorder.dispatch("hierarchy/outline@" + hierarchy.bound, level.count, level.count,
                    {{"nodes", level.nodes}, {"outlines", hierarchy.outlines}});
  return recorder.read<shared::Node>(hierarchy.outlines, level.count);
}

}  // namespace crsh::hierarchy
