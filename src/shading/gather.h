#pragma once
// Radiance back along the paths, from the last generation to the first.

#include <glm/glm.hpp>

#include "gpu/recorder.h"
#include "surfaces/surfaces.h"

namespace crsh::shading {

/// vec4 a surface each.
struct Gathered {
  gpu::Buffer total;       ///< rgb: what goes back along the ray that came; w: 1 where something was met, else 0
  gpu::Buffer reflection;  ///< rgb: the part of it that reflection rays brought; only where parts are wanted
  gpu::Buffer refraction;
};

/// Whether what reflection and refraction brought is kept apart besides.
enum class Parts { unwanted, wanted };

/// total = emission + direct + reflection weight × child's total + refraction weight × child's total, or `background`
/// where nothing was met. Every Children of the generation needs its `totals`; generations after the last have none.
void gather(gpu::Recorder& recorder, const surfaces::Generation& generation, glm::vec3 background, Gathered& out,
            Parts parts = Parts::unwanted);

}  // namespace crsh::shading
