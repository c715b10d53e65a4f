#pragma once
// Gathering: carries radiance back along the paths, from the last generation to the first.

#include <glm/glm.hpp>

#include "gpu/recorder.h"
#include "surfaces/surfaces.h"

namespace crsh::shading {

/// vec4 a surface each.
struct Gathered {
  gpu::Buffer total;  ///< rgb: what goes back along the ray that came; w: 1 where something was met, else 0
  PerKind<gpu::Buffer>
      brought;  ///< rgb: the part of it that the kind's rays brought; of closest-hit kinds, where wanted
};

/// Whether what each kind of rays brought is kept apart besides.
enum class Parts { unwanted, wanted };

/// total = emission + direct + weight × child's total for each closest-hit kind, by rising number; or `background`
/// where nothing was met. Every Children of the generation needs its `totals`; generations after the last have none.
void gather(gpu::Recorder& recorder, const surfaces::Generation& generation, glm::vec3 background, Gathered& out,
            Parts parts = Parts::unwanted);

}  // namespace crsh::shading
