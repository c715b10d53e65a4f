#pragma once
// What of a scene's meshes is stored on the device, and in which order.

#include <cstdint>
#include <vector>

#include "scene/scene.h"

namespace crsh::scene {

/// A mesh's vertices and triangles: once for all instances that are drawn as it is, and once more for each that
/// deforms.
struct StoredMesh {
  uint32_t mesh = 0, first_vertex = 0, first_triangle = 0;
};

struct Storage {
  std::vector<StoredMesh> meshes;     ///< the instances' own last, in their order
  std::vector<uint32_t> of_instance;  ///< places in `meshes`
  uint32_t first_own = 0;             ///< of `meshes`
  uint64_t vertices = 0, triangles = 0;
};

[[nodiscard]] Storage storage_of(const Scene& scene);

}  // namespace crsh::scene
