#pragma once
// Reads animations.

#include "scene/gltf/attachments.h"
#include "scene/gltf/document.h"
#include "scene/gltf/fault.h"
#include "scene/gltf/nodes.h"
#include "scene/scene.h"

namespace crsh::scene {

/// Where the file's nodes, cameras and lights are in the scene. Materials have the same places.
struct Places {
  const NodeMap& nodes;
  FilePlaces cameras, lights;
};

/// Fills animations, in glTF's order. Channels of what the scene does not reach are left out. After all else is read.
void read_animations(Document& document, const Places& places, Scene& scene, Notes& notes);

}  // namespace crsh::scene
