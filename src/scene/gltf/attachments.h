#pragma once
// What hangs on nodes: meshes, skins, cameras and lights.

#include <map>
#include <optional>

#include "scene/gltf/document.h"
#include "scene/gltf/fault.h"
#include "scene/gltf/nodes.h"
#include "scene/scene.h"

namespace crsh::scene {

/// Which elements of one of the scene's lists each of the file's has become.
using FilePlaces = std::multimap<int64_t, uint32_t>;

/// Fills meshes, skins and instances. A mesh without triangles makes no instance. `variant`: of their materials.
void read_instances(Document& document, const NodeMap& nodes, Scene& scene, Notes& notes,
                    std::optional<uint32_t> variant);

/// Fills cameras, in glTF's order. Broken ones are left out, with a note.
FilePlaces read_cameras(Document& document, const NodeMap& nodes, Scene& scene, Notes& notes);

/// Fills lights (KHR_lights_punctual). Broken ones are left out, with a note.
FilePlaces read_lights(Document& document, const NodeMap& nodes, Scene& scene, Notes& notes);

}  // namespace crsh::scene
