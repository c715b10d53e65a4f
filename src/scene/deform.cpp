#include "scene/deform.h"

#include <algorithm>
#include <cmath>

#include "scene/smallest_sphere.h"

namespace crsh::scene {
namespace {

using glm::dvec3;

float weight_of(const std::vector<float>& weights, uint32_t target) {
  return target < weights.size() ? weights[target] : 0;
}

dvec3 morphed(const Mesh& mesh, const std::vector<float>& weights, size_t vertex) {
  dvec3 position(mesh.positions[vertex]);
  for (const Displacement& d : mesh.displacements.of(vertex))
    position += dvec3(d.position) * double(weight_of(weights, d.target));
  return position;
}

dvec3 skinned(const Mesh& mesh, const std::vector<glm::mat4>& joints, size_t vertex, const dvec3& position) {
  dvec3 sum(0);
  for (const Influence& influence : mesh.influences.of(vertex))
    sum +=
        dvec3(glm::dmat4(joint_matrix(joints, influence.joint)) * glm::dvec4(position, 1)) * double(influence.weight);
  return sum;
}

/// How far morph targets of these weights may move any vertex.
Bounds reach_of(const Mesh& mesh, const std::vector<float>& weights) {
  Bounds reach{glm::vec3(0), glm::vec3(0)};
  for (uint32_t t = 0; t < mesh.target_boxes.size(); ++t) {
    const Bounds& box = mesh.target_boxes[t];
    const float weight = weight_of(weights, t);
    if (box.empty() || weight == 0) continue;
    const glm::vec3 a = box.low * weight, b = box.high * weight;
    reach.low += glm::min(glm::min(a, b), glm::vec3(0));
    reach.high += glm::max(glm::max(a, b), glm::vec3(0));
  }
  return reach;
}

/// The box around a box's corners once they are moved.
Bounds moved(const glm::mat4& transform, const Bounds& box) {
  const glm::dmat4 exact(transform);
  Bounds out;
  for (int i = 0; i < 8; ++i)
    out.include(glm::vec3(exact * glm::dvec4(i & 1 ? box.high.x : box.low.x, i & 2 ? box.high.y : box.low.y,
                                             i & 4 ? box.high.z : box.low.z, 1)));
  return out;
}

/// Wider by what float arithmetic may round.
Bounds padded(Bounds box) {
  const glm::vec3 size = glm::max(glm::abs(box.low), glm::abs(box.high));
  const float pad = std::max({size.x, size.y, size.z}) / 65536;
  box.low -= pad;
  box.high += pad;
  return box;
}

double determinant_of(const glm::mat4& m) { return glm::determinant(glm::dmat3(glm::dmat4(m))); }

}  // namespace

void fill_deform_bounds(Mesh& mesh) {
  std::map<uint32_t, Bounds> boxes;
  for (size_t v = 0; v < mesh.positions.size(); ++v)
    for (const Influence& influence : mesh.influences.of(v)) boxes[influence.joint].include(mesh.positions[v]);
  mesh.joint_boxes.clear();
  for (const auto& [joint, box] : boxes) {
    mesh.joint_boxes.push_back({joint, box});
    if (joint != unskinned) mesh.joint_count = joint + 1;
  }
  mesh.target_boxes.assign(mesh.target_count, Bounds());
  for (const Displacement& d : mesh.displacements.items) mesh.target_boxes[d.target].include(d.position);
}

bool deforms(const Scene& scene, const Instance& instance) {
  return instance.skin.has_value() || !scene.meshes[instance.mesh].displacements.empty();
}

const glm::mat4& joint_matrix(const std::vector<glm::mat4>& joints, uint32_t joint) {
  return joint == unskinned ? joints.back() : joints[joint];
}

std::vector<glm::vec3> posed_positions(const Scene& scene, const GeometryPose& pose, uint32_t instance) {
  const Instance& one = scene.instances[instance];
  const Mesh& mesh = scene.meshes[one.mesh];
  if (!deforms(scene, one)) return mesh.positions;
  std::vector<glm::vec3> out;
  out.reserve(mesh.positions.size());
  for (size_t v = 0; v < mesh.positions.size(); ++v) {
    const dvec3 position = morphed(mesh, pose.weights[instance], v);
    out.emplace_back(one.skin ? skinned(mesh, pose.joints[*one.skin], v, position) : position);
  }
  return out;
}

Bounds posed_bounds(const Scene& scene, const GeometryPose& pose, uint32_t instance) {
  const Instance& one = scene.instances[instance];
  const Mesh& mesh = scene.meshes[one.mesh];
  const Bounds reach = reach_of(mesh, pose.weights[instance]);
  const auto reached = [&](const Bounds& box) { return Bounds{box.low + reach.low, box.high + reach.high}; };
  Bounds out;
  if (one.skin) {
    for (const JointBox& part : mesh.joint_boxes)
      out.include(moved(joint_matrix(pose.joints[*one.skin], part.joint), reached(part.box)));
    return padded(out);
  }
  Bounds rest;
  for (const glm::vec3& position : mesh.positions) rest.include(position);
  return padded(moved(pose.instances[instance], reached(rest)));
}

bool is_mirrored(const Scene& scene, const GeometryPose& pose, uint32_t instance) {
  const Instance& one = scene.instances[instance];
  if (!one.skin) return determinant_of(pose.instances[instance]) < 0;
  int64_t mirrored = 0;
  for (const JointBox& part : scene.meshes[one.mesh].joint_boxes) {
    const double sign = determinant_of(joint_matrix(pose.joints[*one.skin], part.joint));
    mirrored += (sign < 0) - (sign > 0);
  }
  return mirrored > 0;
}

Sphere posed_sphere(const Scene& scene, const GeometryPose& pose, uint32_t instance) {
  if (!pose.hidden.empty() && pose.hidden[instance]) return {};
  const Instance& one = scene.instances[instance];
  if (!deforms(scene, one)) return transformed_sphere(scene.meshes[one.mesh], pose.instances[instance]);
  const Bounds box = posed_bounds(scene, pose, instance);
  const dvec3 low(box.low), high(box.high);
  return {glm::vec3((low + high) / 2.0), rounded_outwards(glm::distance(low, high) / 2)};
}

}  // namespace crsh::scene
