#pragma once
// What hangs on nodes: meshes, skins, cameras and lights.

#include "scene/gltf/document.h"
#include "scene/gltf/fault.h"
#include "scene/gltf/nodes.h"
#include "scene/scene.h"

namespace crsh::scene {

/// Fills meshes and instances. A mesh without triangles makes no instance. Skinned meshes follow their first joint.
void read_instances(Document& document, const NodeMap& nodes, Scene& scene, Notes& notes);

/// Fills cameras, in glTF's order.
void read_cameras(Document& document, const NodeMap& nodes, Scene& scene);

/// Fills lights (KHR_lights_punctual).
void read_lights(Document& document, const NodeMap& nodes, Scene& scene);

}  // namespace crsh::scene
