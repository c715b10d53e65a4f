#pragma once
// A scene on the device: what stays, and what every frame moves (section 3.2.1).

#include <array>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "gpu/buffer.h"
#include "gpu/buffer_set.h"
#include "gpu/recorder.h"
#include "scene/device/posed.h"
#include "scene/device/texel_pages.h"
#include "scene/device/world_lights.h"
#include "scene/scene.h"
#include "shared/scene.h"

namespace crsh::scene {

/// The scene's tables. Drawn triangles are numbered instance by instance. Every buffer can be bound, also where it
/// stands for an empty list.
struct GpuScene {
  // From upload().
  gpu::Buffer positions;      ///< vec3 a stored vertex, object space, where it does not deform (device/storage.h)
  gpu::Buffer vertices;       ///< shared::Vertex a stored vertex, likewise
  gpu::Buffer triangles;      ///< shared::StoredTriangle
  gpu::Buffer sources;        ///< shared::Source a drawn triangle
  gpu::Buffer materials;      ///< shared::Material
  gpu::Buffer textures;       ///< shared::Texture
  gpu::Buffer texture_uses;   ///< shared::TextureUse
  gpu::Buffer lobes;          ///< shared::Lobes
  gpu::Buffer sheers;         ///< shared::Sheer
  gpu::Buffer sheer_numbers;  ///< uint a drawn triangle: of its shared::Sheer; of any where it has none
  uint32_t sheer_pages = 0;   ///< of texels, that triangles with alpha use; 0: there are none
  std::array<gpu::Buffer, texel_page_count> texels;  ///< RGBA8 a word
  gpu::Buffer blocks;           ///< uvec4: instance, first drawn triangle, count (<= shared::block_triangles), 0
  uint32_t triangle_count = 0;  ///< drawn
  uint32_t instance_count = 0, block_count = 0;
  bool has_lobes = false;                         ///< whether any material has
  std::vector<std::string> notes;                 ///< for stderr
  PosedTables posed;                              ///< what deforms
  std::vector<shared::Material> given_materials;  ///< as the file has them; animations change their factors
  bool materials_changed = false;

  // From animate().
  gpu::Buffer instances;                     ///< shared::Instance
  gpu::Buffer corner_a, corner_b, corner_c;  ///< vec4 a drawn triangle, world space (shared/scene.h)
  gpu::Buffer triangle_spheres;              ///< vec4 a drawn triangle: centre and padded radius of its smallest sphere
  gpu::Buffer object_spheres;  ///< vec4 an instance: centre and radius, outside of all its triangles' spheres
  gpu::Buffer lights;          ///< shared::Light
  uint32_t light_count = 0;
  Bounds bounds;  ///< of all object spheres in this pose, of what deforms the bounds of its joints

  gpu::BufferSet tables;        ///< what shading reads of all these, bound together: shaders/scene/tables.glsl
  gpu::BufferSet sheer_tables;  ///< what hits read: shaders/intersection/sheer_tables.glsl

  /// Specialisation constants of kernels that ask for alpha (lib/sheer.glsl).
  [[nodiscard]] std::vector<std::pair<uint32_t, uint32_t>> sheer_constants() const;
  /// A kernel that keeps or reads the lobes of surfaces, compiled for this scene (shaders/lib/surface_lobes.glsl).
  [[nodiscard]] gpu::Kernel with_lobes(std::string path) const {
    gpu::Kernel kernel{std::move(path), sheer_constants()};
    kernel.constants.emplace_back(shared::constant_has_lobes, has_lobes);
    return kernel;
  }
};

/// Throws UserError where a list outgrows what the device can bind, and gpu::OutOfMemory.
[[nodiscard]] GpuScene upload(gpu::Device& device, const Scene& scene);

/// Section 3.2.1: deforms what deforms, and moves triangles, spheres and lights to where they are in this pose. Submits
/// what is recorded.
void animate(gpu::Recorder& recorder, GpuScene& target, const Scene& scene, const Pose& pose, const LightRig& lights);

}  // namespace crsh::scene
