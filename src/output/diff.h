#pragma once
// Comparison of two images, as `crsh diff` makes it.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "output/image.h"

namespace crsh::output {

/// What two images may differ by and still pass.
struct Tolerance {
  bool exact = false;         ///< every bit equal; nothing below matters
  double fail = 0.004;        ///< a pixel with a larger difference fails
  double fail_percent = 0.1;  ///< per cent of pixels that may fail
  double hard_fail = 0.05;    ///< no pixel may differ by more
};

/// A pixel and a channel, and both images' values there.
struct Worst {
  uint32_t x = 0, y = 0;
  std::string channel;
  double a = 0, b = 0, difference = 0;
};

struct Comparison {
  std::string mismatch;  ///< why pixels were not compared: other sizes or channels; empty: they were
  bool same = false;     ///< within the tolerance
  uint32_t width = 0, height = 0;
  std::vector<std::string> channels;  ///< compared
  uint64_t failing = 0;               ///< pixels beyond `fail`, or with unequal bits
  double mean = 0;                    ///< mean of all finite differences, over pixels and channels
  std::optional<Worst> worst;         ///< none where all is equal
  std::vector<float> differences;     ///< a pixel: the largest over the channels
};

/// Compares the channels of `layers` ("beauty" is R, G, B, A; "all"). The difference of two values is absolute for
/// PNG, |a-b| / max(|a|, |b|, 0.01) for OpenEXR, and 1 for unequal ids, float or uint; infinite where only one is not a
/// number.
/// Throws UserError for a layer in neither image and for images of two formats.
[[nodiscard]] Comparison compare(const Image& a, const Image& b, const std::vector<std::string>& layers,
                                 const Tolerance& tolerance);

/// One line: the verdict and the worst pixel, channel and both values.
[[nodiscard]] std::string verdict(const Comparison& comparison, const Tolerance& tolerance);

/// Schema crsh-diff/1.
[[nodiscard]] std::string diff_json(const Comparison& comparison, const Tolerance& tolerance, const std::string& a,
                                    const std::string& b);

/// A grey PNG: black where equal, white at the worst pixel.
[[nodiscard]] std::string difference_png(const Comparison& comparison);

}  // namespace crsh::output
