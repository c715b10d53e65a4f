#pragma once
// The table of tracers: the ways in which rays find what they hit. Another one is a file with its function and its
// buffers, a row in tracers.cpp, and a preset (src/crsh/options.cpp) that names the row.

#include <cstdint>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

#include "crsh/options.h"
#include "gpu/device.h"
#include "gpu/recorder.h"

namespace crsh::trace {

struct In;

/// What must be there before a tracer runs.
struct Needs {
  bool object_hierarchy = false;     ///< over the triangles (objects/hierarchy.h)
  bool device_hierarchy = false;     ///< the device's own, so that it has to have ray queries
  bool empty_hits = false;           ///< no ray of the batch has hit anything yet; else hits hold anything
  bool sorted_rays = false;          ///< rays are sorted, and bundled into nodes
  uint32_t max_levels = UINT32_MAX;  ///< of these nodes
};

/// Segments of a batch, by number.
using Segments = std::vector<size_t>;

struct Tracer {
  std::string_view name;       ///< AlgorithmOptions::tracer
  Needs needs;                 ///< of it and of `scattered`
  std::string_view scattered;  ///< the tracer for segments whose rays are too scattered for nodes; empty: this one

  /// Makes what it keeps between batches.
  std::shared_ptr<void> (*scratch)();
  /// Traces all rays of the segments: their hits go to In::workspace, their tests to the counters.
  void (*run)(gpu::Recorder& recorder, const In& in, const Segments& segments, void* scratch);
};

[[nodiscard]] std::span<const Tracer> tracers();
/// The row of this name; there has to be one.
[[nodiscard]] const Tracer& tracer_named(std::string_view name);
/// The one that an algorithm begins with.
[[nodiscard]] const Tracer& tracer_of(const AlgorithmOptions& options);

/// Throws UserError where the options, or the device, have not what their tracer needs.
void require_sound(const AlgorithmOptions& options);
void require_device(const gpu::Device& device, const AlgorithmOptions& options);

/// Runs a tracer with its scratch in the workspace of `in`.
void run(gpu::Recorder& recorder, const In& in, const Tracer& tracer, const Segments& segments);

}  // namespace crsh::trace
