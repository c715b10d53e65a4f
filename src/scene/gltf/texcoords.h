#pragma once
// Which sets of texture coordinates the materials of a file use.

#include <array>
#include <cstdint>

#include "scene/gltf/document.h"
#include "scene/scene.h"

namespace crsh::scene {

/// The N of the TEXCOORD_N that become Mesh::uv: the lowest that any material's textures use. Sets past them are not
/// drawn.
[[nodiscard]] std::array<uint32_t, uv_sets> texcoords_used(const Document& document);

}  // namespace crsh::scene
