#pragma once
// Every ray against every triangle.

#include "trace/in.h"

namespace crsh::trace {

/// For tracers that keep nothing between batches.
struct NoScratch {};

void run_brute(gpu::Recorder& recorder, const In& in, const Segments& segments, NoScratch& scratch);

}  // namespace crsh::trace
