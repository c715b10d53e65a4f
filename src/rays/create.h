#pragma once
// Section 3.2.2: secondary rays, one creation shader a kind, before they are trimmed.

#include <cstdint>
#include <vector>

#include "crsh/kinds.h"
#include "gpu/buffer.h"
#include "gpu/recorder.h"
#include "scene/device/upload.h"
#include "shared/limits.h"
#include "surfaces/surfaces.h"

namespace crsh::rays {

/// Most segments of a batch, because shading goes through its shadow segments in one loop.
inline constexpr uint32_t max_segments = 64;

/// Rays to be cast from every surface.
struct Wanted {
  uint32_t kind = 0;   ///< shared::kind_*
  uint32_t light = 0;  ///< where there is one a light
};

/// The rays of one batch: for every segment a slot for each surface of [first_surface, first_surface + surfaces).
struct BatchPlan {
  std::vector<Wanted> segments;  ///< by rising kind, then light
  uint32_t first_surface = 0, surfaces = 0;
  [[nodiscard]] uint32_t slots() const { return uint32_t(segments.size()) * surfaces; }
};

/// Segments of one kind that follow each other in a plan.
struct KindRun {
  uint32_t kind = 0;
  uint32_t first = 0, segments = 0;
};
[[nodiscard]] std::vector<KindRun> runs_of(const BatchPlan& plan);

struct PlanIn {
  uint32_t surfaces = 0, lights = 0;
  PerKind<bool> kinds{true};  ///< those that are cast at this bounce
  bool mixed = true;          ///< kinds share batches
  uint32_t max_slots = shared::max_batch_rays;
};

/// The batches of one generation, none above max_segments or max_slots. Surfaces are split only where one segment
/// alone is too large, at the same places for all batches; so no two batches cast one surface's rays of one kind and
/// light.
[[nodiscard]] std::vector<BatchPlan> plan_batches(const PlanIn& in);

/// Which kinds are cast from the surfaces of bounce `k`.
[[nodiscard]] PerKind<bool> kinds_at(const RenderOptions& options, uint32_t bounce);

/// Rays in their slots, as they are created: slot = segment * surfaces + (surface - first_surface).
struct Sparse {
  gpu::Buffer rays;   ///< shared::Ray a slot; without meaning where there is none
  gpu::Buffer flags;  ///< uint a slot: 1 where there is a ray, else 0; whole quads
  uint32_t slots = 0;
};

struct CreateIn {
  const surfaces::Surfaces& surfaces;
  const scene::GpuScene& scene;
  const BatchPlan& plan;
  bool override_mirror = false;
  uint32_t sample = 0;  ///< of the frame, from 0
  uint32_t seed = 0;    ///< of what is cast by chance
};

/// Creates the batch's rays; the weights of closest-hit rays go to `generation`.
void create(gpu::Recorder& recorder, const CreateIn& in, Sparse& out, surfaces::Generation& generation);

}  // namespace crsh::rays
