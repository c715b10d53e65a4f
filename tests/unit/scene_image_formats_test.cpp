// Every kind of picture that a material may name, decoded: each file is made here, and what its texels are follows from
// what went in.

#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cstdlib>

#include "scene/gltf/image.h"
#include "support/image_files.h"

using namespace crsh;
using test::png_file;
using test::PngOptions;
using test::ramps;
using test::Samples;

namespace {

std::span<const uint8_t> bytes_of(const std::string& file) {
  return {reinterpret_cast<const uint8_t*>(file.data()), file.size()};
}

scene::DecodedImage decoded(const std::string& file) { return scene::decode_image(bytes_of(file)); }

using Texel = std::array<uint32_t, 4>;

uint32_t to_8_bits(uint32_t value, uint32_t most) { return (value * 255 + most / 2) / most; }

/// What PNG says a texel of these samples is.
Texel texel_of(const Samples& samples, size_t i, const PngOptions& options) {
  const uint32_t most = (1u << static_cast<unsigned>(options.bits)) - 1;
  if (options.colour_type == 3) {
    const size_t entry = samples.at(i, 0);
    const uint32_t rgb = options.palette.at(entry);
    const uint32_t alpha = entry < options.palette_alphas.size() ? options.palette_alphas[entry] : 255;
    return {rgb >> 16u, rgb >> 8u & 255u, rgb & 255u, alpha};
  }
  const bool grey = samples.channels < 3, alpha = samples.channels % 2 == 0;
  Texel out{0, 0, 0, 255};
  bool transparent = !options.transparent.empty();
  for (size_t c = 0; c < 3; ++c) {
    out[c] = to_8_bits(samples.at(i, grey ? 0 : c), most);
    transparent = transparent && samples.at(i, grey ? 0 : c) == options.transparent[grey ? 0 : c];
  }
  if (alpha) out[3] = to_8_bits(samples.at(i, samples.channels - 1), most);
  if (transparent) out[3] = 0;
  return out;
}

/// The largest difference of a channel between a picture and what it should be.
template <class Expected>
int difference(const scene::Image& image, const Expected& expected) {
  int most = 0;
  for (size_t i = 0; i < image.rgba.size() / 4; ++i) {
    const Texel right = expected(i);
    for (size_t c = 0; c < 4; ++c) most = std::max(most, std::abs(int(image.rgba[i * 4 + c]) - int(right[c])));
  }
  return most;
}

void check_png(const Samples& samples, const PngOptions& options) {
  CAPTURE(options.colour_type);
  CAPTURE(options.bits);
  CAPTURE(options.interlaced);
  const scene::DecodedImage out = decoded(png_file(samples, options));
  REQUIRE(out.image.width == samples.width);
  REQUIRE(out.image.height == samples.height);
  CHECK(out.remark.empty());
  CHECK(difference(out.image, [&](size_t i) { return texel_of(samples, i, options); }) == 0);
}

/// Odd sizes, with rows that end within a byte and fewer rows than passes of interlacing.
void check_png_sizes(uint32_t channels, PngOptions options) {
  const uint32_t most = (1u << static_cast<unsigned>(options.bits)) - 1;
  for (const bool interlaced : {false, true})
    for (const auto& [width, height] : {std::pair(13u, 11u), {1u, 1u}, {3u, 2u}}) {
      options.interlaced = interlaced;
      const Samples samples = ramps(width, height, channels, most);
      if (options.transparent.size() == 1) options.transparent = {samples.at(0, 0)};
      if (options.transparent.size() == 3) options.transparent = {samples.at(0, 0), samples.at(0, 1), samples.at(0, 2)};
      check_png(samples, options);
    }
}

Texel rgb_of(const Samples& samples, size_t i) {
  const auto channel = [&](uint32_t c) { return uint32_t{samples.at(i, samples.channels == 1 ? 0 : c)}; };
  return {channel(0), channel(1), channel(2), samples.channels == 4 ? channel(3) : 255};
}

/// The light that four inks of 0 (none) to 255 let through.
Texel light_of(const Samples& inks, size_t i, bool inverted) {
  const auto light = [&](uint32_t c) { return inverted ? inks.at(i, c) : 255u - inks.at(i, c); };
  return {light(0) * light(3) / 255, light(1) * light(3) / 255, light(2) * light(3) / 255, 255};
}

int jpeg_loss(const Samples& samples, const test::JpegOptions& options) {
  return difference(decoded(jpeg_file(samples, options)).image, [&](size_t i) { return rgb_of(samples, i); });
}

}  // namespace

TEST_CASE("PNG in every colour type and depth, interlaced and not") {
  for (const int bits : {1, 2, 4, 8, 16}) check_png_sizes(1, {.colour_type = 0, .bits = bits});
  for (const int bits : {8, 16}) {
    check_png_sizes(2, {.colour_type = 4, .bits = bits});
    check_png_sizes(3, {.colour_type = 2, .bits = bits});
    check_png_sizes(4, {.colour_type = 6, .bits = bits});
  }
}

