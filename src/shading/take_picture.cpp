// What a film has become, as a picture on the host.

#include <algorithm>
#include <cmath>

#include "shading/film.h"

namespace crsh::shading {
namespace {

/// Reads the film's buffers and makes layers of them.
class Developer {
 public:
  Developer(gpu::Recorder& recorder, const Film& film, const std::optional<glm::vec3>& background)
      : recorder_(recorder), film_(film), background_(background), scale_(1.0f / float(std::max(film.samples, 1u))) {}

  [[nodiscard]] Layer layer(LayerId id) const {
    Layer layer = empty_layer(id);
    switch (id) {
      case LayerId::beauty: add_beauty(layer); break;
      case LayerId::background: add_background(layer); break;
      case LayerId::shadow: add_shadow(layer); break;
      case LayerId::position:
      case LayerId::normal: add_vectors(layer, film_.sum(id), 1); break;
      case LayerId::depth: layer.values = recorder_.read<float>(film_.depth, pixels()); break;
      case LayerId::object: add_ids(layer, 0); break;
      case LayerId::material: add_ids(layer, 1); break;
      case LayerId::triangle_tests: add_tests(layer, shared::tests_triangle); break;
      case LayerId::node_tests: add_tests(layer, shared::tests_node); break;
      case LayerId::object_tests: add_tests(layer, shared::tests_object); break;
      default: add_vectors(layer, film_.sum(id), scale_);
    }
    return layer;
  }

 private:
  [[nodiscard]] uint64_t pixels() const { return uint64_t(film_.size.width) * film_.size.height; }
  [[nodiscard]] std::vector<glm::vec4> read(const gpu::Buffer& sums) const {
    return recorder_.read<glm::vec4>(sums, pixels());
  }

  [[nodiscard]] static Layer empty_layer(LayerId id) {
    return {.name = picture_layer(id), .channels = channels_of(id), .values = {}, .ids = {}};
  }

  /// The first channels of vec4s, scaled.
  void add_vectors(Layer& layer, const gpu::Buffer& sums, float scale) const {
    for (const glm::vec4& pixel : read(sums))
      for (int c = 0; c < int(layer.channels.size()); ++c) layer.values.push_back(pixel[c] * scale);
  }

  void add_beauty(Layer& layer) const {
    add_vectors(layer, film_.sum(LayerId::beauty), scale_);
    if (background_)
      for (size_t alpha = 3; alpha < layer.values.size(); alpha += 4) layer.values[alpha] = 1;
  }

  /// As often as a sample met nothing.
  void add_background(Layer& layer) const {
    const glm::vec3 background = background_.value_or(glm::vec3(0));
    for (const glm::vec4& pixel : read(film_.sum(LayerId::beauty)))
      for (int c = 0; c < 3; ++c) layer.values.push_back(background[c] * (float(film_.samples) - pixel.w) * scale_);
  }

  void add_shadow(Layer& layer) const {
    for (const glm::vec4& pixel : read(film_.sum(LayerId::shadow)))
      layer.values.push_back(pixel.y > 0 ? pixel.x / pixel.y : 0);
  }

  void add_ids(Layer& layer, int which) const {
    for (const glm::uvec2& pixel : recorder_.read<glm::uvec2>(film_.ids, pixels())) layer.ids.push_back(pixel[which]);
  }

  void add_tests(Layer& layer, uint32_t kind) const {
    for (const uint64_t pixel : recorder_.read<uint64_t>(film_.tests[kind], pixels()))
      layer.values.push_back(float(std::ldexp(double(pixel), -int(shared::tests_fraction_bits))));
  }

  gpu::Recorder& recorder_;
  const Film& film_;
  const std::optional<glm::vec3>& background_;
  float scale_;
};

}  // namespace

Picture take_picture(gpu::Recorder& recorder, const Film& film, const raster::CameraView& view,
                     const std::optional<glm::vec3>& background) {
  Picture picture{film.size.width, film.size.height, {}, view.world_to_camera(), view.world_to_ndc()};
  const Developer developer(recorder, film, background);
  for (size_t id = 0; id < layer_count; ++id)
    if (film.layers.has(static_cast<LayerId>(id))) picture.layers.push_back(developer.layer(static_cast<LayerId>(id)));
  return picture;
}

}  // namespace crsh::shading
