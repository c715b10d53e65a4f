#include "scene/gltf/attachments.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "scene/gltf/checked.h"
#include "scene/gltf/extension.h"
#include "scene/gltf/instancing.h"
#include "scene/gltf/mesh.h"
#include "scene/gltf/skins.h"

namespace crsh::scene {

namespace {

constexpr float brightest = 1e15f;
constexpr uint64_t max_instances = uint64_t{1} << 20u;

/// Reads meshes when a node first uses them.
class MeshList {
 public:
  MeshList(Document& document, Scene& scene, Notes& notes, std::optional<uint32_t> variant)
      : document_(document), scene_(scene), notes_(notes), variant_(variant) {}

  /// The mesh's place in the scene; none where it has no triangles.
  std::optional<uint32_t> place(int64_t index) {
    const auto [found, fresh] = places_.try_emplace(index);
    if (fresh) found->second = append(index);
    return found->second;
  }

 private:
  std::optional<uint32_t> append(int64_t index) {
    const auto default_material = static_cast<uint32_t>(document_.model().materials.size());
    Mesh mesh = read_mesh(document_, index, default_material, notes_, {scene_.texcoords, variant_});
    if (mesh.triangles.empty()) return {};
    scene_.meshes.push_back(std::move(mesh));
    return static_cast<uint32_t>(scene_.meshes.size() - 1);
  }

