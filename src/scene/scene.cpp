#include "scene/scene.h"

#include <fmt/format.h>

#include <cassert>
#include <charconv>
#include <glm/gtc/matrix_transform.hpp>

#include "scene/animation.h"
#include "scene/deform.h"

namespace crsh::scene {

namespace {

glm::dmat4 matrix_of(const Transform& transform) {
  const glm::dmat4 moved = glm::translate(glm::dmat4(1), transform.translation);
  return glm::scale(moved * glm::mat4_cast(glm::dquat(transform.rotation)), glm::dvec3(transform.scale));
}

/// World matrices of all nodes, in double precision: far from the origin a chain of float matrices would be off by
/// centimetres.
std::vector<glm::dmat4> world_matrices(const std::vector<Node>& nodes, const std::vector<NodeState>& states) {
  std::vector<glm::dmat4> world(nodes.size());
  for (size_t i = 0; i < nodes.size(); ++i) {
    assert(!nodes[i].parent || *nodes[i].parent < i);  // load() puts parents before their children
    const glm::dmat4 local = nodes[i].matrix ? *nodes[i].matrix : matrix_of(states[i].transform);
    world[i] = nodes[i].parent ? world[*nodes[i].parent] * local : local;
  }
  return world;
}

glm::dvec3 lacking(const Scene& scene, const Instance& instance) { return scene.meshes[instance.mesh].origin; }
template <class T>
glm::dvec3 lacking(const Scene&, const T&) {
  return glm::dvec3(0);
}

template <class T>
std::vector<glm::mat4> of_nodes(const Scene& scene, const std::vector<T>& things,
                                const std::vector<glm::dmat4>& world) {
  std::vector<glm::mat4> out;
  out.reserve(things.size());
  for (const T& thing : things) out.push_back(scene.drawn(world[thing.node], lacking(scene, thing)));
  return out;
}

/// Of each skin: where its joints carry what is bound to them (glTF 2.0, section 3.7.3.1).
std::vector<std::vector<glm::mat4>> joint_matrices(const Scene& scene, const std::vector<glm::dmat4>& world) {
  std::vector<std::vector<glm::mat4>> out;
  for (const Skin& skin : scene.skins) {
    std::vector<glm::mat4>& joints = out.emplace_back();
    joints.reserve(skin.joints.size());
    for (size_t j = 0; j < skin.joints.size(); ++j)
      joints.push_back(scene.drawn(world[skin.joints[j]] * glm::dmat4(skin.inverse_bind[j])));
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
    pose.instances[i][3] = scene.drawn(world[node])[3];
  }
  for (uint32_t l = 0; l < scene.lights.size(); ++l)
    if (!visible[scene.lights[l].node]) pose.changes.lights.try_emplace(l, scene.lights[l]).first->second.intensity = 0;
}

/// The shortest decimal number that is this float, so that 0.1 stays 0.1.
double as_written(float value) {
  const std::string text = fmt::format("{}", value);
  double number = double(value);
  std::from_chars(text.data(), text.data() + text.size(), number);
  return number;
}

}  // namespace

glm::dmat4 Node::local() const { return matrix ? *matrix : matrix_of(transform); }

glm::dvec3 Scene::in_file(const glm::vec3& place) const {
  const glm::dvec3 written(as_written(place.x), as_written(place.y), as_written(place.z));
  return origin == glm::dvec3(0) ? written : origin + written;
}

glm::mat4 Scene::drawn(glm::dmat4 world, const glm::dvec3& lacking) const {
  if (lacking != glm::dvec3(0)) world[3] = world * glm::dvec4(lacking, 1);
  world[3] -= glm::dvec4(origin, 0);
  return glm::mat4(world);
}

uint64_t Scene::triangle_count() const {
  uint64_t count = 0;
  for (const Instance& instance : instances) count += meshes[instance.mesh].triangles.size();
  return count;
}

Pose Scene::pose(double seconds, const std::vector<uint32_t>& playing) const {
  Animated now = animated(*this, seconds, playing);
  const std::vector<glm::dmat4> world = world_matrices(nodes, now.nodes);
  Pose out;
  out.instances = of_nodes(*this, instances, world);
  out.lights = of_nodes(*this, lights, world);
  out.cameras = of_nodes(*this, cameras, world);
  out.changes = std::move(now.changes);
  out.joints = joint_matrices(*this, world);
  out.weights = morph_weights(*this, now.nodes);
  for (size_t i = 0; i < instances.size(); ++i) {
    if (instances[i].local)
      out.instances[i] =
          drawn(world[instances[i].node] * glm::dmat4(*instances[i].local), lacking(*this, instances[i]));
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
    for (const glm::vec3& position : deformed.empty() ? meshes[instances[i].mesh].positions : deformed)
      out.include(glm::vec3(glm::dmat4(pose.instances[i]) * glm::dvec4(position, 1)));
  }
  return out;
}

}  // namespace crsh::scene
