#pragma once
// glTF materials, their textures and images.

#include <set>

#include "scene/gltf/document.h"
#include "scene/gltf/fault.h"
#include "scene/scene.h"

namespace crsh::scene {

/// Fills materials (glTF's order, then the default one), textures and images. What `used` does not name is left at its
/// defaults: nothing wears it, so its textures are not read.
void read_materials(Document& document, const std::set<uint32_t>& used, Scene& scene, Notes& notes);

}  // namespace crsh::scene
