#pragma once
// Section 3.2.4: nodes over the sorted rays, level by level from below.

#include <cstdint>
#include <glm/glm.hpp>
#include <limits>
#include <string>
#include <vector>

#include "crsh/options.h"
#include "gpu/buffer.h"
#include "gpu/recorder.h"
#include "primitives/compact.h"
#include "rays/batch.h"
#include "shared/node.h"

namespace crsh::hierarchy {

/// Nodes of one segment on one level.
struct Range {
  uint32_t first = 0, count = 0;
  [[nodiscard]] uint32_t end() const { return first + count; }
};

/// One level of nodes; level 1 stands on the rays.
struct Level {
  gpu::Buffer nodes;      ///< as the bound has them: BOUND of its shader file
  gpu::Buffer intervals;  ///< shared::Interval
  gpu::Buffer children;   ///< uvec2 a node: [first, end) nodes or rays of the level below
  gpu::Buffer rays;       ///< uvec2 a node: [first, end) sorted positions of its rays
  gpu::Buffer parents;    ///< uint a child of the level below: its node here
  uint32_t count = 0;
  std::vector<Range> segments;           ///< nodes by segment of the batch
  std::vector<Range> child_segments;     ///< their children by segment, on the level below
  uint32_t max_children = 0;             ///< of a node
  std::vector<glm::uvec2> cut_children;  ///< `children`, where nodes are cut and not of one size

  /// The children of a run of nodes, on the level below.
  [[nodiscard]] Range children_of(Range wanted) const;
};

/// What making cut nodes needs besides, kept between calls.
struct CutScratch {
  gpu::Buffer heads;  ///< uint a child: 1 where a node begins
  gpu::Buffer ends;   ///< uint a child: where the node that begins there ends
  gpu::Buffer bases;  ///< uint a node: its first child
  primitives::CompactScratch compact;
};

/// Buffers are kept between batches and frames and grow when they must.
struct Hierarchy {
  std::vector<Level> levels;  ///< levels[0] is level 1
  uint32_t depth = 0;         ///< levels in use
  uint32_t rays = 0;
  std::string bound;  ///< file below shaders/hierarchy/bounds/
  CutScratch cut;
  gpu::Buffer spreads, outlines;
};

/// Names of all node bounds that the build found, sorted: files below shaders/hierarchy/bounds/.
[[nodiscard]] std::vector<std::string> bound_names();

struct In {
  const gpu::Buffer& sorted_rays;  ///< shared::Ray a ray, in sorted order
  const std::vector<rays::Segment>& segments;
  const AlgorithmOptions& options;
  bool narrow_cones = false;                              ///< test-only mutation
  float extent = std::numeric_limits<float>::infinity();  ///< longest edge of the scene's bounds, metres (cut_distance)
  bool cut_groups = false;  ///< where nodes are cut, those above level 1 are, too: groups for the object hierarchy
  std::vector<bool> without_nodes = {};  ///< by segment; empty: all segments get nodes
};

/// Builds as many levels as the kind with the most wants; segments of other kinds have no nodes on levels above theirs.
/// Records, and may submit.
void build(gpu::Recorder& recorder, const In& in, Hierarchy& out);

/// Specialisation constants of kernels that test nodes against objects, boxes or triangles.
[[nodiscard]] std::vector<std::pair<uint32_t, uint32_t>> test_constants(const AlgorithmOptions& options);

/// For each node of levels[index] the tangent of its half-angle (1e30 and above: a right angle or wider) and its
/// radius, metres. Submits and waits.
[[nodiscard]] std::vector<glm::vec2> spreads(gpu::Recorder& recorder, Hierarchy& hierarchy, uint32_t index);

/// For each node of levels[index] a ball that holds the origins of its rays and a cone that holds their directions,
/// whatever its bound is made of. Submits and waits.
[[nodiscard]] std::vector<shared::Node> outlines(gpu::Recorder& recorder, Hierarchy& hierarchy, uint32_t index);

}  // namespace crsh::hierarchy
