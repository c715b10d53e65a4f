#include "scene/device/mip_levels.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace crsh::scene {
namespace {

constexpr uint32_t white16 = 65535;

double coded_of(double linear) {
  return linear <= 0.0031308 ? linear * 12.92 : 1.055 * std::pow(linear, 1 / 2.4) - 0.055;
}

/// From 8 bits to linear light in 16 bits, and back.
struct Curve {
  std::array<uint16_t, 256> to_linear{};
  std::vector<uint8_t> from_linear = std::vector<uint8_t>(white16 + 1);
  explicit Curve(bool srgb) {
    for (size_t i = 0; i < 256; ++i) to_linear[i] = uint16_t(std::lround(linear_of(uint8_t(i), srgb) * white16));
    for (size_t i = 0; i <= white16; ++i) {
      const double linear = double(i) / white16;
      from_linear[i] = uint8_t(std::lround(255 * (srgb ? coded_of(linear) : linear)));
    }
  }
};

/// Which texels of a row a texel of the next level covers, and how much of each.
struct Cover {
  std::array<uint32_t, 3> texel{};
  std::array<float, 3> share{};
};

std::vector<Cover> covers(uint32_t size) {
  const uint32_t half = halved(size);
  const double step = double(size) / half;  // 1, 2, or up to 3 where the size is odd
  std::vector<Cover> out(half);
  for (uint32_t i = 0; i < half; ++i) {
    const double begin = i * step, end = begin + step;
    for (uint32_t k = 0; k < 3; ++k) {
      const uint32_t texel = std::min(uint32_t(begin) + k, size - 1);
      const double overlap = std::min(end, uint32_t(begin) + k + 1.0) - std::max(begin, uint32_t(begin) + double(k));
      out[i].texel[k] = texel;
      out[i].share[k] = float(std::max(overlap, 0.0) / step);
    }
  }
  return out;
}

}  // namespace

double linear_of(uint8_t coded, bool srgb) {
  const double c = coded / 255.0;
  if (!srgb) return c;
  return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
}

uint32_t levels_below(uint32_t width, uint32_t height) {
  uint32_t levels = 0;
  for (uint32_t longest = std::max(width, height); longest > 1; longest = halved(longest)) ++levels;
  return levels;
}

Image next_level(const Image& image, bool srgb) {
  static const Curve coded(true), plain(false);
  const std::vector<Cover> columns = covers(image.width), rows = covers(image.height);
  Image out{uint32_t(columns.size()), uint32_t(rows.size()), {}};
  out.rgba.resize(columns.size() * rows.size() * 4);
  uint8_t* to = out.rgba.data();
  for (const Cover& row : rows)
    for (const Cover& column : columns) {
      std::array<float, 4> sum{};
      for (size_t j = 0; j < 3; ++j)
        for (size_t i = 0; i < 3; ++i) {
          const float share = row.share[j] * column.share[i];
          if (share == 0) continue;
          const uint8_t* from = &image.rgba[(size_t(row.texel[j]) * image.width + column.texel[i]) * 4];
          for (size_t c = 0; c < 4; ++c) sum[c] += share * float((srgb && c < 3 ? coded : plain).to_linear[from[c]]);
        }
      for (size_t c = 0; c < 4; ++c)
        *to++ = (srgb && c < 3 ? coded : plain).from_linear[std::min(uint32_t(sum[c] + 0.5f), white16)];
    }
  return out;
}

}  // namespace crsh::scene
