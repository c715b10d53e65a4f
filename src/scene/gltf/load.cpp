#include <algorithm>
#include <array>
#include <cmath>
#include <new>
#include <set>
#include <stdexcept>

#include "crsh/error.h"
#include "scene/gltf/animations.h"
#include "scene/gltf/attachments.h"
#include "scene/gltf/document.h"
#include "scene/gltf/fault.h"
#include "scene/gltf/load.h"
#include "scene/gltf/material.h"
#include "scene/gltf/nodes.h"

namespace crsh::scene {

namespace {

constexpr float farthest = 1e15f;  // metres; squares and products stay within float

bool is_done_here(std::string_view extension) {
  constexpr std::array<std::string_view, 6> done = {"KHR_lights_punctual",  "KHR_materials_emissive_strength",
                                                    "KHR_materials_ior",    "KHR_materials_transmission",
                                                    "KHR_materials_volume", "KHR_mesh_quantization"};
  return std::find(done.begin(), done.end(), extension) != done.end();
}

void check_extensions(const Fields& root, Notes& notes) {
  for (const std::string& name : root.texts("extensionsRequired"))
    if (!is_done_here(name))
      throw Fault("needs the extension " + printable(name, 60) + ", which crsh does not do",
                  "export the scene without it");
  for (const std::string& name : root.texts("extensionsUsed"))
    if (!is_done_here(name)) notes.add("extension " + printable(name, 60));
}

std::set<uint32_t> materials_used(const Scene& scene) {
  std::set<uint32_t> used;
  for (const Mesh& mesh : scene.meshes) used.insert(mesh.materials.begin(), mesh.materials.end());
  return used;
}

/// Transforms may multiply to more than a float holds.
void check_transforms(const Scene& scene) {
  const Pose pose = scene.pose(0, {});
  for (size_t i = 0; i < pose.instances.size(); ++i)
    for (int c = 0; c < 4; ++c)
      for (int r = 0; r < 4; ++r)
        if (!(std::abs(pose.instances[i][c][r]) <= farthest))
          throw Fault("node " + in_quotes(scene.nodes[scene.instances[i].node].name, 60) +
                      " is moved or scaled beyond what can be drawn");
}

Scene read(const std::filesystem::path& path, const std::string& which) {
  Document document(path);
  Scene scene;
  scene.path = path;
  Notes notes(scene.unsupported);
  check_extensions(document.root(), notes);
  const NodeMap nodes = read_nodes(document, which, scene);
  read_instances(document, nodes, scene, notes);
  read_materials(document, materials_used(scene), scene, notes);
  read_cameras(document, nodes, scene);
  read_lights(document, nodes, scene);
  read_animations(document, nodes, scene, notes);
  check_transforms(scene);
  return scene;
}

[[noreturn]] void refuse(const std::filesystem::path& path, const std::string& reason, const std::string& mend) {
  throw UserError(printable(path.string(), 4096) + ": " + printable(reason, 400) + "; " + printable(mend, 400));
}

}  // namespace

Scene load(const std::filesystem::path& path, const std::string& which) {
  try {
    return read(path, which);
  } catch (const Fault& fault) {
    refuse(path, fault.what(), fault.mend());
  } catch (const std::bad_alloc&) {
    refuse(path, "does not fit in memory", "split or simplify the scene");
  } catch (const std::length_error&) {
    refuse(path, "does not fit in memory", "split or simplify the scene");
  }
}

}  // namespace crsh::scene
