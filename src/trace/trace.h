#pragma once
// Steps 4 to 6 of Figure 1 (sections 3.2.3 to 3.2.6) for a batch of rays, by whichever tracers its segments get.

#include "trace/in.h"

namespace crsh::trace {

/// How a batch was traced, for those who count, dump and show it. Valid until the next batch.
struct Traced {
  In in;
  std::vector<const Tracer*> tracers;  ///< a segment
  Bundle* bundle = nullptr;            ///< the batch's; none: rays were left as created, without nodes

  /// Whether any ray has a key; else sorted rays stand as they were created.
  [[nodiscard]] bool sorted() const { return bundle && !bundle->order.as_created; }
  /// Levels of nodes.
  [[nodiscard]] uint32_t depth() const { return bundle ? bundle->hierarchy.depth : 0; }
  /// The nodes; of depth 0 where there are none.
  [[nodiscard]] const hierarchy::Hierarchy& hierarchy() const;
};

/// Sorts and bundles the batch's rays where a tracer needs that, and traces them: their hits are then in the workspace,
/// their tests on the device's counters.
[[nodiscard]] Traced trace(gpu::Recorder& recorder, const In& in);

}  // namespace crsh::trace
