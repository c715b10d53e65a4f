#include "frame/built.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>

#include "shared/node.h"
#include "shared/object.h"

namespace crsh {
namespace {

/// A cone that rejects nothing has this tangent or more (shared/node.h).
constexpr float wide = 1e30f;

RayNode node_of(const shared::Node& outline) {
  const float tangent = outline.cone.w;
  return {.centre = glm::vec3(outline.sphere),
          .radius = outline.sphere.w,
          .axis = glm::vec3(outline.cone),
          .half_angle = tangent < wide ? std::atan(tangent) : float(std::numbers::pi)};
}

}  // namespace

void dump_nodes(gpu::Recorder& recorder, const trace::Traced& traced, uint32_t first_ray, std::vector<RayNode>& nodes) {
  const std::vector<rays::Segment>& segments = traced.in.batch.segments;
  for (uint32_t l = 0; l < traced.depth(); ++l) {
    const hierarchy::Level& level = traced.hierarchy().levels[l];
    const std::vector<shared::Node> outlines = hierarchy::outlines(recorder, traced.bundle->hierarchy, l);
    const auto ranges = recorder.read<glm::uvec2>(level.rays, level.count);
    for (size_t s = 0; s < segments.size(); ++s)
      for (uint32_t n = level.segments[s].first; n < level.segments[s].end(); ++n) {
        RayNode& node = nodes.emplace_back(node_of(outlines[n]));
        node.kind = segments[s].kind, node.light = segments[s].light;
        node.bounce = traced.in.bounce, node.level = l + 1;
        node.first = first_ray + ranges[n].x, node.end = first_ray + ranges[n].y;
      }
  }
}

std::vector<ObjectBox> object_boxes(gpu::Recorder& recorder, const objects::Hierarchy& objects, uint32_t depth) {
  std::vector<ObjectBox> boxes;
  if (objects.node_count == 0) return boxes;
  const auto low = recorder.read<glm::vec4>(objects.box_low, 2 * uint64_t(objects.node_count));
  const auto high = recorder.read<glm::vec4>(objects.box_high, 2 * uint64_t(objects.node_count));
  std::vector<uint32_t> nodes = {0}, next;
  for (uint32_t d = 1; d <= depth; ++d, nodes = std::exchange(next, {}))
    for (const uint32_t node : nodes)
      for (const uint32_t slot : {2 * node, 2 * node + 1}) {
        if (std::bit_cast<uint32_t>(high[slot].w) == 0) continue;
        boxes.push_back({glm::vec3(low[slot]), glm::vec3(high[slot]), d});
        const uint32_t child = std::bit_cast<uint32_t>(low[slot].w);
        if (!(child & shared::child_is_leaf)) next.push_back(child);
      }
  return boxes;
}

}  // namespace crsh
