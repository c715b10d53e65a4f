#pragma once
// What a batch of rays is traced with. Whoever traces makes one In a batch; the stages get theirs from it, here.

#include <map>
#include <memory>

#include "crsh/options.h"
#include "hierarchy/account.h"
#include "intersection/intersection.h"
#include "rays/batch.h"
#include "scene/device/upload.h"
#include "trace/bundle.h"
#include "trace/counters.h"
#include "trace/structures.h"
#include "traversal/traversal.h"

namespace crsh::trace {

/// Where a batch's rays come from: the pixel and path of each slot's surface, as in surfaces::Surfaces.
struct RayNames {
  const gpu::Buffer& pixels;   ///< vec4 a surface, w: bits of the pixel
  const gpu::Buffer& paths;    ///< vec4 a surface, w: bits of the path
  uint32_t first_surface = 0;  ///< of the batch: slot 0 of each segment
};

/// Buffers of one batch after the other. All of it may be dropped between batches.
struct Workspace {
  gpu::Buffer hits;            ///< shared::Hit a ray, in creation order
  Bundle bundle;               ///< of the last batch that was sorted
  hierarchy::Account account;  ///< tests by ray and node
  gpu::Buffer sampled;         ///< scratch of hierarchy::rays_a_node
  std::map<const Tracer*, std::shared_ptr<void>> scratch;
};

struct In {
  const scene::GpuScene& scene;
  const Structures& structures;  ///< as place() left them
  const rays::Batch& batch;
  RayNames names;
  const RenderOptions& options;
  const Counters& counters;
  uint32_t bounce = 0;                 ///< surfaces that the rays have passed: a row of counters each kind
  uint64_t max_pairs = 0;              ///< of a candidate list; 0: as memory allows
  hierarchy::WantedTests wanted = {};  ///< tests to be shared among pixels
  Workspace& workspace;
};

/// For rays of this kind.
[[nodiscard]] intersection::In intersection_in(const In& in, uint32_t kind);
/// For nodes over rays of this kind.
[[nodiscard]] traversal::In traversal_in(const In& in, uint32_t kind);

}  // namespace crsh::trace
