#pragma once
// Section 3.2.2: secondary rays, one creation shader a kind, before they are trimmed.

#include <array>
#include <cstdint>
#include <vector>

#include "crsh/kinds.h"
#include "gpu/buffer.h"
#include "gpu/recorder.h"
#include "scene/device/upload.h"
#include "shared/limits.h"
#include "surfaces/surfaces.h"

namespace crsh::rays {

/// Most segments of a batch: shading walks its shadow segments in one loop.
inline constexpr uint32_t most_segments = 64;

/// Rays that are wanted of every surface.
struct Wanted {
  uint32_t kind = 0;   ///< shared::kind_*
  uint32_t light = 0;  ///< of shadow rays
};

/// Rays that one batch wants: a slot a surface of [first_surface, first_surface + surfaces) for every segment.
struct BatchPlan {
  std::vector<Wanted> segments;  ///< shadow by rising light, then reflection, then refraction
  uint32_t first_surface = 0, surfaces = 0;
  [[nodiscard]] uint32_t slots() const { return uint32_t(segments.size()) * surfaces; }
};

struct PlanIn {
  uint32_t surfaces = 0, lights = 0;
  std::array<bool, kind_count> kinds = {true, true, true};  ///< those that are cast at this bounce
  bool mixed = true;                                        ///< kinds share batches
  uint32_t most_slots = shared::max_batch_rays;
};

/// The batches of one generation, none above most_segments or most_slots. Surfaces are split only where one segment
/// alone is too large, at the same places for all batches; so no two batches cast one surface's rays of one kind
/// (shadow: and light).
[[nodiscard]] std::vector<BatchPlan> plan_batches(const PlanIn& in);

/// Which kinds are cast from the surfaces of bounce `k`.
[[nodiscard]] std::array<bool, kind_count> kinds_at(const RenderOptions& options, uint32_t bounce);

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
};

/// Creates the batch's rays; the weights of reflection and refraction rays go to `generation`.
void create(gpu::Recorder& recorder, const CreateIn& in, Sparse& out, surfaces::Generation& generation);

}  // namespace crsh::rays
