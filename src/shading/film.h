#pragma once
// The image that samples add up to.

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
#include "shared/account.h"
#include "surfaces/surfaces.h"

namespace crsh::shading {

/// A pixel each, row-major; buffers of layers that are not wanted stay empty. Geometry and ids are the first sample's,
/// which lies at the pixel's centre.
struct Film {
  std::array<gpu::Buffer, layer_count>
      sums;           ///< by LayerId: vec4, the sum over samples (geometry: the first's). Shadow:
                      ///< x visibility, y shadow rays. Always there: the beauty, w samples that met
  gpu::Buffer depth;  ///< float: distance along the view axis, 1e10 where nothing
  gpu::Buffer ids;    ///< uvec2: object and material from 1 on; 0 where nothing
  std::array<gpu::Buffer, shared::tests_count> tests;  ///< by shared::tests_*: uvec2, 64-bit fixed point
  raster::ImageSize size;
  LayerSet layers;
  uint32_t samples = 0;  ///< begun

  [[nodiscard]] const gpu::Buffer& sum(LayerId id) const { return sums[static_cast<size_t>(id)]; }
};

/// The layer that shows this kind of tests.
[[nodiscard]] constexpr LayerId layer_of_tests(uint32_t kind) {
  constexpr std::array layers = {LayerId::triangle_tests, LayerId::node_tests, LayerId::object_tests};
  return layers[kind];
}

/// Clears the film for a frame of these layers and the beauty. Throws UserError for more pixels than the device can
/// bind.
void begin_frame(gpu::Recorder& recorder, Film& film, raster::ImageSize size, const LayerSet& layers = default_layers);

/// A sample begins; its surfaces may come in several portions.
void begin_sample(Film& film);

struct SampleIn {
  const surfaces::Surfaces& surfaces;  ///< of k = 0
  const surfaces::Generation& generation;
  const Gathered& gathered;
  const scene::GpuScene& scene;
  const raster::CameraView& view;
};
/// Adds the surfaces and what was gathered at them. Shadow and tests are added by those who trace.
void add_sample(gpu::Recorder& recorder, const SampleIn& in, Film& film);

/// The beauty "" and the film's layers by the names of layer_table: light and properties as means over samples, tests
/// as sums, with the camera's matrices. Without a `background` A is coverage. Submits and waits.
[[nodiscard]] Picture take_picture(gpu::Recorder& recorder, const Film& film, const raster::CameraView& view,
                                   const std::optional<glm::vec3>& background);

}  // namespace crsh::shading
