#pragma once
// The radii of meshes that culling uses.

#include "scene/scene.h"

namespace crsh::scene {

/// Fills `sphere`, `cover_similar` and `cover_affine` from the mesh's positions and triangles.
void fill_bounds(Mesh& mesh);

}  // namespace crsh::scene
