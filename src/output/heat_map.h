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

/// The scale from 0 (dark violet) to 1 (yellow), clamped. CIE lightness rises with it in a straight line, and hue turns
/// one way, so that equal steps look equal, also in grey and to the colour-blind. Not a number is grey.
[[nodiscard]] std::array<uint8_t, 3> heat_colour(double place);

/// All tests of each pixel: the sum of the layers Tests.* that the picture has; empty where it has none.
[[nodiscard]] std::vector<float> tests_of(const Picture& picture);

/// A round number that 99.5 per cent of the values stay below: few hot pixels leave the others distinct. At least 1.
/// For pictures to compare, take the largest of theirs.
[[nodiscard]] double heat_maximum(std::span<const float> values);

/// `values`, a pixel each, on the scale from 0 to `maximum`; more shows as the maximum.
[[nodiscard]] ColourPicture heat_map(std::span<const float> values, uint32_t width, uint32_t height, double maximum);

/// A mark of the legend: where, 0 to 1, and its text ("0", "2500", "10k", "1.5M").
struct HeatTick {
  double place = 0;
  std::string label;
};
/// Three to six round numbers from 0 to `maximum`.
[[nodiscard]] std::vector<HeatTick> heat_ticks(double maximum);
/// The scale from left to right.
[[nodiscard]] ColourPicture heat_legend(uint32_t width, uint32_t height);

/// As a PNG file.
[[nodiscard]] std::string encode_colour_png(const ColourPicture& picture);

}  // namespace crsh::output
