#pragma once
// KHR_draco_mesh_compression: primitives whose vertices and indices are compressed.

#include <string>

#include "scene/gltf/document.h"

namespace crsh::scene {

/// Decompresses what the primitive has compressed, so that its accessors give it from now on. Does nothing where it has
/// nothing so, or where that is done already. A Fault where the data is broken, or claims to be larger than so few
/// bytes can hold: sizes are checked before memory is taken for them.
void decompress_draco(Document& document, const tinygltf::Primitive& primitive, const std::string& where);

}  // namespace crsh::scene
