#pragma once
// Which triangles alpha decides of (alphaMode MASK and BLEND), and how (shared::Sheer).

#include <cstdint>
#include <vector>

#include "scene/device/device_materials.h"
#include "scene/device/storage.h"
#include "scene/scene.h"
#include "shared/scene.h"

namespace crsh::scene {

struct Sheers {
  std::vector<shared::Sheer> records;
  std::vector<uint32_t> of_stored;  ///< a stored triangle's record; shared::none where it is wholly there
  uint32_t pages = 0;               ///< of texels, that records use: the first so many; 0 where there are no records
};

/// A function of the scene and its materials alone: where these move, it is made anew. A triangle has a record only if
/// its alpha can fall short: of the cutoff (MASK), or of 1 (BLEND), by factor, vertex colours or a texel.
[[nodiscard]] Sheers sheers_of(const Scene& scene, const Storage& storage, const DeviceMaterials& materials);

}  // namespace crsh::scene
