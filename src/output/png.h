#pragma once
// PNG: eight bits a channel, sRGB.

#include <string>

#include "crsh/picture.h"
#include "output/image.h"

namespace crsh::output {

/// A linear value (clamped to 0..1; not a number is 0) on the sRGB curve, as a byte.
[[nodiscard]] uint8_t srgb_byte(double linear);

/// `beauty` (linear, premultiplied RGBA) times 2^exposure; RGB where every pixel is opaque, else RGBA, not
/// premultiplied.
[[nodiscard]] std::string encode_png(const Layer& beauty, uint32_t width, uint32_t height, double exposure);

/// One byte a pixel, rows from the top.
[[nodiscard]] std::string encode_grey_png(const std::vector<uint8_t>& pixels, uint32_t width, uint32_t height);

/// Three bytes a pixel, sRGB, rows from the top.
[[nodiscard]] std::string encode_rgb_png(const std::vector<uint8_t>& pixels, uint32_t width, uint32_t height);

/// Channels R, G, B, A or Y, A of 8 or 16 bits. Throws UserError that begins with `name`.
[[nodiscard]] Image decode_png(const std::string& bytes, const std::string& name);

}  // namespace crsh::output
