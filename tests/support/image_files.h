#pragma once
// Pictures as files, written by the libraries' own encoders.

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace crsh::test {

/// What a file is made of: rows from the top, `channels` numbers a texel.
struct Samples {
  uint32_t width = 0, height = 0, channels = 0;
  std::vector<uint16_t> values;
  [[nodiscard]] uint16_t at(size_t texel, size_t channel) const { return values[texel * channels + channel]; }
};

/// Smooth in x and y, another slope in each channel, from 0 to `most`.
[[nodiscard]] Samples ramps(uint32_t width, uint32_t height, uint32_t channels, uint32_t most = 255);

struct PngOptions {
  int colour_type = 6;  ///< PNG's own codes
  int bits = 8;
  bool interlaced = false;
  std::vector<uint32_t> palette;        ///< 0xRRGGBB
  std::vector<uint8_t> palette_alphas;  ///< tRNS of a palette
  std::vector<uint16_t> transparent;    ///< tRNS of grey or RGB: the value that is transparent
  bool profiles = false;                ///< gAMA, cHRM and a broken iCCP, which nobody may mind
};
[[nodiscard]] std::string png_file(const Samples& samples, const PngOptions& options = {});

struct JpegOptions {
  bool progressive = false;
  bool inks = false;  ///< four channels are CMYK, stored as given; else YCCK
  bool adobe = true;  ///< with the marker of that name, where there are inks
  bool rgb = false;   ///< stored as RGB
  int restart_rows = 0;
};
/// Of quality 100, all channels in full resolution.
[[nodiscard]] std::string jpeg_file(const Samples& samples, const JpegOptions& options = {});

/// Four channels.
[[nodiscard]] std::string webp_file(const Samples& samples, bool lossless);

/// Four channels, of 8 or more bits, with little loss.
[[nodiscard]] std::string avif_file(const Samples& samples, uint32_t bits = 8);

}  // namespace crsh::test
