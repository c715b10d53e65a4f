#include "oracle/alpha.h"

#include <algorithm>
#include <cmath>

namespace crsh::test {
namespace {

constexpr double rounding = 1e-4;  // of alpha in float32, sampled where coordinates are large

/// The texel that stands for number `i` of a row or column of `size`.
size_t wrapped(int64_t i, int64_t size, scene::Wrap wrap) {
  if (wrap == scene::Wrap::clamp) return size_t(std::clamp<int64_t>(i, 0, size - 1));
  const int64_t period = wrap == scene::Wrap::mirror ? 2 * size : size;
  const int64_t inside = ((i % period) + period) % period;
  return size_t(inside < size ? inside : period - 1 - inside);
}

double texel(const scene::Texture& texture, const scene::Image& image, double x, double y) {
  const size_t column = wrapped(int64_t(x), image.width, texture.wrap_s);
  const size_t row = wrapped(int64_t(y), image.height, texture.wrap_t);
  return image.rgba[4 * (row * image.width + column) + 3] / 255.0;
}

/// What is clamped stays so, however large the coordinate is; what repeats is brought near.
double reduced(double u, scene::Wrap wrap) {
  if (!std::isfinite(u)) return 0;
  return wrap == scene::Wrap::clamp ? std::clamp(u, 0.0, 1.0) : u - 2 * std::floor(u / 2);
}

/// At the largest level, as it is seen large.
double texture_alpha(const scene::Texture& texture, const scene::Image& image, const glm::dvec2& uv) {
  const double x = reduced(uv.x, texture.wrap_s) * image.width, y = reduced(uv.y, texture.wrap_t) * image.height;
  if (texture.nearest) return texel(texture, image, std::floor(x), std::floor(y));
  const double left = std::floor(x - 0.5), top = std::floor(y - 0.5), right = x - 0.5 - left, down = y - 0.5 - top;
  const double upper = std::lerp(texel(texture, image, left, top), texel(texture, image, left + 1, top), right);
  const double lower = std::lerp(texel(texture, image, left, top + 1), texel(texture, image, left + 1, top + 1), right);
  return std::lerp(upper, lower, down);
}

/// KHR_texture_transform: scaled, turned counter-clockwise as one sees it, moved.
glm::dvec2 transformed(const scene::TextureTransform& by, const glm::dvec2& uv) {
  const glm::dvec2 scaled = uv * glm::dvec2(by.scale);
  const double c = std::cos(double(by.rotation)), s = std::sin(double(by.rotation));
  return glm::dvec2(c * scaled.x + s * scaled.y, c * scaled.y - s * scaled.x) + glm::dvec2(by.offset);
}

}  // namespace

double OracleAlpha::at(const glm::dvec2& weights) const {
  const double first = 1 - weights.x - weights.y;
  const double alpha = glm::dot(corners, glm::dvec3(first, weights));
  const double sampled =
      texture ? texture_alpha(*texture, *image, uv[0] * first + uv[1] * weights.x + uv[2] * weights.y) : 1;
  return std::clamp(alpha * sampled, 0.0, 1.0);
}

Range OracleAlpha::around(const glm::dvec2& weights, double off) const {
  Range range{at(weights), at(weights)};
  for (int i = 0; i < 9; ++i) {
    const double alpha = at(weights + off * glm::dvec2(i % 3 - 1, i / 3 - 1));
    range = {std::min(range.low, alpha), std::max(range.high, alpha)};
  }
  if (range.low > 1 - 1e-12) return {1, 1};
  return {std::max(range.low - rounding, 0.0), std::min(range.high + rounding, 1.0)};
}

std::optional<OracleAlpha> oracle_alpha(const scene::Scene& scene, const scene::Mesh& mesh,
                                        const scene::Material& material, const glm::uvec3& corners) {
  if (material.alpha_mode == scene::AlphaMode::opaque) return {};
  OracleAlpha out;
  out.blends = material.alpha_mode == scene::AlphaMode::blend;
  out.least = out.blends ? 1.0 / 256 : double(material.alpha_cutoff);
  if (!(out.least > 0)) return {};
  const scene::TextureUse& use = material.texture(scene::Slot::base_colour);
  if (use.texture && !scene.images[scene.textures[*use.texture].image].rgba.empty()) {
    out.texture = &scene.textures[*use.texture];
    out.image = &scene.images[out.texture->image];
  }
  for (int i = 0; i < 3; ++i) {
    out.corners[i] = double(scene::unpacked_colour(mesh.colours[corners[i]]).a) * double(material.base_colour.a);
    const std::vector<glm::vec2>& uv = mesh.uv[use.texcoord];
    out.uv[size_t(i)] = transformed(use.transform, uv.empty() ? glm::dvec2(0) : glm::dvec2(uv[corners[i]]));
  }
  return out;
}

}  // namespace crsh::test
