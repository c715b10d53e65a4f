#include "scene/gltf/attachments.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "scene/gltf/accessor.h"
#include "scene/gltf/mesh.h"

namespace crsh::scene {

namespace {

constexpr float brightest = 1e15f;

/// The node that a skinned mesh hangs on: its first joint times that joint's inverse bind matrix, which in bind pose
/// is where the skin puts the whole mesh (glTF 2.0, section 3.7.3: the mesh's own node does not count).
uint32_t skin_node(Document& document, uint64_t skin, uint32_t mesh_node, const NodeMap& nodes, Scene& scene) {
  const Fields fields = document.root().element("skins", skin);
  const std::vector<uint64_t> joints = fields.wholes("joints");
  if (joints.empty() || joints[0] >= nodes.node_of.size())
    throw Fault(fields.name_of("joints") + " names no node of the file");
  if (!nodes.node_of[joints[0]]) return mesh_node;
  Node out;
  out.name = scene.nodes[mesh_node].name;
  out.parent = nodes.node_of[joints[0]];
  if (const std::optional<uint64_t> matrices = fields.whole("inverseBindMatrices")) {
    const Accessor accessor(document, *matrices);
    accessor.need_components({16});
    if (accessor.count() == 0) throw Fault(accessor.where() + " is empty");
    out.matrix = accessor.matrix_at(0);
    for (int c = 0; c < 4; ++c)
      if (!std::isfinite(glm::dot((*out.matrix)[c], glm::vec4(1)))) return mesh_node;
  }
  scene.nodes.push_back(out);
  return static_cast<uint32_t>(scene.nodes.size() - 1);
}

/// Reads meshes when a node first uses them.
class MeshList {
 public:
  MeshList(Document& document, Scene& scene, Notes& notes) : document_(document), scene_(scene), notes_(notes) {}

  /// The mesh's place in the scene; none where it has no triangles.
  std::optional<uint32_t> place(uint64_t index) {
    const auto [found, fresh] = places_.try_emplace(index);
    if (fresh) found->second = append(index);
    return found->second;
  }

 private:
  std::optional<uint32_t> append(uint64_t index) {
    const auto default_material = static_cast<uint32_t>(document_.root().size("materials"));
    Mesh mesh = read_mesh(document_, index, default_material, notes_);
    if (mesh.triangles.empty()) return {};
    scene_.meshes.push_back(std::move(mesh));
    return static_cast<uint32_t>(scene_.meshes.size() - 1);
  }

