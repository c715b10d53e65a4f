#include "shading/film.h"

#include <fmt/format.h>

#include "crsh/error.h"
#include "primitives/grow.h"

namespace crsh::shading {
namespace {

/// A layer that is the sum of something a surface each.
struct Summed {
  LayerId layer;
  const gpu::Buffer& values;
  bool first_sample_only = false;
};

std::array<Summed, 8> summed(const SampleIn& in) {
  return {{{LayerId::beauty, in.gathered.total},
           {LayerId::direct, in.generation.direct},
           {LayerId::emission, in.generation.emission},
           {LayerId::reflection, in.gathered.reflection},
           {LayerId::refraction, in.gathered.refraction},
           {LayerId::f0, in.surfaces.specular},
           {LayerId::position, in.surfaces.position, true},
           {LayerId::normal, in.surfaces.normal, true}}};
}

/// Layers whose pixels are a vec4 in Film::sums.
constexpr std::array summed_layers = {LayerId::beauty,     LayerId::direct, LayerId::emission, LayerId::reflection,
                                      LayerId::refraction, LayerId::albedo, LayerId::f0,       LayerId::shadow,
                                      LayerId::position,   LayerId::normal};

uint64_t pixels_of(const Film& film) { return uint64_t(film.size.width) * film.size.height; }

void require_room(const gpu::Device& device, const Film& film) {
  const uint64_t most = device.limits().max_binding / sizeof(glm::vec4);
  if (pixels_of(film) > most)
    throw UserError(fmt::format("--size {}x{}: {} holds at most {} pixels in one buffer", film.size.width,
                                film.size.height, device.info().name, most));
}

/// Ids and depth are written whole; sums begin at 0.
void reserve(gpu::Recorder& recorder, Film& film) {
  const uint64_t pixels = pixels_of(film);
  for (const LayerId layer : summed_layers)
    if (film.layers.has(layer))
      primitives::grow(recorder, film.sums[static_cast<size_t>(layer)], pixels * sizeof(glm::vec4), row_of(layer).name);
  for (uint32_t kind = 0; kind < shared::tests_count; ++kind)
    if (film.layers.has(layer_of_tests(kind)))
      primitives::grow(recorder, film.tests[kind], pixels * sizeof(uint64_t), row_of(layer_of_tests(kind)).name);
  if (film.layers.has(LayerId::depth)) primitives::grow(recorder, film.depth, pixels * sizeof(float), "Z");
  if (film.layers.has_any({LayerId::object, LayerId::material}))
    primitives::grow(recorder, film.ids, pixels * sizeof(glm::uvec2), "ids");
}

void clear(gpu::Recorder& recorder, const Film& film) {
  const uint64_t pixels = pixels_of(film);
  for (const LayerId layer : summed_layers)
    if (film.layers.has(layer)) recorder.fill(film.sum(layer), 0, pixels * 4);
  for (uint32_t kind = 0; kind < shared::tests_count; ++kind)
    if (film.layers.has(layer_of_tests(kind))) recorder.fill(film.tests[kind], 0, pixels * 2);
}

void add_geometry(gpu::Recorder& recorder, const SampleIn& in, const Film& film) {
  const surfaces::Surfaces& s = in.surfaces;
  if (film.layers.has(LayerId::depth)) {
    const struct {
      glm::vec3 eye;
      uint32_t count;
      glm::vec3 forward;
    } push{in.view.eye, s.count, in.view.forward};
    recorder.dispatch("shading/film_depth", s.count, push,
                      {{"diffuse_pixel", s.diffuse}, {"positions", s.position}, {"depths", film.depth}});
  }
  if (film.layers.has_any({LayerId::object, LayerId::material}))
    recorder.dispatch("shading/film_ids", s.count, s.count,
                      {in.scene.tables, {"diffuse_pixel", s.diffuse}, {"positions", s.position}, {"ids", film.ids}});
}

}  // namespace

void begin_frame(gpu::Recorder& recorder, Film& film, raster::ImageSize size, const LayerSet& layers) {
  film.size = size;
  film.samples = 0;
  film.layers = layers;
  film.layers.add(LayerId::beauty);
  require_room(recorder.device(), film);
  reserve(recorder, film);
  clear(recorder, film);
}

void begin_sample(Film& film) { ++film.samples; }

void add_sample(gpu::Recorder& recorder, const SampleIn& in, Film& film) {
  const surfaces::Surfaces& s = in.surfaces;
  const bool first = film.samples == 1;
  for (const Summed& layer : summed(in))
    if (film.layers.has(layer.layer) && (first || !layer.first_sample_only))
      recorder.dispatch("shading/film_sum", s.count, s.count,
                        {{"diffuse_pixel", s.diffuse}, {"values", layer.values}, {"sums", film.sum(layer.layer)}});
  if (film.layers.has(LayerId::albedo))
    recorder.dispatch("shading/film_albedo", s.count, s.count,
                      {{"diffuses", s.diffuse},
                       {"speculars", s.specular},
                       {"emissions", in.generation.emission},
                       {"albedo", film.sum(LayerId::albedo)}});
  if (first) add_geometry(recorder, in, film);
}

}  // namespace crsh::shading
