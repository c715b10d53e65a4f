#include "hierarchy/hierarchy.h"

#include <algorithm>
#include <bit>

#include "shared/limits.h"
#include "shared/node.h"
#include "shared/ray.h"

namespace crsh::hierarchy {
namespace {

/// Above so many rays a node, fitted bounds are merged from the level below: a lane's loops have to end.
constexpr uint64_t most_fitted_rays = 8192;

uint32_t wanted_levels(const rays::Segment& segment, const AlgorithmOptions& options) {
  return segment.count == 0 ? 0 : options.levels[segment.kind];
}

uint32_t depth_of(const In& in) {
  uint32_t depth = 0;
  for (const rays::Segment& segment : in.segments) depth = std::max(depth, wanted_levels(segment, in.options));
  return depth;
}

/// Ranges of the rays themselves: what level 1 groups.
std::vector<Range> ray_ranges(const In& in) {
  std::vector<Range> ranges;
  for (const rays::Segment& segment : in.segments) ranges.push_back({segment.first, segment.count});
  return ranges;
}

std::vector<Range> node_ranges(const In& in, const std::vector<Range>& below, uint32_t level) {
  std::vector<Range> ranges;
  uint32_t next = 0;
  for (size_t s = 0; s < below.size(); ++s) {
    const bool has_level = wanted_levels(in.segments[s], in.options) >= level;
    const uint32_t count = has_level ? (below[s].count + in.options.arity - 1) / in.options.arity : 0;
    ranges.push_back({next, count});
    next += count;
  }
  return ranges;
}

void reserve(gpu::Device& device, Level& level, uint32_t children) {
  const uint64_t n = level.count;
  level.nodes.reserve(device, n * sizeof(shared::Node), "nodes");
  level.intervals.reserve(device, n * sizeof(shared::Interval), "node intervals");
  level.children.reserve(device, n * sizeof(glm::uvec2), "ranges of children");
  level.rays.reserve(device, n * sizeof(glm::uvec2), "ranges of rays");
  level.parents.reserve(device, uint64_t(children) * sizeof(uint32_t), "parents");
}

struct GroupPush {
  uint32_t first_child, children, first_node, arity, rays_below;
};

/// Every `arity` children a node, segment by segment.
void group(gpu::Recorder& recorder, const In& in, const Hierarchy& out, uint32_t index) {
  const Level& level = out.levels[index];
  const gpu::Buffer& rays_of_child = index == 0 ? level.children : out.levels[index - 1].rays;  // level 1: not read
  for (size_t s = 0; s < level.segments.size(); ++s) {
    if (!level.segments[s].count) continue;
    const Range children = level.child_segments[s];
    const GroupPush push{children.first, children.count, level.segments[s].first, in.options.arity, index == 0};
    recorder.dispatch("hierarchy/group", children.count, push,
                      {rays_of_child, level.parents, level.children, level.rays});
  }
}

/// Bounds of one level: fitted to all rays below, or merged from the children.
void bound(gpu::Recorder& recorder, const In& in, Hierarchy& out, uint32_t index) {
  Level& level = out.levels[index];
  const std::vector<std::pair<uint32_t, uint32_t>> constants = {
      {0, std::bit_cast<uint32_t>(in.narrow_cones ? 0.99f : 1.0f)}};
  uint64_t rays_a_node = 1;
  for (uint32_t l = 0; l <= index && rays_a_node <= most_fitted_rays; ++l) rays_a_node *= in.options.arity;
  const std::string variant = "@" + in.options.bound;
  if (in.options.fit == Fit::all && rays_a_node <= most_fitted_rays) {
    recorder.dispatch({"hierarchy/fit" + variant, constants}, level.count, level.count,
                      {in.sorted_rays, level.rays, level.nodes, level.intervals});
  } else if (index == 0) {
    recorder.dispatch({"hierarchy/merge_rays" + variant, constants}, level.count, level.count,
                      {in.sorted_rays, level.children, level.nodes, level.intervals});
  } else {
    const Level& below = out.levels[index - 1];
    recorder.dispatch(
        {"hierarchy/merge_nodes" + variant, constants}, level.count, level.count,
        {in.sorted_rays, level.children, level.nodes, level.intervals, below.nodes, below.intervals});
  }
}

}  // namespace

Range Level::children_of(Range wanted) const {
  if (wanted.count == 0) return {};
  const auto boundary = [&](uint32_t node, uint32_t past) {  // first child of `node`, or of the node `past` it
    size_t s = 0;
    while (s + 1 < segments.size() && node >= segments[s].end()) ++s;
    const uint32_t child = child_segments[s].first + (node + past - segments[s].first) * most_children;
    return std::min(child, child_segments[s].end());
  };
  const uint32_t first = boundary(wanted.first, 0);
  return {first, boundary(wanted.end() - 1, 1) - first};
}

void build(gpu::Recorder& recorder, const In& in, Hierarchy& out) {
  recorder.stage(gpu::Stage::hierarchy_creation);
  recorder.submit();  // buffers may grow: nothing recorded may still use them
  out.depth = depth_of(in);
  out.rays = 0;
  if (out.levels.size() < out.depth) out.levels.resize(out.depth);
  std::vector<Range> below = ray_ranges(in);
  for (const Range& range : below) out.rays = std::max(out.rays, range.end());
  uint32_t children = out.rays;
  for (uint32_t index = 0; index < out.depth; ++index) {
    Level& level = out.levels[index];
    level.segments = node_ranges(in, below, index + 1);
    level.count = level.segments.empty() ? 0 : level.segments.back().end();
    level.child_segments = below;
    level.most_children = in.options.arity;
    reserve(recorder.device(), level, children);
    below = level.segments;
    children = level.count;
  }
  for (uint32_t index = 0; index < out.depth; ++index) {
    group(recorder, in, out, index);
    bound(recorder, in, out, index);
  }
}

}  // namespace crsh::hierarchy