  Document& document_;
  Scene& scene_;
  Notes& notes_;
  std::map<uint64_t, std::optional<uint32_t>> places_;
};

std::string first_filled(const std::string& name, const std::string& otherwise) {
  return name.empty() ? otherwise : name;
}

void read_perspective(Camera& out, const Fields& fields) {
  out.yfov = fields.needed_number("yfov");
  if (!(out.yfov > 0 && out.yfov < std::numbers::pi_v<float>))
    throw Fault(fields.name_of("yfov") + " is not between 0 and 180 degrees");
  out.near_plane = fields.needed_number("znear");
  if (!(out.near_plane > 0)) throw Fault(fields.name_of("znear") + " is not positive");
  if (const auto aspect = fields.number("aspectRatio"); aspect && *aspect > 0) out.aspect = aspect;
}

void read_orthographic(Camera& out, const Fields& fields) {
  out.orthographic = true;
  out.xmag = std::abs(fields.needed_number("xmag"));
  out.ymag = std::abs(fields.needed_number("ymag"));
  if (!(out.xmag > 0 && out.ymag > 0)) throw Fault(fields.where() + " has no width or height");
  out.aspect = out.xmag / out.ymag;
  out.near_plane = fields.number("znear", 0);
}

Camera read_camera(const Fields& fields, uint32_t node, const std::string& node_name) {
  Camera out;
  out.name = first_filled(fields.text("name"), node_name);
  out.node = node;
  const std::string& type = fields.text("type");
  const std::optional<Fields> kind = fields.object(type == "orthographic" ? "orthographic" : "perspective");
  if ((type != "perspective" && type != "orthographic") || !kind)
    throw Fault(fields.name_of("type") + " is neither perspective nor orthographic");
  type == "perspective" ? read_perspective(out, *kind) : read_orthographic(out, *kind);
  return out;
}

LightType light_type(const Fields& fields) {
  const std::string& type = fields.text("type");
  if (type == "point") return LightType::point;
  if (type == "spot") return LightType::spot;
  if (type == "directional") return LightType::directional;
  throw Fault(fields.name_of("type") + " " + in_quotes(type, 20) + " is not known here");
}

/// Angles are brought in order, so that the falloff between them is never divided by less than nothing.
void read_cone(Light& out, const Fields& light) {
  const std::optional<Fields> spot = light.object("spot");
  if (!spot) return;
  out.outer_cone = std::clamp(spot->number("outerConeAngle", out.outer_cone), 0.0f, std::numbers::pi_v<float> / 2);
  out.inner_cone = std::clamp(spot->number("innerConeAngle", 0), 0.0f, out.outer_cone);
}

Light read_light(const Fields& fields, uint32_t node, const std::string& node_name) {
  Light out;
  out.name = first_filled(fields.text("name"), node_name);
  out.node = node;
  out.type = light_type(fields);
  if (const auto c = fields.numbers<3>("color"))
    out.colour = glm::clamp(glm::vec3((*c)[0], (*c)[1], (*c)[2]), 0.0f, brightest);
  out.intensity = std::clamp(fields.number("intensity", 1), 0.0f, brightest);
  if (const auto range = fields.number("range")) {
    if (*range <= 0) throw Fault(fields.name_of("range") + " is not positive");
    out.range = *range;
  }
  if (out.type == LightType::spot) read_cone(out, fields);
  return out;
}

}  // namespace

void read_instances(Document& document, const NodeMap& nodes, Scene& scene, Notes& notes) {
  const Fields root = document.root();
  MeshList meshes(document, scene, notes);
  for (uint32_t i = 0; i < nodes.file_of.size(); ++i) {
    const Fields fields = root.element("nodes", nodes.file_of[i]);
    const std::optional<uint64_t> file_mesh = fields.whole("mesh");
    if (!file_mesh) continue;
    const std::optional<uint32_t> mesh = meshes.place(*file_mesh);
    const std::optional<uint64_t> skin = fields.whole("skin");
    if (skin) notes.add("skins (drawn in bind pose)");
    if (mesh) scene.instances.push_back({*mesh, skin ? skin_node(document, *skin, i, nodes, scene) : i});
  }
}

void read_cameras(Document& document, const NodeMap& nodes, Scene& scene) {
  const Fields root = document.root();
  std::multimap<uint64_t, uint32_t> found;
  for (uint32_t i = 0; i < nodes.file_of.size(); ++i)
    if (const auto camera = root.element("nodes", nodes.file_of[i]).whole("camera")) found.emplace(*camera, i);
  for (const auto& [camera, node] : found)
    scene.cameras.push_back(read_camera(root.element("cameras", camera), node, scene.nodes[node].name));
}

void read_lights(Document& document, const NodeMap& nodes, Scene& scene) {
  const Fields root = document.root();
  const std::optional<Fields> list = root.extension("KHR_lights_punctual");
  for (uint32_t i = 0; i < nodes.file_of.size(); ++i) {
    const auto use = root.element("nodes", nodes.file_of[i]).extension("KHR_lights_punctual");
    if (!use) continue;
    if (!list) throw Fault(use->where() + " names a light, but the file has none");
    scene.lights.push_back(read_light(list->element("lights", use->needed_whole("light")), i, scene.nodes[i].name));
  }
}

}  // namespace crsh::scene
