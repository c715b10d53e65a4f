#include "scene/origin.h"

#include <algorithm>
#include <cmath>

#include "scene/bounding.h"
#include "scene/playing.h"

namespace crsh::scene {
namespace {

constexpr double near_sizes = 4;      ///< longest edges of the bounds: what is no farther off is left where it is
constexpr double reach_sizes = 0.51;  ///< from their middle to where the origin may be: a hair outside, at most
constexpr double far_sizes = 8;       ///< what alone moves geometry by more, in a scene or to and fro, needs care

double largest(const glm::dvec3& v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

/// The number in [low, high] that is a multiple of the largest power of two.
double roundest(double low, double high) {
  if (low <= 0 && high >= 0) return 0;
  for (int exponent = std::ilogb(std::max(std::abs(low), std::abs(high)));; --exponent)
    if (const double step = std::ldexp(1, exponent), number = std::ceil(low / step) * step; number <= high)
      return number;
}

Pose pose_at_rest(const Scene& scene) { return scene.pose(0, playing(scene, "").animations); }

Bounds bounds_at_rest(const Scene& scene) { return scene.bounds(pose_at_rest(scene)); }

Bounds bounds_of(const std::vector<glm::vec3>& positions) {
  Bounds bounds;
  for (const glm::vec3& position : positions) bounds.include(position);
  return bounds;
}

/// A step at a time: what floats lose of the first, the second finds. Returns the bounds as they are in the end.
Bounds move_to_geometry(Scene& scene) {
  Bounds bounds = bounds_at_rest(scene);
  for (int step = 0; step < 2 && !bounds.empty(); ++step) {
    const glm::dvec3 further = origin_for(bounds);
    if (further == glm::dvec3(0)) break;
    scene.origin += further;
    bounds = bounds_at_rest(scene);
  }
  return bounds;
}

/// Exact: what places differ by from a round number among them has fewer digits than they have.
void move_positions(Mesh& mesh, const glm::dvec3& origin) {
  mesh.origin = origin;
  for (glm::vec3& position : mesh.positions) position = glm::vec3(glm::dvec3(position) - origin);
  fill_bounds(mesh);
}

/// Meshes whose positions are as far off, as an instance has them, as nothing is in a scene whose nodes do not move
/// them there and back.
void move_meshes(Scene& scene, const Pose& pose, double edge) {
  std::vector<double> off(scene.meshes.size());
  std::vector<Bounds> bounds;
  for (const Mesh& mesh : scene.meshes) bounds.push_back(bounds_of(mesh.positions));
  for (size_t i = 0; i < scene.instances.size(); ++i) {
    const uint32_t mesh = scene.instances[i].mesh;
    const glm::dvec3 middle = (glm::dvec3(bounds[mesh].low) + glm::dvec3(bounds[mesh].high)) * 0.5;
    off[mesh] = std::max(off[mesh], largest(glm::dmat3(glm::dmat4(pose.instances[i])) * middle));
  }
  for (size_t mesh = 0; mesh < scene.meshes.size(); ++mesh)
    if (off[mesh] > far_sizes * edge && scene.meshes[mesh].influences.empty())  // joints have it in the file's place
      if (const glm::dvec3 origin = origin_for(bounds[mesh]); origin != glm::dvec3(0))
        move_positions(scene.meshes[mesh], origin);
}

/// The nodes that move geometry.
std::vector<bool> carriers(const Scene& scene) {
  std::vector<bool> carries(scene.nodes.size());
  for (const Instance& instance : scene.instances) carries[instance.node] = true;
  for (size_t i = scene.nodes.size(); i-- > 0;)  // parents come before their children
    if (carries[i] && scene.nodes[i].parent) carries[*scene.nodes[i].parent] = true;
  return carries;
}

/// Whether a node alone moves geometry far off, perhaps for another to move it back.
bool any_far_node(const Scene& scene, double edge) {
  const std::vector<bool> carries = carriers(scene);
  std::vector<glm::dmat3> stretch(scene.nodes.size());
  for (size_t i = 0; i < scene.nodes.size(); ++i) {
    const Node& node = scene.nodes[i];
    const glm::dmat4 local = node.local();
    const glm::dmat3 above = node.parent ? stretch[*node.parent] : glm::dmat3(1);
    if (carries[i] && largest(above * glm::dvec3(local[3])) > far_sizes * edge) return true;
    stretch[i] = above * glm::dmat3(local);
  }
  return false;
}

/// Not inlined: GCC 12 leaves the rounding out where it makes vectors of several numbers.
[[gnu::noinline]] double as_float(double value) { return double(static_cast<float>(value)); }

void round_to_floats(Node& node) {
  for (int axis = 0; axis < 3; ++axis) node.transform.translation[axis] = as_float(node.transform.translation[axis]);
  for (int i = 0; node.matrix && i < 16; ++i) (*node.matrix)[i / 4][i % 4] = as_float((*node.matrix)[i / 4][i % 4]);
}

}  // namespace

glm::dvec3 origin_for(const Bounds& bounds) {
  const glm::dvec3 middle = (glm::dvec3(bounds.low) + glm::dvec3(bounds.high)) * 0.5;
  const double edge = largest(glm::dvec3(bounds.high) - glm::dvec3(bounds.low)), off = largest(middle);
  glm::dvec3 origin(0);
  if (std::isfinite(off) && off > near_sizes * edge)
    for (int axis = 0; axis < 3; ++axis)
      origin[axis] = roundest(middle[axis] - reach_sizes * edge, middle[axis] + reach_sizes * edge);
  return origin;
}

void choose_origin(Scene& scene) {
  const double edge = move_to_geometry(scene).longest_edge();
  if (edge > 0) move_meshes(scene, pose_at_rest(scene), edge);
  if (scene.origin != glm::dvec3(0) || any_far_node(scene, edge)) return;
  for (Node& node : scene.nodes) round_to_floats(node);
}

}  // namespace crsh::scene
