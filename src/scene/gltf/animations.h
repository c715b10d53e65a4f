#pragma once
// Reads the animations of nodes.

#include "scene/gltf/document.h"
#include "scene/gltf/fault.h"
#include "scene/gltf/nodes.h"
#include "scene/scene.h"

namespace crsh::scene {

/// Fills animations, in glTF's order. Channels of nodes that the scene does not reach are left out.
void read_animations(Document& document, const NodeMap& nodes, Scene& scene, Notes& notes);

}  // namespace crsh::scene
