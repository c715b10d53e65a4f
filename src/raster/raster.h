#pragma once
// Section 3.1: what the eye sees, drawn in one pass.

#include <cstdint>
#include <glm/glm.hpp>
#include <memory>

#include "gpu/image.h"
#include "gpu/program.h"
#include "gpu/recorder.h"
#include "raster/camera.h"
#include "scene/device/upload.h"

namespace crsh::raster {

/// The attachments, four floats a pixel; kept between frames.
struct GBuffer {
  gpu::Image position;  ///< xyz: world position; w: roughness
  gpu::Image normal;    ///< xyz: shading normal, on the eye's side; w: transmission
  gpu::Image diffuse;   ///< rgb: base colour less metal; w: metallic
  gpu::Image specular;  ///< rgb: F0; w: how much of it is there (alphaMode BLEND)
  gpu::Image triangle;  ///< the drawn triangle's number from 1 on; 0: nothing
  gpu::Image depth;     ///< reversed: near is large
  std::unique_ptr<gpu::DrawProgram> program;
};

struct In {
  const scene::GpuScene& scene;
  const CameraView& view;
  ImageSize size;
  glm::vec2 jitter{0};  ///< of the sample from its pixel's centre, in pixels
};

/// Draws all triangles, 2^20 a submit. Throws UserError for an image that the device cannot draw.
void rasterise(gpu::Recorder& recorder, const In& in, GBuffer& out);

}  // namespace crsh::raster
