#include "shading/film.h"

#include <fmt/format.h>

#include <algorithm>
#include <initializer_list>
#include <utility>

#include "error.h"
#include "primitives/grow.h"

namespace crsh::shading {
namespace {

/// As shading/film.comp declares it.
struct Push {
  glm::vec3 eye;
  uint32_t count;
  glm::vec3 forward;
  uint32_t first_sample, opaque;
};

uint64_t pixels_of(const Film& film) { return uint64_t(film.size.width) * film.size.height; }

/// A layer of some of the channels of a buffer of vec4, scaled.
Layer layer_of(std::string name, std::vector<std::string> channels, const std::vector<glm::vec4>& pixels, int first,
               float scale) {
  Layer layer{std::move(name), std::move(channels), {}};
  const int count = int(layer.channels.size());
  layer.values.reserve(pixels.size() * size_t(count));
  for (const glm::vec4& pixel : pixels)
    for (int c = first; c < first + count; ++c) layer.values.push_back(pixel[c] * scale);
  return layer;
}

}  // namespace

void begin_frame(gpu::Recorder& recorder, Film& film, raster::ImageSize size) {
  film.size = size;
  film.samples = 0;
  const gpu::Device& device = recorder.device();
  const uint64_t pixels = pixels_of(film), most = device.limits().max_binding / sizeof(glm::vec4);
  if (pixels > most)
    throw UserError(fmt::format("--size {}x{}: {} holds at most {} pixels in one buffer", size.width, size.height,
                                device.info().name, most));
  const uint64_t bytes = pixels * sizeof(glm::vec4);
  primitives::grow(recorder, film.beauty, bytes, "beauty");
  primitives::grow(recorder, film.albedo, bytes, "albedo");
  primitives::grow(recorder, film.normal_depth, bytes, "normals and depth");
  primitives::grow(recorder, film.points, bytes, "points");
  primitives::grow(recorder, film.ids, pixels * sizeof(glm::uvec2), "ids");
  recorder.fill(film.beauty, 0, pixels * 4);
  recorder.fill(film.albedo, 0, pixels * 4);
}

void begin_sample(Film& film) { ++film.samples; }

void add_sample(gpu::Recorder& recorder, const SampleIn& in, Film& film) {
  const Push push{in.view.eye, in.surfaces.count, in.view.forward, film.samples == 1 ? 1u : 0u, in.opaque ? 1u : 0u};
  const Surfaces& s = in.surfaces;
  recorder.dispatch("shading/film", push.count, push,
                    {in.gathered.total, s.position, s.normal, s.diffuse, s.specular, in.generation.emission,
                     in.scene.corner_a, in.scene.corner_b, film.beauty, film.albedo, film.normal_depth, film.points,
                     film.ids});
}

Picture take_picture(gpu::Recorder& recorder, const Film& film, const raster::CameraView& view) {
  const uint64_t pixels = pixels_of(film);
  const float scale = 1.0f / float(std::max(film.samples, 1u));
  const auto beauty = recorder.read<glm::vec4>(film.beauty, pixels);
  const auto albedo = recorder.read<glm::vec4>(film.albedo, pixels);
  const auto geometry = recorder.read<glm::vec4>(film.normal_depth, pixels);
  Picture picture{film.size.width, film.size.height, {}, view.world_to_camera(), view.world_to_ndc()};
  picture.layers.push_back(layer_of("", {"R", "G", "B", "A"}, beauty, 0, scale));
  picture.layers.push_back(layer_of("Z", {"Z"}, geometry, 3, 1));
  picture.layers.push_back(layer_of("N", {"N.X", "N.Y", "N.Z"}, geometry, 0, 1));
  picture.layers.push_back(layer_of("Albedo", {"Albedo.R", "Albedo.G", "Albedo.B"}, albedo, 0, scale));
  return picture;
}

}  // namespace crsh::shading
