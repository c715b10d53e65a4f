#pragma once
// Instances that deform, on the device: their meshes at rest, and what moves them each frame.

#include <cstdint>
#include <vector>

#include "gpu/buffer.h"
#include "gpu/recorder.h"
#include "scene/device/storage.h"
#include "scene/scene.h"

namespace crsh::scene {

struct GpuScene;

/// Empty, and nothing is dispatched, where nothing deforms.
struct PosedTables {
  gpu::Buffer vertices;       ///< shared::PosedVertex a stored vertex of an instance that deforms
  gpu::Buffer instances;      ///< shared::PosedInstance
  gpu::Buffer rest;           ///< shared::RestVertex a vertex of their meshes, and one more
  gpu::Buffer influences;     ///< shared::Influence
  gpu::Buffer displacements;  ///< shared::Displacement
  gpu::Buffer blocks;         ///< uvec4: posed instance, first drawn triangle, count (<= shared::block_triangles), 0
  uint32_t vertex_count = 0, first_vertex = 0, block_count = 0;
  std::vector<uint32_t> of_scene;  ///< for each posed instance its place in Scene::instances

  // Of a frame.
  gpu::Buffer joints;   ///< vec4, three rows a joint, skin by skin
  gpu::Buffer weights;  ///< float a morph target, instance by instance
  gpu::Buffer boxes;    ///< six words an instance (shaders/scene/posed_box.glsl)
};

/// How many elements the largest of the tables has of each size, for a check that they can be bound.
struct PosedSizes {
  uint64_t rest = 0, influences = 0, displacements = 0, joints = 0;
};
[[nodiscard]] PosedSizes posed_sizes(const Scene& scene);

[[nodiscard]] PosedTables upload_posed(gpu::Device& device, const Scene& scene, const Storage& storage);

/// Writes this pose's joints and weights. Nothing recorded may still read the last one's.
void write_pose(gpu::Device& device, const Scene& scene, const GeometryPose& pose, PosedTables& tables);

/// Deforms the stored vertices of instances that deform.
void deform(gpu::Recorder& recorder, const GpuScene& scene);

/// Their object spheres (section 3.2.1), from the spheres of their triangles where these are now.
void bound_posed(gpu::Recorder& recorder, const GpuScene& scene);

}  // namespace crsh::scene
