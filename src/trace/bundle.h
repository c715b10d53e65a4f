#pragma once
// Rays sorted (section 3.2.3) and bundled into nodes (section 3.2.4).

#include "coherence/coherence.h"
#include "hierarchy/hierarchy.h"

namespace crsh::trace {

struct In;

/// One batch after the other.
struct Bundle {
  coherence::OrderScratch sort;
  coherence::Order order;
  gpu::Buffer sorted_rays;  ///< shared::Ray a sorted position
  hierarchy::Hierarchy hierarchy;
};

/// Sorts and bundles the rays of the batch. `without_nodes`, by segment: those whose rays are not bundled.
void bundle(gpu::Recorder& recorder, const In& in, std::vector<bool> without_nodes, Bundle& out);

}  // namespace crsh::trace
