#include "scene/gltf/nodes.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <glm/gtc/type_ptr.hpp>

#include "scene/gltf/fault.h"

namespace crsh::scene {

namespace {

/// `which` as an index below `end`, where it is one.
std::optional<uint64_t> index_in(const std::string& which, uint64_t end) {
  uint64_t value = 0;
  const auto [rest, error] = std::from_chars(which.data(), which.data() + which.size(), value);
  const bool whole = error == std::errc() && rest == which.data() + which.size();
  return whole && value < end ? std::optional(value) : std::nullopt;
}

[[noreturn]] void no_such_scene(const std::string& which, const std::vector<std::string>& names) {
  std::string list;
  for (size_t i = 0; i < std::min<size_t>(names.size(), 8); ++i) {
    list.append(i ? ", " : "").append(std::to_string(i));
    if (!names[i].empty()) list.append(" ").append(in_quotes(names[i], 40));
  }
  throw Fault("has no scene " + in_quotes(which, 40),
              names.empty() ? "name none, for it has none" : "choose one of " + list);
}

std::optional<uint64_t> chosen_scene(const Fields& root, const std::string& which,
                                     const std::vector<std::string>& names) {
  if (which.empty()) {
    const std::optional<uint64_t> standard = root.whole("scene");
    if (standard && *standard >= names.size()) throw Fault("'scene' names a scene that is not in the file");
    return standard ? standard : names.empty() ? std::nullopt : std::optional<uint64_t>(0);
  }
  if (const std::optional<uint64_t> index = index_in(which, names.size())) return index;
  const auto named = std::find(names.begin(), names.end(), which);
  if (named == names.end()) no_such_scene(which, names);
  return static_cast<uint64_t>(named - names.begin());
}

/// All nodes that are no node's child.
std::vector<uint64_t> root_nodes(const Fields& root) {
  std::vector<bool> child(root.size("nodes"), false);
  for (size_t i = 0; i < child.size(); ++i)
    for (const uint64_t c : root.element("nodes", i).wholes("children"))
      if (c < child.size()) child[c] = true;
  std::vector<uint64_t> out;
  for (size_t i = 0; i < child.size(); ++i)
    if (!child[i]) out.push_back(i);
  return out;
}

glm::vec3 vec3_of(const Fields& fields, const char* key, const glm::vec3& otherwise) {
  const auto values = fields.numbers<3>(key);
  return values ? glm::make_vec3(values->data()) : otherwise;
}

/// glTF writes x, y, z, w. What is not of unit length is made so, zero is no rotation.
glm::quat rotation_of(const Fields& fields) {
  const auto v = fields.numbers<4>("rotation");
  if (!v) return {1, 0, 0, 0};
  const glm::dquat rotation((*v)[3], (*v)[0], (*v)[1], (*v)[2]);
  const double length = glm::length(rotation);
  return length > 0 ? glm::quat(rotation / length) : glm::quat(1, 0, 0, 0);
}

Node read_node(const Fields& fields, std::optional<uint32_t> parent) {
  Node out;
  out.name = fields.text("name");
  out.parent = parent;
  if (const auto matrix = fields.numbers<16>("matrix")) out.matrix = glm::make_mat4(matrix->data());
  out.transform = {vec3_of(fields, "translation", glm::vec3(0)), rotation_of(fields),
                   vec3_of(fields, "scale", glm::vec3(1))};
  return out;
}

}  // namespace

NodeMap read_nodes(Document& document, const std::string& which, Scene& scene) {
  const Fields root = document.root();
  for (size_t i = 0; i < root.size("scenes"); ++i) scene.scene_names.push_back(root.element("scenes", i).text("name"));
  const std::optional<uint64_t> chosen = chosen_scene(root, which, scene.scene_names);
  if (chosen) scene.name = scene.scene_names[*chosen];

  struct Waiting {
    uint64_t node;
    std::optional<uint32_t> parent;
  };
  std::vector<Waiting> stack;  // not recursion: a file may nest nodes as deep as it likes
  const auto push = [&stack](const std::vector<uint64_t>& nodes, std::optional<uint32_t> parent) {
    for (auto node = nodes.rbegin(); node != nodes.rend(); ++node) stack.push_back({*node, parent});
  };
  push(chosen ? root.element("scenes", *chosen).wholes("nodes") : root_nodes(root), std::nullopt);

  NodeMap map;
  map.node_of.resize(root.size("nodes"));
  while (!stack.empty()) {
    const auto [node, parent] = stack.back();
    stack.pop_back();
    const Fields fields = root.element("nodes", node);
    if (map.node_of[node])
      throw Fault(fields.where() + " is reached twice: it has two parents, or is its own ancestor");
    const auto index = static_cast<uint32_t>(scene.nodes.size());
    map.node_of[node] = index;
    map.file_of.push_back(node);
    scene.nodes.push_back(read_node(fields, parent));
    push(fields.wholes("children"), index);
  }
  return map;
}

}  // namespace crsh::scene
