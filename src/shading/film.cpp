#include "shading/film.h"

#include <fmt/format.h>

#include "crsh/assertion.h"
#include "crsh/error.h"
#include "primitives/grow.h"

namespace crsh::shading {
namespace {

const gpu::Buffer& buffer_of(const LayerSource& source, const SampleIn& in) {
  switch (source.value) {
    case SurfaceValue::position: return in.surfaces.position;
    case SurfaceValue::normal: return in.surfaces.normal;
    case SurfaceValue::geometric: return in.surfaces.geometric;
    case SurfaceValue::incoming: return in.surfaces.incoming;
    case SurfaceValue::diffuse: return in.surfaces.diffuse;
    case SurfaceValue::specular: return in.surfaces.specular;
    case SurfaceValue::emission: return in.generation.emission;
    case SurfaceValue::direct: return in.generation.direct;
    case SurfaceValue::total: return in.gathered.total;
    case SurfaceValue::brought: return in.gathered.brought[source.kind];
  }
  CRSH_ASSERT(false, "no such value of a surface");
}

/// The layer's part of a sample, from the surfaces to `pixels`.
using Add = void (*)(gpu::Recorder& recorder, const SampleIn& in, const LayerSource& source, const gpu::Buffer& pixels);

void add_value(gpu::Recorder& recorder, const SampleIn& in, const LayerSource& source, const gpu::Buffer& pixels) {
  recorder.dispatch("shading/film_sum", in.surfaces.count, in.surfaces.count,
                    {{"diffuse_pixel", in.surfaces.diffuse}, {"values", buffer_of(source, in)}, {"sums", pixels}});
}

void add_base_colour(gpu::Recorder& recorder, const SampleIn& in, const LayerSource&, const gpu::Buffer& pixels) {
  recorder.dispatch(in.scene.with_lobes("shading/film_albedo"), in.surfaces.count, in.surfaces.count,
                    {{"diffuses", in.surfaces.diffuse},
                     {"speculars", in.surfaces.specular},
                     {"emissions", in.generation.emission},
                     {"albedo", pixels},
                     {"surface_lobes", in.surfaces.lobes}});
}

void write_depth(gpu::Recorder& recorder, const SampleIn& in, const LayerSource&, const gpu::Buffer& pixels) {
  const struct {
    glm::vec3 eye;
    uint32_t count;
    glm::vec3 forward;
  } push{in.view.eye, in.surfaces.count, in.view.forward};
  recorder.dispatch("shading/film_depth", in.surfaces.count, push,
                    {{"diffuse_pixel", in.surfaces.diffuse}, {"positions", in.surfaces.position}, {"depths", pixels}});
}

void write_numbers(gpu::Recorder& recorder, const SampleIn& in, const LayerSource& source, const gpu::Buffer& pixels) {
  const struct {
    uint32_t count;
    uint32_t material;
  } push{in.surfaces.count, source.fill == LayerFill::material};
  recorder.dispatch(
      "shading/film_ids", in.surfaces.count, push,
      {in.scene.tables, {"diffuse_pixel", in.surfaces.diffuse}, {"positions", in.surfaces.position}, {"ids", pixels}});
}

/// How a film holds the layers of one LayerFill.
struct Held {
  uint32_t pixel_bytes = 0;        ///< 0: not at all, as it is worked out of others
  Add add = nullptr;               ///< null: by those who trace
  bool only_first_sample = false;  ///< else samples add up
};

Held held(LayerFill fill) {
  switch (fill) {
    case LayerFill::mean: return {sizeof(glm::vec4), add_value};
    case LayerFill::first: return {sizeof(glm::vec4), add_value, true};
    case LayerFill::base_colour: return {sizeof(glm::vec4), add_base_colour};
    case LayerFill::visibility: return {sizeof(glm::vec4)};
    case LayerFill::background: return {};
    case LayerFill::depth: return {sizeof(float), write_depth, true};
    case LayerFill::object:
    case LayerFill::material: return {sizeof(uint32_t), write_numbers, true};
    case LayerFill::tests: return {sizeof(uint64_t)};
  }
  CRSH_ASSERT(false, "no such way to fill a layer");
}

uint64_t pixels_of(const Film& film) { return uint64_t(film.size.width) * film.size.height; }

void require_room(const gpu::Device& device, const Film& film) {
  const uint64_t most = device.limits().max_binding / sizeof(glm::vec4);
  if (pixels_of(film) > most)
    throw UserError(fmt::format("{}x{} pixels: {} holds at most {} in one buffer", film.size.width, film.size.height,
                                device.info().name, most),
                    Mend::smaller_image);
}

/// Room for the wanted layers, all 0.
void reserve(gpu::Recorder& recorder, Film& film) {
  for (const LayerId id : film.layers.members()) {
    const uint64_t bytes = pixels_of(film) * held(row_of(id).source.fill).pixel_bytes;
    if (bytes == 0) continue;
    gpu::Buffer& pixels = film.buffers[static_cast<size_t>(id)];
    primitives::grow(recorder, pixels, bytes, row_of(id).name);
    recorder.fill(pixels, 0, bytes / sizeof(uint32_t));
  }
}

}  // namespace

LayerId layer_of_tests(uint32_t which) {
  for (const LayerId id : LayerSet::filled_by(LayerFill::tests).members())
    if (row_of(id).source.which == which) return id;
  CRSH_ASSERT(false, "tests without a layer");
}

void begin_frame(gpu::Recorder& recorder, Film& film, raster::ImageSize size, const LayerSet& layers) {
  film.size = size;
  film.samples = 0;
  film.layers = layers;
  film.layers.add(LayerId::beauty);
  require_room(recorder.device(), film);
  reserve(recorder, film);
}

void begin_sample(Film& film) { ++film.samples; }

void add_sample(gpu::Recorder& recorder, const SampleIn& in, Film& film) {
  for (const LayerId id : film.layers.members()) {
    const LayerSource& source = row_of(id).source;
    const Held layer = held(source.fill);
    if (layer.add && (film.samples == 1 || !layer.only_first_sample)) layer.add(recorder, in, source, film.of(id));
  }
}

}  // namespace crsh::shading
