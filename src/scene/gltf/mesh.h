#pragma once
// glTF meshes, their triangle primitives merged.

#include <cstdint>
#include <optional>

#include "scene/gltf/document.h"
#include "scene/gltf/fault.h"
#include "scene/scene.h"

namespace crsh::scene {

struct MeshOptions {
  std::array<uint32_t, uv_sets> texcoords = {0, 1, 2};  ///< which TEXCOORD_N become Mesh::uv
  std::optional<uint32_t> variant;                      ///< of the materials
};

/// Reads glTF mesh `index`. Triangles carry glTF's material indices (`default_material` where they have none);
/// only vertices that a triangle uses are kept. A mesh of points or lines alone has no triangles.
[[nodiscard]] Mesh read_mesh(Document& document, int64_t index, uint32_t default_material, Notes& notes,
                             const MeshOptions& options = {});

}  // namespace crsh::scene
