#include "raster/raster.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "crsh/error.h"

namespace crsh::raster {
namespace {

/// Triangles a submit: with more a desktop's watchdog might take a long draw for a hang.
constexpr uint32_t submit_triangles = 1u << 20;

/// As raster/view.glsl declares it.
struct Push {
  glm::vec3 eye;
  float orthographic;
  glm::vec3 right;
  float scale_x;
  glm::vec3 up;
  float scale_y;
  glm::vec3 forward;
  float near_plane;
  glm::vec2 shift;
  float far_plane;
  float cone_spread, cone_width;
};

/// The image is moved against the sample's offset: what lies at a pixel's centre plus the jitter is drawn at the
/// centre.
Push push_of(const In& in) {
  const CameraView& view = in.view;
  const PixelCone cone = pixel_cone(view, in.size);
  const glm::vec2 shift = -2.0f * in.jitter / glm::vec2(float(in.size.width), float(in.size.height));
  return {view.eye,     view.orthographic ? 1.0f : 0.0f,
          view.right,   1 / view.half_width,
          view.up,      1 / view.half_height,
          view.forward, view.near_plane,
          shift,        view.far_plane,
          cone.spread,  cone.width};
}

void require_size(const gpu::Device& device, ImageSize size) {
  const uint32_t most = device.limits().max_image_size;
  if (size.width > most || size.height > most)
    throw UserError(
        fmt::format("{}x{} pixels: {} draws at most {} an axis", size.width, size.height, device.info().name, most),
        Mend::smaller_image);
}

void prepare(gpu::Recorder& recorder, const scene::GpuScene& scene, ImageSize size, GBuffer& out) {
  using gpu::Format;
  gpu::Device& device = recorder.device();
  if (!out.program) {
    constexpr std::array formats = {Format::rgba32f, Format::rgba32f, Format::rgba32f, Format::rgba32f, Format::r32u};
    out.program =
        std::make_unique<gpu::DrawProgram>(device, gpu::Kernel("raster/surface", scene.sheer_constants()), formats);
  }
  if (out.depth.width() == size.width && out.depth.height() == size.height) return;
  require_size(device, size);
  recorder.submit();
  const auto make = [&](Format format, const char* name) {
    return gpu::Image(device, size.width, size.height, format, name);
  };
  out.position = make(Format::rgba32f, "position");
  out.normal = make(Format::rgba32f, "normal");
  out.diffuse = make(Format::rgba32f, "diffuse");
  out.specular = make(Format::rgba32f, "specular");
  out.triangle = make(Format::r32u, "triangle");
  out.depth = make(Format::depth32f, "depth");
}

}  // namespace

void rasterise(gpu::Recorder& recorder, const In& in, GBuffer& out) {
  recorder.submit();  // Mesa 25's lavapipe crashes where a draw follows dispatches in one command buffer
  prepare(recorder, in.scene, in.size, out);
  const scene::GpuScene& s = in.scene;
  const std::array<const gpu::Image*, 5> colours = {&out.position, &out.normal, &out.diffuse, &out.specular,
                                                    &out.triangle};
  uint32_t first = 0;
  do {
    const uint32_t count = std::min(s.triangle_count - first, submit_triangles);
    recorder.draw(*out.program, {colours, &out.depth, first == 0}, 3 * first, 3 * count, push_of(in), {s.tables});
    first += count;
    if (first < s.triangle_count) recorder.submit();
  } while (first < s.triangle_count);
}

}  // namespace crsh::raster
