#pragma once
// What a renderer keeps between frames.

#include <optional>
#include <stdexcept>
#include <vector>

#include "coherence/trim.h"
#include "crsh/built.h"
#include "crsh/ray_table.h"
#include "crsh/renderer.h"
#include "raster/raster.h"
#include "rays/create.h"
#include "scene/device/upload.h"
#include "shading/film.h"
#include "shading/gather.h"
#include "surfaces/surfaces.h"
#include "trace/in.h"

namespace crsh {

/// One batch of rays after the other, from creation to hits. All of it may be dropped between batches.
struct BatchBuffers {
  rays::Sparse sparse;
  rays::Batch rays;
  coherence::TrimScratch trim;
  trace::Workspace tracing;
};

/// The surfaces of generation 0 and, in turn, of two later generations; and what is kept of every generation until it
/// is gathered.
struct PathBuffers {
  surfaces::Surfaces first, later[2];
  std::vector<surfaces::Generation> generations;
  std::vector<shading::Gathered> gathered;
  [[nodiscard]] surfaces::Surfaces& surfaces(uint32_t generation) {
    return generation == 0 ? first : later[generation % 2];
  }
};

/// Who gets what of the frame under way; null: nobody.
struct Dump {
  RayTable* rays = nullptr;
  std::vector<RayNode>* nodes = nullptr;
  uint32_t rays_seen = 0;  ///< in batches that are done
};

struct Renderer::State {
  State(DevicePtr device_, ScenePtr scene_, const RenderOptions& options_)
      : kept_device(std::move(device_)),
        kept_scene(std::move(scene_)),
        device(*kept_device),
        scene(*kept_scene),
        options(options_),
        recorder(device) {}

  DevicePtr kept_device;
  ScenePtr kept_scene;
  gpu::Device& device;
  const scene::Scene& scene;
  RenderOptions options;
  gpu::Recorder recorder;
  scene::Bounds first_bounds;        ///< of the scene at time 0
  std::vector<uint32_t> animations;  ///< that play
  raster::ImageSize size;
  std::optional<ViewOption> chosen_view;  ///< where no camera was given
  float cone_spread = 0;                  ///< raster::PixelCone's, of the frame under way
  scene::LightRig lights;
  scene::GpuScene gpu_scene;
  trace::Structures structures;
  bool placing = false;  ///< objects are being moved, which must not be interrupted
  std::optional<trace::Counters> counters;
  raster::GBuffer gbuffer;
  PathBuffers paths;
  BatchBuffers batch;
  shading::Film film;
  uint32_t portion = 1u << 20;  ///< pixels that are traced together
  uint64_t max_pairs = 0;       ///< of a candidate list; 0: as memory allows
  Statistics statistics;        ///< of all finished frames
  Statistics frame_statistics;  ///< of the current frame
  Dump dump;
  std::vector<std::string> notes;  ///< Renderer::notes()
};

/// Thrown where a generation has more surfaces than the device can bind. The frame then begins again with smaller
/// portions.
struct PortionTooLarge : std::runtime_error {
  PortionTooLarge() : std::runtime_error("a portion of the image outgrew what the device can bind") {}
};

/// One frame, as Figure 1 has it (frame.cpp). Counts go to state.frame_statistics.
[[nodiscard]] Picture render_frame(Renderer::State& state, double seconds, const Renderer::Progress& progress);

/// One more sample on the film of render_frame, in the same pose and view: the picture of all its samples.
[[nodiscard]] Picture refine_frame(Renderer::State& state, double seconds, const Renderer::Progress& progress);

/// Steps 4 to 6 on rays of a table in place of a frame's (replay.cpp). Counts go to state.frame_statistics.
void replay_rays(Renderer::State& state, const RayTable& rays, double seconds);

}  // namespace crsh
