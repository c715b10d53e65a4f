#include "hierarchy/grouping.h"

#include <algorithm>
#include <cmath>

#include "primitives/grow.h"
#include "shared/limits.h"

namespace crsh::hierarchy {
namespace {

using primitives::grow;
using primitives::quad_bytes;

/// The limits of groups, nodes of level 2 for the object hierarchy, are so many times those of level-1 nodes.
constexpr float group_scale = 4;

/// Whether nodes of this level end where coherence ends.
bool is_cut(const In& in, uint32_t index) { return in.options.nodes == NodeCut::cut && (index == 0 || in.cut_groups); }

/// How many children a level has in all segments together.
uint32_t count_children(const std::vector<Range>& below) {
  uint32_t count = 0;
  for (const Range& range : below) count = std::max(count, range.end());
  return count;
}

/// Makes room for the level's ranges; bound() does so for bounds.
void reserve_ranges(gpu::Recorder& recorder, Level& level, uint32_t children) {
  grow(recorder, level.children, level.count * sizeof(glm::uvec2), "ranges of children");
  grow(recorder, level.rays, level.count * sizeof(glm::uvec2), "ranges of rays");
  grow(recorder, level.parents, uint64_t(children) * sizeof(uint32_t), "parents");
}

/// The ray ranges of the children. Those of level 1 are rays and have none: any buffer can be bound, as it is not read.
const gpu::Buffer& rays_of_children(const Hierarchy& out, uint32_t index) {
  return index == 0 ? out.levels[index].children : out.levels[index - 1].rays;
}

/// Makes a node of every `arity` children, segment by segment.
void group_fixed(gpu::Recorder& recorder, const In& in, const std::vector<Range>& below, uint32_t index,
                 Hierarchy& out) {
  Level& level = out.levels[index];
  level.segments.clear();
  level.count = 0;
  for (size_t s = 0; s < below.size(); ++s) {
    const bool has_level = wanted_levels(in, s) > index;
    const uint32_t count = has_level ? (below[s].count + in.options.arity - 1) / in.options.arity : 0;
    level.segments.push_back({level.count, count});
    level.count += count;
  }
  reserve_ranges(recorder, level, count_children(below));
  for (size_t s = 0; s < below.size(); ++s) {
    if (!level.segments[s].count) continue;
    const struct {
      uint32_t first_child, children, first_node, arity, rays_below;
    } push{below[s].first, below[s].count, level.segments[s].first, in.options.arity, index == 0};
    recorder.dispatch("hierarchy/group", below[s].count, push,
                      {{"rays_of_child", rays_of_children(out, index)},
                       {"parents", level.parents},
                       {"children_of", level.children},
                       {"rays_of", level.rays}});
  }
}

/// Flags the children with which nodes begin, and writes where these nodes end.
void flag_heads(gpu::Recorder& recorder, const In& in, const std::vector<Range>& below, uint32_t index,
                Hierarchy& out) {
  const uint32_t children = count_children(below);
  grow(recorder, out.cut.heads, quad_bytes(children), "node heads");
  grow(recorder, out.cut.ends, quad_bytes(children), "node ends");
  grow(recorder, out.levels[index].children, sizeof(glm::uvec2), "ranges of children");
  const CutLimits limits = cut_limits(in.options, in.extent, index);
  for (size_t s = 0; s < below.size(); ++s) {
    if (wanted_levels(in, s) <= index) {
      recorder.fill(out.cut.heads, 0, below[s].count, below[s].first);
      continue;
    }
    const struct {
      uint32_t first_child, children, arity, rays_below;
      CutLimits limits;
    } push{below[s].first, below[s].count, in.options.arity, index == 0, limits};
    recorder.dispatch("hierarchy/cut", (uint64_t(below[s].count) + shared::cut_run - 1) / shared::cut_run, push,
                      {{"rays", in.sorted_rays},
                       {"rays_of_child", rays_of_children(out, index)},
                       {"heads", out.cut.heads},
                       {"ends", out.cut.ends}},
                      below[s].count);
  }
}

/// The nodes of each segment, found by the first children of all nodes.
std::vector<Range> segments_of(const std::vector<glm::uvec2>& children, const std::vector<Range>& below) {
  const auto first_from = [&](uint32_t child) {
    return uint32_t(std::ranges::lower_bound(children, child, {}, &glm::uvec2::x) - children.begin());
  };
  std::vector<Range> segments;
  for (const Range& range : below) {
    const uint32_t first = first_from(range.first);
    segments.push_back({first, first_from(range.end()) - first});
  }
  return segments;
}

/// Makes nodes that end where coherence ends, in the way in which the paper compresses rays to chunks: flags the first
/// child of each, scans the flags, and writes where each node begins and ends.
void group_cut(gpu::Recorder& recorder, const In& in, const std::vector<Range>& below, uint32_t index, Hierarchy& out) {
  Level& level = out.levels[index];
  const uint32_t children = count_children(below);
  flag_heads(recorder, in, below, index, out);
  level.count = primitives::compact(recorder, out.cut.compact, out.cut.heads, children, out.cut.bases);
  reserve_ranges(recorder, level, children);
  const struct {
    uint32_t nodes;
    uint32_t rays_below;
  } push{level.count, index == 0};
  recorder.dispatch("hierarchy/group_cut", level.count, push,
                    {{"rays_of_child", rays_of_children(out, index)},
                     {"bases", out.cut.bases},
                     {"ends", out.cut.ends},
                     {"parents", level.parents},
                     {"children_of", level.children},
                     {"rays_of", level.rays}});
  level.cut_children = recorder.read<glm::uvec2>(level.children, level.count);
  level.segments = segments_of(level.cut_children, below);
}

}  // namespace

CutLimits cut_limits(const AlgorithmOptions& options, float extent, uint32_t index) {
  const float scale = index == 0 ? 1 : group_scale, angle = options.cut_angle * scale;
  return {angle < 3 ? 2 * std::sin(angle / 2) : 2.5f, options.cut_distance * scale * extent};
}

uint32_t wanted_levels(const In& in, size_t s) {
  const bool none = in.segments[s].count == 0 || (!in.without_nodes.empty() && in.without_nodes[s]);
  return none ? 0 : in.options.levels[in.segments[s].kind];
}

void group(gpu::Recorder& recorder, const In& in, const std::vector<Range>& below, uint32_t index, Hierarchy& out) {
  Level& level = out.levels[index];
  level.child_segments = below;
  level.max_children = in.options.arity;
  level.cut_children.clear();
  is_cut(in, index) ? group_cut(recorder, in, below, index, out) : group_fixed(recorder, in, below, index, out);
}

}  // namespace crsh::hierarchy
