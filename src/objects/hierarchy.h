#pragma once
// The object hierarchy: a binary tree of boxes over all drawn triangles, built on the device, refitted while objects
// move, and built anew when that has made it loose. (The paper's future work: "a deeper BVH".)

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "gpu/buffer.h"
#include "gpu/recorder.h"
#include "scene/device/upload.h"

namespace crsh::objects {

/// A run of inner nodes, none of which is an ancestor of another: their boxes can be fitted at the same time.
struct Rank {
  uint32_t first = 0, count = 0;
};

/// shaders/shared/object.h describes the layout. Every buffer has memory and can be bound, even without a triangle.
struct Hierarchy {
  gpu::Buffer box_low, box_high;       ///< vec4 a child slot, two slots a node
  gpu::Buffer leaf_a, leaf_b, leaf_c;  ///< vec4 a triangle, in leaf order
  gpu::Buffer root;                    ///< two vec4: low corner and SAH cost times half area, high corner and half area
  uint32_t node_count = 0;             ///< inner nodes, 1 at least once built
  uint32_t triangle_count = 0;

  // For refits.
  gpu::Buffer order;         ///< uint a place in leaf order: the triangle there
  gpu::Buffer costs;         ///< float an inner node
  std::vector<Rank> ranks;   ///< the root's first; children are in later ranks than their parents
  scene::GeometryPose pose;  ///< when boxes were last fitted
  double built_cost = 0;     ///< the SAH cost when it was built

  // For statistics.
  double cost = 0;                  ///< SAH cost: expected tests of a ray that meets the root's box
  uint32_t builds = 0, refits = 0;  ///< so far
};

struct In {
  const scene::GpuScene& scene;     ///< as animate() left it
  const scene::GeometryPose& pose;  ///< in this pose
  uint64_t submit_work = 0;         ///< tests or elements a submit
};

/// A hierarchy is built anew when its cost after a refit is more than this many times its cost when built.
inline constexpr double loose = 1.3;

/// Makes `hierarchy` hold the scene's triangles where they are now: builds it at first, refits it when objects have
/// moved or deformed, builds it anew when refitting has made it loose, and else does nothing. What it does depends only
/// on poses, never on time. Submits, and waits. Throws gpu::OutOfMemory, and UserError where a list is larger than the
/// device can bind. (Stage: object hierarchy.)
void update(gpu::Recorder& recorder, const In& in, Hierarchy& hierarchy);

/// Fits all boxes to the triangles where they are now, and finds the SAH cost.
void fit(gpu::Recorder& recorder, const In& in, Hierarchy& hierarchy);

}  // namespace crsh::objects
