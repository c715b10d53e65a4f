#pragma once
// Rays by the device's own ray queries.

#include "trace/brute.h"
#include "trace/in.h"

namespace crsh::trace {

/// Counts no tests: what the device tests is its own affair.
void run_ray_query(gpu::Recorder& recorder, const In& in, const Segments& segments, NoScratch& scratch);

}  // namespace crsh::trace
