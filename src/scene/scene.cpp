#include "scene/scene.h"

#include <cassert>
#include <glm/gtc/matrix_transform.hpp>

#include "scene/animation.h"
#include "scene/deform.h"

namespace crsh::scene {

namespace {

glm::dmat4 matrix_of(const Transform& transform) {
  const glm::dmat4 moved = glm::translate(glm::dmat4(1), glm::dvec3(transform.translation));
  return glm::scale(moved * glm::mat4_cast(glm::dquat(transform.rotation)), glm::dvec3(transform.scale));
}

/// World matrices of all nodes, in double precision: far from the origin a chain of float matrices would be off by
/// centimetres.
std::vector<glm::dmat4> world_matrices(const std::vector<Node>& nodes, const std::vector<NodeState>& states) {
  std::vector<glm::dmat4> world(nodes.size());
  for (size_t i = 0; i < nodes.size(); ++i) {
    assert(!nodes[i].parent || *nodes[i].parent < i);  // load() puts parents before their children
    const glm::dmat4 local = nodes[i].matrix ? glm::dmat4(*nodes[i].matrix) : matrix_of(states[i].transform);
    world[i] = nodes[i].parent ? world[*nodes[i].parent] * local : local;
  }
  return world;
}

template <class T>
std::vector<glm::mat4> of_nodes(const std::vector<T>& things, const std::vector<glm::dmat4>& world) {
  std::vector<glm::mat4> out;
  out.reserve(things.size());
  for (const T& thing : things) out.emplace_back(world[thing.node]);
  return out;
}

/// Of each skin: where its joints carry what is bound to them (glTF 2.0, section 3.7.3.1).
std::vector<std::vector<glm::mat4>> joint_matrices(const std::vector<Skin>& skins,
                                                   const std::vector<glm::dmat4>& world) {
  std::vector<std::vector<glm::mat4>> out;
  for (const Skin& skin : skins) {
    std::vector<glm::mat4>& joints = out.emplace_back();
    joints.reserve(skin.joints.size());
    for (size_t j = 0; j < skin.joints.size(); ++j)
      joints.emplace_back(world[skin.joints[j]] * glm::dmat4(skin.inverse_bind[j]));
  }
  return out;
}

/// Of each instance; the node's own or animated ones go before the mesh's.
std::vector<std::vector<float>> morph_weights(const Scene& scene, const std::vector<NodeState>& states) {
  std::vector<std::vector<float>> out(scene.instances.size());
  for (size_t i = 0; i < out.size(); ++i) {
    const Mesh& mesh = scene.meshes[scene.instances[i].mesh];
    if (mesh.displacements.empty()) continue;
    const std::vector<float>& own = states[scene.instances[i].node].weights;
    out[i] = own.empty() ? mesh.weights : own;
    out[i].resize(mesh.target_count);
  }
  return out;
}

/// What is hidden shrinks to a point, which no ray meets; lights go out.
void hide_invisible(const Scene& scene, const std::vector<NodeState>& states, const std::vector<glm::dmat4>& world,
                    Pose& pose) {
  std::vector<bool> visible(states.size());
  for (size_t n = 0; n < states.size(); ++n)
    visible[n] = states[n].visible && (!scene.nodes[n].parent || visible[*scene.nodes[n].parent]);
  for (uint32_t i = 0; i < scene.instances.size(); ++i) {
    const uint32_t node = scene.instances[i].node;
    if (visible[node]) continue;
    pose.hidden.resize(scene.instances.size());
    pose.hidden[i] = true;
    pose.instances[i] = glm::mat4(0);
    pose.instances[i][3] = glm::vec4(world[node][3]);
  }
  for (uint32_t l = 0; l < scene.lights.size(); ++l)
    if (!visible[scene.lights[l].node]) pose.changes.lights.try_emplace(l, scene.lights[l]).first->second.intensity = 0;
}

}  // namespace

uint64_t Scene::triangle_count() const {
  uint64_t count = 0;
  for (const Instance& instance : instances) count += meshes[instance.mesh].triangles.size();
  return count;
}

Pose Scene::pose(double seconds, const std::vector<uint32_t>& playing) const {
  Animated now = animated(*this, seconds, playing);
  const std::vector<glm::dmat4> world = world_matrices(nodes, now.nodes);
  Pose out;
  out.instances = of_nodes(instances, world);
  out.lights = of_nodes(lights, world);
  out.cameras = of_nodes(cameras, world);
  out.changes = std::move(now.changes);
  out.joints = joint_matrices(skins, world);
  out.weights = morph_weights(*this, now.nodes);
  for (size_t i = 0; i < instances.size(); ++i) {
    if (instances[i].local) out.instances[i] = world[instances[i].node] * glm::dmat4(*instances[i].local);
    if (instances[i].skin) out.instances[i] = glm::mat4(1);
  }
  hide_invisible(*this, now.nodes, world, out);
  return out;
}

Bounds Scene::bounds(const Pose& pose) const {
  Bounds out;
  for (uint32_t i = 0; i < instances.size(); ++i) {
    if (!pose.hidden.empty() && pose.hidden[i]) continue;
    std::vector<glm::vec3> deformed;
    if (deforms(*this, instances[i])) deformed = posed_positions(*this, pose, i);
    for (const glm::vec3& position : deformed.empty() ? meshes[instances[i].mesh].positions : deformed) {
      const glm::vec3 moved(glm::dmat4(pose.instances[i]) * glm::dvec4(position, 1));
      out.low = glm::min(out.low, moved);
      out.high = glm::max(out.high, moved);
    }
  }
  return out;
}

}  // namespace crsh::scene