TEST_CASE("a PNG's tRNS makes one grey or one colour transparent, in 16 bits by all of them") {
  for (const int bits : {1, 2, 4, 8, 16}) check_png_sizes(1, {.colour_type = 0, .bits = bits, .transparent = {0}});
  for (const int bits : {8, 16}) check_png_sizes(3, {.colour_type = 2, .bits = bits, .transparent = {0, 0, 0}});
  check_png({2, 1, 1, {0x1200, 0x12FF}}, {.colour_type = 0, .bits = 16, .transparent = {0x1200}});
}

TEST_CASE("a PNG's palette, with alpha for all of its entries, for some and for none") {
  for (const int bits : {1, 2, 4, 8}) {
    PngOptions options{.colour_type = 3, .bits = bits};
    const uint32_t entries = 1u << static_cast<unsigned>(bits);
    for (uint32_t i = 0; i < entries; ++i) options.palette.push_back(i * 0x10305u & 0xFFFFFFu);
    check_png_sizes(1, options);
    options.palette_alphas = {7};
    check_png_sizes(1, options);
    for (uint32_t i = 1; i < entries; ++i) options.palette_alphas.push_back(static_cast<uint8_t>(255 - i));
    check_png_sizes(1, options);
  }
}

TEST_CASE("16 bits are rounded to the nearest 8") {
  Samples all{256, 256, 1, {}};
  for (uint32_t i = 0; i < 65536; ++i) all.values.push_back(static_cast<uint16_t>(i));
  check_png(all, {.colour_type = 0, .bits = 16});
}

TEST_CASE("a PNG's gamma, primaries and profile are ignored, a broken profile too") {
  check_png(ramps(9, 7, 4), {.profiles = true});
}

TEST_CASE("a PNG whose chunks have wrong checksums is drawn") {
  const Samples samples = ramps(9, 7, 4);
  std::string file = png_file(samples);
  const size_t end = file.find("IEND");
  REQUIRE(end != std::string::npos);
  file[end - 5] = static_cast<char>(file[end - 5] ^ 1);
  CHECK(decoded(file).image.rgba == decoded(png_file(samples)).image.rgba);
}

TEST_CASE("JPEG: baseline, progressive, grey, stored as RGB, with restart markers") {
  const Samples colour = ramps(37, 29, 3), grey = ramps(37, 29, 1);
  CHECK(jpeg_loss(colour, {}) <= 3);
  CHECK(jpeg_loss(colour, {.progressive = true}) <= 3);
  CHECK(jpeg_loss(colour, {.rgb = true}) <= 3);
  CHECK(jpeg_loss(colour, {.restart_rows = 1}) <= 3);
  CHECK(jpeg_loss(colour, {.progressive = true, .restart_rows = 1}) <= 3);
  CHECK(jpeg_loss(grey, {}) <= 2);
  CHECK(jpeg_loss(grey, {.progressive = true}) <= 2);
}

TEST_CASE("JPEG of four inks, as Adobe stores them and as the words mean, plain and as YCCK") {
  const Samples inks = ramps(37, 29, 4);
  for (const bool adobe : {true, false})
    for (const bool progressive : {true, false}) {
      const std::string file = jpeg_file(inks, {.progressive = progressive, .inks = true, .adobe = adobe});
      CHECK(difference(decoded(file).image, [&](size_t i) { return light_of(inks, i, adobe); }) <= 4);
    }
  const std::string file = jpeg_file(inks, {});  // YCCK is known by the marker
  CHECK(difference(decoded(file).image, [&](size_t i) { return light_of(inks, i, true); }) <= 4);
}

TEST_CASE("WebP without loss is exact, with loss it is near; alpha is straight") {
  const Samples samples = ramps(37, 29, 4);
  const auto right = [&](size_t i) { return rgb_of(samples, i); };
  CHECK(difference(decoded(webp_file(samples, true)).image, right) == 0);
  CHECK(difference(decoded(webp_file(samples, false)).image, right) <= 12);  // it halves the resolution of colours
}

TEST_CASE("AVIF of 8 bits is exact where nothing was lost; 10 and 12 bits are rounded; alpha is straight") {
  const Samples samples = ramps(37, 29, 4);
  CHECK(difference(decoded(test::avif_file(samples)).image, [&](size_t i) { return rgb_of(samples, i); }) <= 1);
  for (const uint32_t bits : {10u, 12u}) {
    const uint32_t most = (1u << bits) - 1;
    const Samples fine = ramps(37, 29, 4, most);
    const auto right = [&](size_t i) {
      Texel out = rgb_of(fine, i);
      for (uint32_t& channel : out) channel = to_8_bits(channel, most);
      return out;
    };
    CHECK(difference(decoded(test::avif_file(fine, bits)).image, right) <= 1);
  }
}

TEST_CASE("the head tells the size of every format") {
  const Samples colour = ramps(37, 29, 3), alpha = ramps(37, 29, 4);
  for (const std::string& file : {png_file(alpha), jpeg_file(colour), jpeg_file(colour, {.progressive = true}),
                                  webp_file(alpha, true), webp_file(alpha, false), test::avif_file(alpha)}) {
    const scene::ImageSize size = scene::image_size(bytes_of(file));
    CHECK(size.width == 37);
    CHECK(size.height == 29);
  }
}
