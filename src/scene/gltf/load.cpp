#include <cmath>
#include <new>
#include <set>
#include <stdexcept>

#include "crsh/error.h"
#include "scene/gltf/animations.h"
#include "scene/gltf/attachments.h"
#include "scene/gltf/document.h"
#include "scene/gltf/fault.h"
#include "scene/gltf/json.h"
#include "scene/gltf/load.h"
#include "scene/gltf/material.h"
#include "scene/gltf/nodes.h"
#include "scene/gltf/texcoords.h"

namespace crsh::scene {

namespace {

constexpr float farthest = 1e15f;  // metres; squares and products stay within float

void note_extensions(const Document& document, Notes& notes) {
  for (const std::string& name : document.model().extensionsUsed)
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

Scene read(const std::filesystem::path& path, const std::string& which, Reach reach) {
  Document document(path, reach);
  Scene scene;
  scene.path = path;
  Notes notes(scene.unsupported);
  note_extensions(document, notes);
  scene.texcoords = texcoords_used(document);
  const NodeMap nodes = read_nodes(document, which, scene);
  read_instances(document, nodes, scene, notes);
  read_materials(document, materials_used(scene), scene, notes);
  read_cameras(document, nodes, scene);
  read_lights(document, nodes, scene);
  read_animations(document, nodes, scene, notes);
  check_transforms(scene);
  return scene;
}

std::string line(const std::filesystem::path& path, const std::string& reason, const std::string& mend) {
  return printable(path.string(), 4096) + ": " + printable(reason, 400) + "; " + printable(mend, 400);
}

[[noreturn]] void refuse_as_too_large(const std::filesystem::path& path) {
  throw UserError(line(path, "does not fit in memory", "split or simplify the scene"));
}

}  // namespace

Scene load(const std::filesystem::path& path, const std::string& which, Reach reach) {
  try {
    return read(path, which, reach);
  } catch (const OutsideFault& fault) {
    throw OutsideError(line(path, fault.what(), fault.mend()));
  } catch (const Fault& fault) {
    throw UserError(line(path, fault.what(), fault.mend()));
  } catch (const std::bad_alloc&) {
    refuse_as_too_large(path);
  } catch (const std::length_error&) {
    refuse_as_too_large(path);
  }
}

}  // namespace crsh::scene
