#pragma once
// What is counted of a batch once it is traced.

#include <array>

#include "crsh/statistics.h"
#include "shared/account.h"
#include "trace/trace.h"

namespace crsh::trace {

/// By shared::tests_*: uvec2 a pixel of the image, 64-bit fixed point; null where In::wanted says no.
using TestsByPixel = std::array<const gpu::Buffer*, shared::tests_count>;

/// Adds the batch's hits and digests to its counters on the device, shares its tests among `tests`, and adds what the
/// host knows to `statistics`: rays, chunks, nodes of each level and their means. Submits and waits where there are
/// nodes.
void tally(gpu::Recorder& recorder, const Traced& traced, const TestsByPixel& tests, Statistics& statistics);

}  // namespace crsh::trace
