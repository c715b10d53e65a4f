#include "output/heat_map.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>
#include <numbers>

#include "crsh/assertion.h"
#include "output/png.h"

namespace crsh::output {
namespace {

using Colour = std::array<uint8_t, 3>;

/// CIE L*, a*, b* under D65 as linear Rec. 709.
glm::dvec3 linear_of_lab(double lightness, double a, double b) {
  constexpr glm::dvec3 white(0.95047, 1, 1.08883);
  constexpr double knee = 6.0 / 29;
  const double y = (lightness + 16) / 116;
  glm::dvec3 xyz(y + a / 500, y, y - b / 200);
  for (int i = 0; i < 3; ++i)
    xyz[i] = white[i] * (xyz[i] > knee ? xyz[i] * xyz[i] * xyz[i] : 3 * knee * knee * (xyz[i] - 4.0 / 29));
  return {glm::dot(glm::dvec3(3.2404542, -1.5371385, -0.4985314), xyz),
          glm::dot(glm::dvec3(-0.9692660, 1.8760108, 0.0415560), xyz),
          glm::dot(glm::dvec3(0.0556434, -0.2040259, 1.0572252), xyz)};
}

/// Violet, blue, teal, green, yellow. The chroma is low enough for sRGB everywhere; in the middle, at teal, it can hold
/// little.
Colour scale_colour(double t) {
  const double lightness = 15 + 78 * t, hue = (310 - 210 * t) * std::numbers::pi / 180;
  const double chroma = 26 + 40 * std::pow(2 * t - 1, 4) + 25 * t * t * t;
  const glm::dvec3 linear = linear_of_lab(lightness, chroma * std::cos(hue), chroma * std::sin(hue));
  return {srgb_byte(linear.r), srgb_byte(linear.g), srgb_byte(linear.b)};
}

/// The scale as a table, in finer steps than 8 bits can show.
const std::vector<Colour>& scale() {
  static const std::vector<Colour> colours = [] {
    std::vector<Colour> made(1024);
    for (size_t i = 0; i < made.size(); ++i) made[i] = scale_colour(double(i) / double(made.size() - 1));
    return made;
  }();
  return colours;
}

/// The least of 1, 1.5, 2, 3, 4, 5, 6, 8 or 10 times a power of ten that is not below `value`.
double rounded_up(double value) {
  const double power = std::pow(10, std::floor(std::log10(value)));
  for (const double digit : {1.0, 1.5, 2.0, 3.0, 4.0, 5.0, 6.0, 8.0})
    if (digit * power >= value) return digit * power;
  return 10 * power;
}

/// The largest of 1, 2 or 5 times a power of ten that fits into `maximum` at least twice.
double tick_step(double maximum) {
  const double power = std::pow(10, std::floor(std::log10(maximum)));
  for (const double digit : {5.0, 2.0, 1.0, 0.5})
    if (2 * digit * power <= maximum) return digit * power;
  return 0.2 * power;
}

std::string short_number(double value) {
  if (value >= 1e9) return fmt::format("{:g}G", value / 1e9);
  if (value >= 1e6) return fmt::format("{:g}M", value / 1e6);
  if (value >= 1e4) return fmt::format("{:g}k", value / 1e3);
  return fmt::format("{:g}", value);
}

void append(ColourPicture& picture, const Colour& colour) {
  picture.rgb.insert(picture.rgb.end(), colour.begin(), colour.end());
}

}  // namespace

Colour heat_colour(double place) {
  if (std::isnan(place)) return {128, 128, 128};
  return scale()[static_cast<size_t>(std::lround(std::clamp(place, 0.0, 1.0) * double(scale().size() - 1)))];
}

std::vector<float> tests_of(const Picture& picture) {
  std::vector<float> sum;
  for (const Layer& layer : picture.layers) {
    if (!layer.name.starts_with("Tests.")) continue;
    sum.resize(layer.values.size());
    std::ranges::transform(sum, layer.values, sum.begin(), std::plus());
  }
  return sum;
}

double heat_maximum(std::span<const float> values) {
  std::vector<float> sorted;
  std::ranges::copy_if(values, std::back_inserter(sorted), [](float value) { return std::isfinite(value); });
  if (sorted.empty()) return 1;
  const auto most = sorted.begin() + static_cast<std::ptrdiff_t>(double(sorted.size() - 1) * 0.995);
  std::ranges::nth_element(sorted, most);
  return *most > 1 ? rounded_up(double(*most)) : 1;
}

ColourPicture heat_map(std::span<const float> values, uint32_t width, uint32_t height, double maximum) {
  CRSH_ASSERT(values.size() == size_t(width) * height && maximum > 0, "a heat map of another size");
  ColourPicture picture{width, height, {}};
  picture.rgb.reserve(values.size() * 3);
  for (const float value : values) append(picture, heat_colour(double(value) / maximum));
  return picture;
}

std::vector<HeatTick> heat_ticks(double maximum) {
  CRSH_ASSERT(maximum > 0, "a scale without extent");
  const double step = tick_step(maximum);
  std::vector<HeatTick> ticks;
  for (int i = 0; i * step <= maximum * (1 + 1e-9); ++i) ticks.push_back({i * step / maximum, short_number(i * step)});
  return ticks;
}

ColourPicture heat_legend(uint32_t width, uint32_t height) {
  ColourPicture picture{width, height, {}};
  picture.rgb.reserve(size_t(width) * height * 3);
  for (uint32_t y = 0; y < height; ++y)
    for (uint32_t x = 0; x < width; ++x) append(picture, heat_colour(width > 1 ? double(x) / (width - 1) : 0));
  return picture;
}

std::string encode_colour_png(const ColourPicture& picture) {
  return encode_rgb_png(picture.rgb, picture.width, picture.height);
}

}  // namespace crsh::output
