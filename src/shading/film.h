#pragma once
// The image that samples add up to.

#include <cstdint>

#include "frame/picture.h"
#include "gpu/recorder.h"
#include "raster/camera.h"
#include "scene/upload.h"
#include "shading/gather.h"
#include "shading/surfaces.h"

namespace crsh::shading {

/// A pixel each, row-major; the geometry is the first sample's, which lies at the pixel's centre.
struct Film {
  gpu::Buffer beauty;        ///< vec4: sum over samples of premultiplied RGBA
  gpu::Buffer albedo;        ///< vec4: sum of base colours; w: samples that met something
  gpu::Buffer normal_depth;  ///< vec4: normal, 0 where nothing; distance along the view axis, 1e10 where nothing
  gpu::Buffer points;        ///< vec4: world position; w: 1 where something was met
  gpu::Buffer ids;           ///< uvec2: object and material from 1 on; 0 where nothing
  raster::ImageSize size;
  uint32_t samples = 0;      ///< begun
};

/// Clears the film for a frame. Throws UserError for more pixels than the device can bind.
void begin_frame(gpu::Recorder& recorder, Film& film, raster::ImageSize size);

/// A sample begins; its surfaces may come in several portions.
void begin_sample(Film& film);

struct SampleIn {
  const Surfaces& surfaces;  ///< of k = 0
  const Generation& generation;
  const Gathered& gathered;
  const scene::GpuScene& scene;
  const raster::CameraView& view;
  bool opaque = true;        ///< the background covers; else alpha is coverage
};
void add_sample(gpu::Recorder& recorder, const SampleIn& in, Film& film);

/// Means over samples: the beauty "", Z, N and Albedo, with the camera's matrices. Submits and waits.
[[nodiscard]] Picture take_picture(gpu::Recorder& recorder, const Film& film, const raster::CameraView& view);

}  // namespace crsh::shading
