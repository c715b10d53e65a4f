#pragma once
// The film: the image to which samples are added.

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <optional>

#include "crsh/layers.h"
#include "crsh/picture.h"
#include "gpu/recorder.h"
#include "raster/camera.h"
#include "scene/device/upload.h"
#include "shading/gather.h"
#include "surfaces/surfaces.h"

namespace crsh::shading {

/// A pixel each, row-major. A layer has the buffer that its LayerFill asks for; layers that are not wanted, and those
/// that are worked out of others, have none.
///   mean, base_colour  vec4: the sum over samples; the beauty's w: samples that met something. It is always there
///   first              vec4: the first sample's
///   visibility         vec4: x visibility, y rays, summed over samples
///   depth              float: metres along the view axis, 1e10 where nothing
///   object, material   uint: the number, from 1 on; 0 where nothing
///   tests              uvec2: 64-bit fixed point (shared/account.h), summed over samples
struct Film {
  std::array<gpu::Buffer, layer_count> buffers;  ///< by LayerId
  raster::ImageSize size;
  LayerSet layers;
  uint32_t samples = 0;  ///< begun

  [[nodiscard]] const gpu::Buffer& of(LayerId id) const { return buffers[static_cast<size_t>(id)]; }
};

/// The layer that shows this type of tests (shared::tests_*).
[[nodiscard]] LayerId layer_of_tests(uint32_t which);

/// Clears the film for a frame of these layers and the beauty. Throws UserError for more pixels than the device can
/// bind.
void begin_frame(gpu::Recorder& recorder, Film& film, raster::ImageSize size, const LayerSet& layers = default_layers);

/// Begins a sample, whose surfaces may come in several portions.
void begin_sample(Film& film);

struct SampleIn {
  const surfaces::Surfaces& surfaces;  ///< of k = 0
  const surfaces::Generation& generation;
  const Gathered& gathered;
  const scene::GpuScene& scene;
  const raster::CameraView& view;
};
/// Adds surfaces, and the light gathered at them. Shadow and tests are added where rays are traced.
void add_sample(gpu::Recorder& recorder, const SampleIn& in, Film& film);

/// The beauty "" and the film's layers by the names of layer_table: light and properties as means over samples, tests
/// as sums, with the camera's matrices. Places are in the coordinates where the drawn world begins at `origin`. Without
/// a `background` A is coverage. Submits and waits.
[[nodiscard]] Picture take_picture(gpu::Recorder& recorder, const Film& film, const raster::CameraView& view,
                                   const glm::dvec3& origin, const std::optional<glm::vec3>& background);

}  // namespace crsh::shading
