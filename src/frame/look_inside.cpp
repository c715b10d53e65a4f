#include "frame/look_inside.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>

#include "gpu/program.h"
#include "shared/node.h"
#include "shared/object.h"

namespace crsh {
namespace {

/// constant_id of a bound's size (shaders/hierarchy/bounds).
constexpr uint32_t bound_bytes_id = 9;

RayNode of_bound(const shared::Node& node) {
  const float tangent = node.cone.w;
  return {.centre = glm::vec3(node.sphere),
          .radius = node.sphere.w,
          .axis = glm::vec3(node.cone),
          .half_angle = tangent < 1e30f ? std::atan(tangent) : float(std::numbers::pi)};
}

/// The ball around the box of origins, and the cone around the box of directions.
RayNode of_bound(const shared::Slab& node) {
  const glm::vec3 low(node.origin_low), high(node.origin_high);
  const glm::vec3 from(node.direction_low), to(node.direction_high), middle = 0.5f * (from + to);
  RayNode made{.centre = 0.5f * (low + high), .radius = 0.5f * glm::distance(low, high)};
  if (!(glm::length(middle) > 1e-6f)) return made.half_angle = float(std::numbers::pi), made;
  made.axis = glm::normalize(middle);
  for (int corner = 0; corner < 8; ++corner) {
    const glm::vec3 at(corner & 1 ? to.x : from.x, corner & 2 ? to.y : from.y, corner & 4 ? to.z : from.z);
    const float length = glm::length(at);
    if (length > 0)
      made.half_angle = std::max(made.half_angle, std::acos(glm::clamp(glm::dot(at, made.axis) / length, -1.0f, 1.0f)));
  }
  if (made.half_angle > float(std::numbers::pi) / 2)
    made.half_angle = float(std::numbers::pi);  // a box about all sides
  return made;
}

template <class Bound>
std::vector<RayNode> read_bounds(Renderer::State& s, const hierarchy::Level& level) {
  std::vector<RayNode> nodes;
  for (const Bound& bound : s.recorder.read<Bound>(level.nodes, level.count)) nodes.push_back(of_bound(bound));
  return nodes;
}

std::vector<RayNode> read_level(Renderer::State& s, const hierarchy::Level& level) {
  const uint32_t bytes = gpu::declared_constant("hierarchy/fit@" + s.batch.hierarchy.bound + ".comp", bound_bytes_id);
  return bytes == sizeof(shared::Node) ? read_bounds<shared::Node>(s, level) : read_bounds<shared::Slab>(s, level);
}

}  // namespace

void dump_nodes(Renderer::State& s, uint32_t bounce, uint32_t first_ray, std::vector<RayNode>& nodes) {
  const rays::Batch& batch = s.batch.rays;
  for (uint32_t l = 0; l < s.batch.hierarchy.depth; ++l) {
    const hierarchy::Level& level = s.batch.hierarchy.levels[l];
    const std::vector<RayNode> all = read_level(s, level);
    const auto ranges = s.recorder.read<glm::uvec2>(level.rays, level.count);
    for (size_t segment = 0; segment < batch.segments.size(); ++segment)
      for (uint32_t n = level.segments[segment].first; n < level.segments[segment].end(); ++n) {
        RayNode& node = nodes.emplace_back(all[n]);
        node.kind = batch.segments[segment].kind, node.light = batch.segments[segment].light;
        node.bounce = bounce, node.level = l + 1;
        node.first = first_ray + ranges[n].x, node.end = first_ray + ranges[n].y;
      }
  }
}

std::vector<ObjectBox> object_boxes(Renderer::State& s, uint32_t depth) {
  std::vector<ObjectBox> boxes;
  const objects::Hierarchy& h = s.objects;
  if (!s.options.algorithm.object_hierarchy || h.node_count == 0) return boxes;
  const auto low = s.recorder.read<glm::vec4>(h.box_low, 2 * uint64_t(h.node_count));
  const auto high = s.recorder.read<glm::vec4>(h.box_high, 2 * uint64_t(h.node_count));
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