  Document& document_;
  Scene& scene_;
  Notes& notes_;
  std::optional<uint32_t> variant_;
  std::map<int64_t, std::optional<uint32_t>> places_;
};

std::string first_filled(const std::string& name, const std::string& otherwise) {
  return name.empty() ? otherwise : name;
}

void read_perspective(Camera& out, const tinygltf::PerspectiveCamera& from, const std::string& where) {
  out.yfov = finite(from.yfov, where + ".yfov");
  if (!(out.yfov > 0 && out.yfov < std::numbers::pi_v<float>))
    throw Fault(where + ".yfov is not between 0 and 180 degrees");
  out.near_plane = finite(from.znear, where + ".znear");
  if (!(out.near_plane > 0)) throw Fault(where + ".znear is not positive");
  if (from.zfar > from.znear) out.far_plane = finite(from.zfar, where + ".zfar");
  if (from.aspectRatio > 0) out.aspect = finite(from.aspectRatio, where + ".aspectRatio");
}

void read_orthographic(Camera& out, const tinygltf::OrthographicCamera& from, const std::string& where) {
  out.orthographic = true;
  out.xmag = std::abs(finite(from.xmag, where + ".xmag"));
  out.ymag = std::abs(finite(from.ymag, where + ".ymag"));
  if (!(out.xmag > 0 && out.ymag > 0)) throw Fault(where + " has no width or height");
  out.aspect = out.xmag / out.ymag;
  out.near_plane = finite(from.znear, where + ".znear");
  if (from.zfar > from.znear) out.far_plane = finite(from.zfar, where + ".zfar");
}

Camera read_camera(const tinygltf::Camera& from, const std::string& where, uint32_t node,
                   const std::string& node_name) {
  Camera out;
  out.name = first_filled(from.name, node_name);
  out.node = node;
  if (from.type == "perspective") read_perspective(out, from.perspective, where + ".perspective");
  else read_orthographic(out, from.orthographic, where + ".orthographic");
  return out;
}

LightType light_type(const Extension& fields) {
  const std::string type = fields.text("type");
  if (type == "point") return LightType::point;
  if (type == "spot") return LightType::spot;
  if (type == "directional") return LightType::directional;
  throw Fault(fields.name_of("type") + " " + in_quotes(type, 20) + " is not known here");
}

/// Angles are brought in order, so that the falloff between them is never divided by less than nothing.
void read_cone(Light& out, const Extension& light) {
  const std::optional<Extension> spot = light.object("spot");
  if (!spot) return;
  out.outer_cone = std::clamp(spot->number("outerConeAngle", out.outer_cone), 0.0f, std::numbers::pi_v<float> / 2);
  out.inner_cone = std::clamp(spot->number("innerConeAngle", 0), 0.0f, out.outer_cone);
}

Light read_light(const Extension& fields, uint32_t node, const std::string& node_name) {
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

/// What deforms is worked out for each instance: a small file could have many of a mesh that many joints move.
void spend_on_deforming(Document& document, const Mesh& mesh) {
  document.spend(mesh.influences.items.size() + mesh.displacements.items.size() + mesh.target_count);
}

/// One, or as many as the node says (EXT_mesh_gpu_instancing).
void append_instances(Document& document, const tinygltf::Node& from, Instance instance, const std::string& where,
                      Scene& scene) {
  const auto append = [&] {
    spend_on_deforming(document, scene.meshes[instance.mesh]);
    scene.instances.push_back(instance);
  };
  const auto instancing = Extension::of(from.extensions, "EXT_mesh_gpu_instancing", where);
  if (!instancing) return append();
  const uint64_t left = max_instances - std::min<uint64_t>(max_instances, scene.instances.size());
  for (const glm::mat4& transform : instance_transforms(document, *instancing, left)) {
    instance.local = transform;
    append();
  }
}

}  // namespace

void read_instances(Document& document, const NodeMap& nodes, Scene& scene, Notes& notes,
                    std::optional<uint32_t> variant) {
  MeshList meshes(document, scene, notes, variant);
  SkinReader skins(document, nodes, scene, notes);
  const auto attach = [&](uint32_t i, const std::string& where) {
    const tinygltf::Node& from = at(document.model().nodes, nodes.file_of[i], "nodes");
    if (from.mesh < 0) return;
    const std::optional<uint32_t> mesh = meshes.place(from.mesh);
    if (!mesh) return;
    const auto skin = from.skin < 0 ? std::nullopt : skins.place(from.skin, scene.meshes[*mesh], i);
    append_instances(document, from, {*mesh, i, skin, {}}, where, scene);
  };
  for (uint32_t i = 0; i < nodes.file_of.size(); ++i) {
    const std::string where = place("nodes", nodes.file_of[i]);
    notes.attempt(where, [&] { attach(i, where); });
  }
}

FilePlaces read_cameras(Document& document, const NodeMap& nodes, Scene& scene, Notes& notes) {
  const tinygltf::Model& model = document.model();
  std::multimap<int, uint32_t> found;
  for (uint32_t i = 0; i < nodes.file_of.size(); ++i)
    if (const int camera = at(model.nodes, nodes.file_of[i], "nodes").camera; camera >= 0) found.emplace(camera, i);
  FilePlaces places;
  for (const auto& use : found) {
    const std::string where = place("cameras", use.first);
    notes.attempt(where, [&] {
      document.check(where);
      scene.cameras.push_back(
          read_camera(at(model.cameras, use.first, "cameras"), where, use.second, scene.nodes[use.second].name));
      places.emplace(use.first, static_cast<uint32_t>(scene.cameras.size() - 1));
    });
  }
  return places;
}

FilePlaces read_lights(Document& document, const NodeMap& nodes, Scene& scene, Notes& notes) {
  constexpr const char* name = "KHR_lights_punctual";
  const tinygltf::Model& model = document.model();
  const std::optional<Extension> list = Extension::of(model.extensions, name, "");
  FilePlaces places;
  for (uint32_t i = 0; i < nodes.file_of.size(); ++i) {
    const int64_t node = nodes.file_of[i];
    const auto use = Extension::of(at(model.nodes, node, "nodes").extensions, name, place("nodes", node));
    if (!use) continue;
    notes.attempt(use->where(), [&] {
      if (!list) throw Fault(use->where() + " names a light, but the file has none");
      const Extension light = list->element("lights", use->index("light"));
      document.check(light.where());
      scene.lights.push_back(read_light(light, i, scene.nodes[i].name));
      places.emplace(use->index("light"), static_cast<uint32_t>(scene.lights.size() - 1));
    });
  }
  return places;
}

}  // namespace crsh::scene
