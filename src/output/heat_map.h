#pragma once
// Numbers as colours: how many tests each pixel cost, from the layers Tests.*, as a picture and its legend.

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "crsh/picture.h"

namespace crsh::output {

/// Three bytes a pixel, sRGB, rows from the top.
struct ColourPicture {
  uint32_t width = 0, height = 0;
  std::vector<uint8_t> rgb;
};

/// The colour at a place of the scale, from 0 (dark violet) to 1 (yellow), clamped. CIE lightness rises linearly and
/// hue turns one way, so that equal steps look equal, also in grey and to the colour-blind. Not a number is grey.
[[nodiscard]] std::array<uint8_t, 3> heat_colour(double place);

/// All tests of each pixel: the sum of the layers Tests.* that the picture has; empty where it has none.
[[nodiscard]] std::vector<float> tests_of(const Picture& picture);

/// A round number, at least 1, that 99.5 per cent of the values stay below: a few very large values must not make all
/// others look alike. To compare pictures, use the largest of theirs for all.
[[nodiscard]] double heat_maximum(std::span<const float> values);

/// The picture of `values`, one a pixel, on the scale from 0 to `maximum`; larger ones look like the maximum.
[[nodiscard]] ColourPicture heat_map(std::span<const float> values, uint32_t width, uint32_t height, double maximum);

/// A mark of the legend: where, 0 to 1, and its text ("0", "2500", "10k", "1.5M").
struct HeatTick {
  double place = 0;
  std::string label;
};
/// Three to six round numbers from 0 to `maximum`.
[[nodiscard]] std::vector<HeatTick> heat_ticks(double maximum);
/// The scale as a picture, from left to right.
[[nodiscard]] ColourPicture heat_legend(uint32_t width, uint32_t height);

/// The picture as a PNG file.
[[nodiscard]] std::string encode_colour_png(const ColourPicture& picture);

}  // namespace crsh::output
