#pragma once
// glTF materials, their textures and images.

#include <set>

#include "scene/gltf/document.h"
#include "scene/gltf/fault.h"
#include "scene/scene.h"

namespace crsh::scene {

/// Fills materials (in glTF's order, then the default one), textures and images. Materials that are not in `used` keep
/// their default values, and their textures are not read, because nothing has them.
void read_materials(Document& document, const std::set<uint32_t>& used, Scene& scene, Notes& notes);

}  // namespace crsh::scene
