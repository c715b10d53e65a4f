#include <cmath>
#include <new>
#include <set>
#include <stdexcept>

#include "crsh/error.h"
#include "scene/gltf/animations.h"
#include "scene/gltf/attachments.h"
#include "scene/gltf/document.h"
#include "scene/gltf/fault.h"
#include "scene/gltf/known_extensions.h"
#include "scene/gltf/load.h"
#include "scene/gltf/material.h"
#include "scene/gltf/nodes.h"
#include "scene/gltf/texcoords.h"
#include "scene/gltf/variants.h"
#include "scene/origin.h"
#include "scene/properties.h"
#include "scene/tangents.h"

namespace crsh::scene {

namespace {

constexpr uint64_t max_work = uint64_t{1} << 30u;  // elements
constexpr float farthest = 1e15f;                  // metres; squares and products stay within float

std::set<uint32_t> materials_used(const Scene& scene) {
  std::set<uint32_t> used;
  for (const Mesh& mesh : scene.meshes) used.insert(mesh.materials.begin(), mesh.materials.end());
  return used;
}

void check_transform(const glm::mat4& m, const Node& node) {
  for (int c = 0; c < 4; ++c)
    for (int r = 0; r < 4; ++r)
      if (!(std::abs(m[c][r]) <= farthest))
        throw Fault("node " + in_quotes(node.name, 60) + " is moved or scaled beyond what can be drawn");
}

/// Transforms may multiply to more than a float holds.
void check_transforms(const Scene& scene) {
  const Pose pose = scene.pose(0, {});
  for (size_t i = 0; i < pose.instances.size(); ++i)
    check_transform(pose.instances[i], scene.nodes[scene.instances[i].node]);
  for (size_t s = 0; s < scene.skins.size(); ++s)
    for (size_t j = 0; j < scene.skins[s].joints.size(); ++j)
      check_transform(pose.joints[s][j], scene.nodes[scene.skins[s].joints[j]]);
}

/// Nodes that no animation makes visible, nor any node above them.
std::vector<bool> never_seen(const Scene& scene) {
  std::vector<bool> shown(scene.nodes.size()), hidden(scene.nodes.size());
  for (const Animation& animation : scene.animations)
    for (const Channel& channel : animation.channels)
      if (channel.target.driven == Driven::node && channel.target.property == node_visible)
        shown[channel.target.object] = true;
  for (size_t n = 0; n < hidden.size(); ++n)
    hidden[n] = (!scene.nodes[n].visible && !shown[n]) || (scene.nodes[n].parent && hidden[*scene.nodes[n].parent]);
  return hidden;
}

/// Leaves out instances that are never seen, so that they cost nothing.
void drop_hidden(Scene& scene) {
  const std::vector<bool> hidden = never_seen(scene);
  std::erase_if(scene.instances, [&](const Instance& instance) { return hidden[instance.node]; });
}

Scene read(const std::filesystem::path& path, const LoadOptions& options) {
  Document document(path, options.reach, max_work, options.lenient);
  Scene scene;
  scene.path = path;
  Notes notes(scene.unsupported);
  note_extensions(document.extensions(), notes);
  scene.texcoords = texcoords_used(document);
  const NodeMap nodes = read_nodes(document, options.scene, scene);
  scene.variants = variant_names(document);
  read_instances(document, nodes, scene, notes, chosen_variant(scene.variants, options.variant));
  if (scene.instances.empty() && notes.first_fault()) throw Fault(*notes.first_fault());
  read_materials(document, materials_used(scene), scene, notes);
  fill_tangents(scene);
  const FilePlaces cameras = read_cameras(document, nodes, scene, notes);
  const FilePlaces lights = read_lights(document, nodes, scene, notes);
  read_animations(document, {nodes, cameras, lights}, scene, notes);
  drop_hidden(scene);
  check_transforms(scene);
  choose_origin(scene);
  return scene;
}

std::string line(const std::filesystem::path& path, const std::string& reason, const std::string& mend) {
  return printable(path.string(), 4096) + ": " + printable(reason, 1200) + "; " + printable(mend, 400);
}

[[noreturn]] void refuse_as_too_large(const std::filesystem::path& path) {
  throw UserError(line(path, "does not fit in memory", "split or simplify the scene"));
}

}  // namespace

Scene load(const std::filesystem::path& path, const LoadOptions& options) {
  try {
    return read(path, options);
  } catch (const OutsideFault& fault) {
    throw OutsideError(line(path, fault.what(), fault.mend()));
  } catch (const NeedsExtensions& fault) {
    throw ExtensionError(line(path, fault.what(), fault.mend()));
  } catch (const Fault& fault) {
    throw UserError(line(path, fault.what(), fault.mend()));
  } catch (const std::bad_alloc&) {
    refuse_as_too_large(path);
  } catch (const std::length_error&) {
    refuse_as_too_large(path);
  }
}

Scene load(const std::filesystem::path& path, const std::string& which, Reach reach) {
  return load(path, LoadOptions{.scene = which, .reach = reach});
}

}  // namespace crsh::scene
