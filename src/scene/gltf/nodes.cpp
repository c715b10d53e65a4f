#include "scene/gltf/nodes.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <glm/gtc/type_ptr.hpp>

#include "scene/gltf/checked.h"
#include "scene/gltf/extension.h"
#include "scene/gltf/fault.h"

namespace crsh::scene {

namespace {

/// `which` as an index below `end`, where it is one.
std::optional<int64_t> index_in(const std::string& which, size_t end) {
  size_t value = 0;
  const auto [rest, error] = std::from_chars(which.data(), which.data() + which.size(), value);
  const bool whole = error == std::errc() && rest == which.data() + which.size();
  return whole && value < end ? std::optional(static_cast<int64_t>(value)) : std::nullopt;
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

/// None: the file has no scenes.
std::optional<int64_t> chosen_scene(const tinygltf::Model& model, const std::string& which,
                                    const std::vector<std::string>& names) {
  if (which.empty()) {
    const int64_t standard = model.defaultScene;
    if (standard >= static_cast<int64_t>(names.size())) throw Fault("'scene' names a scene that is not in the file");
    return standard >= 0 ? std::optional(standard) : names.empty() ? std::nullopt : std::optional<int64_t>(0);
  }
  if (const std::optional<int64_t> index = index_in(which, names.size())) return index;
  const auto named = std::find(names.begin(), names.end(), which);
  if (named == names.end()) no_such_scene(which, names);
  return named - names.begin();
}

/// All nodes that are no node's child.
std::vector<int> root_nodes(const tinygltf::Model& model) {
  std::vector<bool> child(model.nodes.size(), false);
  for (const tinygltf::Node& node : model.nodes)
    for (const int c : node.children)
      if (static_cast<size_t>(c) < child.size()) child[static_cast<size_t>(c)] = true;
  std::vector<int> out;
  for (size_t i = 0; i < child.size(); ++i)
    if (!child[i]) out.push_back(static_cast<int>(i));
  return out;
}

/// The numbers of a field, or `otherwise` where the file has none. A Fault where one is none, or more than floats hold.
template <size_t N>
std::array<double, N> numbers(const std::vector<double>& from, const std::string& name,
                              const std::array<double, N>& otherwise) {
  if (from.size() != N) return otherwise;
  std::array<double, N> out;
  for (size_t i = 0; i < N; ++i) (void)finite(from[i], name), out[i] = from[i];
  return out;
}

glm::dvec3 vec3_of(const std::vector<double>& from, const std::string& name, double otherwise) {
  return glm::make_vec3(numbers<3>(from, name, {otherwise, otherwise, otherwise}).data());
}

/// glTF writes x, y, z, w. What is not of unit length is made so, zero is no rotation.
glm::quat rotation_of(const std::vector<double>& from, const std::string& name) {
  if (from.empty()) return {1, 0, 0, 0};
  const auto v = numbers<4>(from, name, {0, 0, 0, 1});
  const glm::dquat rotation(glm::quat(glm::dquat(v[3], v[0], v[1], v[2])));
  const double length = glm::length(rotation);
  return length > 0 ? glm::quat(rotation / length) : glm::quat(1, 0, 0, 0);
}

Node read_node(const tinygltf::Node& from, const std::string& where, std::optional<uint32_t> parent) {
  Node out;
  out.name = from.name;
  out.parent = parent;
  if (!from.matrix.empty()) out.matrix = glm::make_mat4(numbers<16>(from.matrix, where + ".matrix", {}).data());
  out.transform = {vec3_of(from.translation, where + ".translation", 0),
                   rotation_of(from.rotation, where + ".rotation"), vec3_of(from.scale, where + ".scale", 1)};
  for (const double weight : from.weights) out.weights.push_back(finite(weight, where + ".weights"));
  if (const auto visibility = Extension::of(from.extensions, "KHR_node_visibility", where))
    out.visible = visibility->flag("visible", true);
  return out;
}

}  // namespace

NodeMap read_nodes(Document& document, const std::string& which, Scene& scene) {
  const tinygltf::Model& model = document.model();
  for (const tinygltf::Scene& one : model.scenes) scene.scene_names.push_back(one.name);
  const std::optional<int64_t> chosen = chosen_scene(model, which, scene.scene_names);
  if (chosen) scene.name = scene.scene_names[static_cast<size_t>(*chosen)];

  struct Waiting {
    int64_t node;
    std::optional<uint32_t> parent;
  };
  std::vector<Waiting> stack;  // not recursion: a file may nest nodes as deep as it likes
  const auto push = [&stack](const std::vector<int>& nodes, std::optional<uint32_t> parent) {
    for (auto node = nodes.rbegin(); node != nodes.rend(); ++node) stack.push_back({*node, parent});
  };
  push(chosen ? at(model.scenes, *chosen, "scenes").nodes : root_nodes(model), std::nullopt);

  NodeMap map;
  map.node_of.resize(model.nodes.size());
  while (!stack.empty()) {
    const auto [node, parent] = stack.back();
    stack.pop_back();
    const tinygltf::Node& from = at(model.nodes, node, "nodes");
    const std::string where = place("nodes", node);
    auto& index = map.node_of[static_cast<size_t>(node)];
    if (index) throw Fault(where + " is reached twice: it has two parents, or is its own ancestor");
    index = static_cast<uint32_t>(scene.nodes.size());
    map.file_of.push_back(node);
    scene.nodes.push_back(read_node(from, where, parent));
    push(from.children, index);
  }
  return map;
}

}  // namespace crsh::scene
