#include "scene/scene.h"

#include <fmt/format.h>

#include <cassert>
#include <glm/gtc/matrix_transform.hpp>

#include "crsh/error.h"
#include "scene/animation.h"

namespace crsh::scene {

namespace {

glm::dmat4 matrix_of(const Transform& transform) {
  const glm::dmat4 moved = glm::translate(glm::dmat4(1), glm::dvec3(transform.translation));
  return glm::scale(moved * glm::mat4_cast(glm::dquat(transform.rotation)), glm::dvec3(transform.scale));
}

void apply(const Channel& channel, double seconds, Transform& transform) {
  const glm::vec4 value = sample(channel, seconds);
  switch (channel.path) {
    case Path::translation: transform.translation = glm::vec3(value); break;
    case Path::rotation: transform.rotation = glm::quat(value.w, value.x, value.y, value.z); break;
    case Path::scale: transform.scale = glm::vec3(value); break;
  }
}

/// World matrices of all nodes, in double precision: far from the origin a chain of float matrices would be off by
/// centimetres.
std::vector<glm::dmat4> world_matrices(const std::vector<Node>& nodes, const std::vector<Transform>& transforms) {
  std::vector<glm::dmat4> world(nodes.size());
  for (size_t i = 0; i < nodes.size(); ++i) {
    assert(!nodes[i].parent || *nodes[i].parent < i);  // load() puts parents before their children
    const glm::dmat4 local = nodes[i].matrix ? glm::dmat4(*nodes[i].matrix) : matrix_of(transforms[i]);
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

}  // namespace

uint64_t Scene::triangle_count() const {
  uint64_t count = 0;
  for (const Instance& instance : instances) count += meshes[instance.mesh].triangles.size();
  return count;
}

std::optional<uint32_t> Scene::find_animation(const std::string& which) const {
  if (which.empty()) return animations.empty() ? std::nullopt : std::optional<uint32_t>(0);
  for (uint32_t i = 0; i < animations.size(); ++i)
    if (animations[i].name == which || std::to_string(i) == which) return i;
  std::string names;
  for (const Animation& animation : animations) names += " '" + animation.name + "'";
  throw UserError(fmt::format("{}: has no animation '{}'; it has {}:{}", path.string(), which, animations.size(),
                              names.empty() ? " none" : names));
}

Pose Scene::pose(double seconds, std::optional<uint32_t> animation) const {
  std::vector<Transform> transforms;
  transforms.reserve(nodes.size());
  for (const Node& node : nodes) transforms.push_back(node.transform);
  if (animation) {
    assert(*animation < animations.size());
    for (const Channel& channel : animations[*animation].channels) apply(channel, seconds, transforms[channel.node]);
  }
  const std::vector<glm::dmat4> world = world_matrices(nodes, transforms);
  return {of_nodes(instances, world), of_nodes(lights, world), of_nodes(cameras, world)};
}

Bounds Scene::bounds(const Pose& pose) const {
  Bounds out;
  for (size_t i = 0; i < instances.size(); ++i)
    for (const glm::vec3& position : meshes[instances[i].mesh].positions) {
      const glm::vec3 moved(glm::dmat4(pose.instances[i]) * glm::dvec4(position, 1));
      out.low = glm::min(out.low, moved);
      out.high = glm::max(out.high, moved);
    }
  return out;
}

}  // namespace crsh::scene
