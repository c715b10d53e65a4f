#pragma once
// What the embedded shaders need a device to bind, and whether it can.

#include <cstdint>
#include <string>

#include "gpu/device.h"
#include "gpu/reflection.h"

namespace crsh::gpu {

/// What a pipeline with this reflection binds, in each of its stages.
[[nodiscard]] StageLimits needs_of(const Reflection& reflection);

/// The most that any embedded shader needs, by reflection.
[[nodiscard]] const StageLimits& max_needed();

/// "it binds 8 storage buffers a stage, 16 are needed" for the first limit that does not suffice, or empty.
[[nodiscard]] std::string too_few(const StageLimits& available, const StageLimits& needed);

/// One line of all limits: "16 of 32 storage buffers, ...".
[[nodiscard]] std::string needs_text(const StageLimits& available, const StageLimits& needed);

}  // namespace crsh::gpu
