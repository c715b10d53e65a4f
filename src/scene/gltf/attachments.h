#pragma once
// What hangs on nodes: meshes, skins, cameras and lights.

#include <map>

#include "scene/gltf/document.h"
#include "scene/gltf/fault.h"
#include "scene/gltf/nodes.h"
#include "scene/scene.h"

namespace crsh::scene {

/// Which elements of one of the scene's lists each of the file's has become.
using FilePlaces = std::multimap<int64_t, uint32_t>;

/// Fills meshes, skins and instances. A mesh without triangles makes no instance.
void read_instances(Document& document, const NodeMap& nodes, Scene& scene, Notes& notes);

/// Fills cameras, in glTF's order.
FilePlaces read_cameras(Document& document, const NodeMap& nodes, Scene& scene);

/// Fills lights (KHR_lights_punctual).
FilePlaces read_lights(Document& document, const NodeMap& nodes, Scene& scene);

}  // namespace crsh::scene
