// Makes a picture on the host of a film.

#include <algorithm>
#include <cmath>

#include "shading/film.h"

namespace crsh::shading {
namespace {

/// The matrix for points whose coordinates begin farther off by `origin` than those that it is for.
glm::dmat4 from_origin(const glm::mat4& matrix, const glm::dvec3& origin) {
  glm::dmat4 moved(matrix);
  if (origin != glm::dvec3(0)) moved[3] -= moved * glm::dvec4(origin, 0);
  return moved;
}

/// Reads the film's buffers and makes layers of them.
class Developer {
 public:
  Developer(gpu::Recorder& recorder, const Film& film, const glm::dvec3& origin,
            const std::optional<glm::vec3>& background)
      : recorder_(recorder),
        film_(film),
        origin_(origin),
        background_(background),
        scale_(1.0f / float(std::max(film.samples, 1u))) {}

  [[nodiscard]] Layer layer(LayerId id) const {
    Layer layer{.name = picture_layer(id), .channels = channels_of(id), .values = {}, .ids = {}};
    switch (row_of(id).source.fill) {
      case LayerFill::mean:
      case LayerFill::base_colour: add_vectors(layer, id, scale_); break;
      case LayerFill::first: add_vectors(layer, id, 1); break;
      case LayerFill::visibility: add_visibility(layer, id); break;
      case LayerFill::background: add_background(layer); break;
      case LayerFill::depth: layer.values = read<float>(id); break;
      case LayerFill::object:
      case LayerFill::material: layer.ids = read<uint32_t>(id); break;
      case LayerFill::tests: add_tests(layer, id); break;
    }
    if (id == LayerId::beauty && background_) make_opaque(layer);
    if (row_of(id).source.value == SurfaceValue::position) add_origin(layer, id);
    return layer;
  }

 private:
  template <class Pixel>
  [[nodiscard]] std::vector<Pixel> read(LayerId id) const {
    return recorder_.read<Pixel>(film_.of(id), uint64_t(film_.size.width) * film_.size.height);
  }

  /// As many components of the vec4s as there are channels, scaled.
  void add_vectors(Layer& layer, LayerId id, float scale) const {
    const int first = int(row_of(id).source.which), channels = int(layer.channels.size());
    for (const glm::vec4& pixel : read<glm::vec4>(id))
      for (int c = 0; c < channels; ++c) layer.values.push_back(pixel[first + c] * scale);
  }

  /// Where something was met: elsewhere a position's w, which has the triangle's bits, is not a number (shared::none).
  void add_origin(Layer& layer, LayerId id) const {
    if (origin_ == glm::dvec3(0)) return;
    const std::vector<glm::vec4> pixels = read<glm::vec4>(id);
    for (size_t i = 0; i < layer.values.size(); ++i)
      if (const auto axis = int(i % 3); !std::isnan(pixels[i / 3].w))
        layer.values[i] = float(double(layer.values[i]) + origin_[axis]);
  }

  static void make_opaque(Layer& beauty) {
    for (size_t alpha = 3; alpha < beauty.values.size(); alpha += 4) beauty.values[alpha] = 1;
  }

  /// Adds the background, weighted by how many samples of a pixel met nothing.
  void add_background(Layer& layer) const {
    const glm::vec3 background = background_.value_or(glm::vec3(0));
    for (const glm::vec4& pixel : read<glm::vec4>(LayerId::beauty))
      for (int c = 0; c < 3; ++c) layer.values.push_back(background[c] * (float(film_.samples) - pixel.w) * scale_);
  }

  void add_visibility(Layer& layer, LayerId id) const {
    for (const glm::vec4& pixel : read<glm::vec4>(id)) layer.values.push_back(pixel.y > 0 ? pixel.x / pixel.y : 0);
  }

  void add_tests(Layer& layer, LayerId id) const {
    for (const uint64_t pixel : read<uint64_t>(id))
      layer.values.push_back(float(std::ldexp(double(pixel), -int(shared::tests_fraction_bits))));
  }

  gpu::Recorder& recorder_;
  const Film& film_;
  const glm::dvec3& origin_;
  const std::optional<glm::vec3>& background_;
  float scale_;
};

}  // namespace

Picture take_picture(gpu::Recorder& recorder, const Film& film, const raster::CameraView& view,
                     const glm::dvec3& origin, const std::optional<glm::vec3>& background) {
  Picture picture{film.size.width,
                  film.size.height,
                  {},
                  from_origin(view.world_to_camera(), origin),
                  from_origin(view.world_to_ndc(), origin)};
  const Developer developer(recorder, film, origin, background);
  for (const LayerId id : film.layers.members()) picture.layers.push_back(developer.layer(id));
  return picture;
}

}  // namespace crsh::shading
