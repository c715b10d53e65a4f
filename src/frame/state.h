#pragma once
// What a renderer keeps between frames.

#include <optional>
#include <vector>

#include "coherence/coherence.h"
#include "coherence/trim.h"
#include "crsh/built.h"
#include "crsh/ray_table.h"
#include "frame/counters.h"
#include "frame/renderer.h"
#include "hierarchy/account.h"
#include "hierarchy/hierarchy.h"
#include "intersection/intersection.h"
#include "intersection/nodes.h"
#include "intersection/ray_query.h"
#include "intersection/single.h"
#include "objects/device_hierarchy.h"
#include "objects/hierarchy.h"
#include "raster/raster.h"
#include "rays/create.h"
#include "scene/device/upload.h"
#include "shading/film.h"
#include "shading/gather.h"
#include "surfaces/surfaces.h"
#include "traversal/traversal.h"

namespace crsh {

/// Lists and scratch of one batch of rays after the other. All of it may be dropped between batches.
struct BatchBuffers {
  rays::Sparse sparse;
  rays::Batch rays;
  coherence::TrimScratch trim;
  coherence::OrderScratch sort;
  coherence::Order order;
  gpu::Buffer sorted_rays, hits;
  hierarchy::Hierarchy hierarchy;
  gpu::Buffer sampled;  ///< scratch of hierarchy::rays_a_node
  hierarchy::Account account;
  traversal::Scratch traversal;
  intersection::NodeScratch nodes;
  intersection::SingleScratch single;
};

/// The surfaces of generation 0, of two later ones in turn, and what is kept of each until the gathering.
struct PathBuffers {
  surfaces::Surfaces first, later[2];
  std::vector<surfaces::Generation> generations;
  std::vector<shading::Gathered> gathered;
  [[nodiscard]] surfaces::Surfaces& surfaces(uint32_t generation) {
    return generation == 0 ? first : later[generation % 2];
  }
};

struct Renderer::State {
  State(gpu::Device& device_, const scene::Scene& scene_, const RenderOptions& options_)
      : device(device_), scene(scene_), options(options_), recorder(device_) {}

  gpu::Device& device;
  const scene::Scene& scene;
  RenderOptions options;
  gpu::Recorder recorder;
  scene::Bounds first_bounds;  ///< of the scene at time 0
  std::optional<uint32_t> animation;
  raster::ImageSize size;
  scene::LightRig lights;
  scene::GpuScene gpu_scene;
  objects::Hierarchy objects;               ///< where the algorithm wants one
  objects::DeviceHierarchy device_objects;  ///< the device's own, where the algorithm wants that
  bool placing = false;                     ///< objects are being placed: not to be left half-way
  bool plain = false;                       ///< every triangle blocks, from either side
  std::optional<Counters> counters;
  raster::GBuffer gbuffer;
  PathBuffers paths;
  BatchBuffers batch;
  shading::Film film;
  uint32_t portion = 1u << 20;            ///< pixels that are traced together
  uint64_t most_pairs = 0;                ///< of a candidate list; 0: as memory allows
  Statistics statistics;                  ///< of all finished frames
  Statistics frame_statistics;            ///< of the frame under way
  uint32_t rays_seen = 0;                 ///< in batches of the frame under way that are done
  RayTable* dump = nullptr;               ///< gets the rays of the frame under way
  std::vector<RayNode>* nodes = nullptr;  ///< gets the nodes over the rays of the frame under way
  std::vector<std::string> notes;
};

/// Thrown where a generation outgrows what the device can bind: the frame begins again with smaller portions.
struct PortionTooLarge {};

/// One frame, as Figure 1 has it (frame.cpp). Counts go to state.frame_statistics.
[[nodiscard]] Picture render_frame(Renderer::State& state, double seconds, const Renderer::Progress& progress);

/// One more sample on the film of render_frame, in the same pose and view: the picture of all its samples.
[[nodiscard]] Picture refine_frame(Renderer::State& state, double seconds, const Renderer::Progress& progress);

/// Steps 4 to 6 on rays of a table in place of a frame's (replay.cpp). Counts go to state.frame_statistics.
void replay_rays(Renderer::State& state, const RayTable& rays, double seconds);

}  // namespace crsh
