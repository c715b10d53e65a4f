#pragma once
// Which tracer each segment of a batch gets.

#include "trace/in.h"

namespace crsh::trace {

/// A tracer a segment: the algorithm's own, but single rays in place of nodes where sorting would cost more than it
/// saves, because the object hierarchy holds so little or a segment's rays are so scattered.
/// Decides by counts alone, never by time. May submit and wait.
[[nodiscard]] std::vector<const Tracer*> choose_tracers(gpu::Recorder& recorder, const In& in);

}  // namespace crsh::trace
