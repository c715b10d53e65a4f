#include "support/image_files.h"

#include <avif/avif.h>
#include <png.h>
#include <webp/encode.h>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <stdexcept>

#include <jpeglib.h>

namespace crsh::test {

namespace {

std::string text_of(const uint8_t* bytes, size_t size) { return {reinterpret_cast<const char*>(bytes), size}; }

/// A row as PNG packs it: 16 bits are big-endian, fewer than 8 fill bytes from their high end.
std::vector<uint8_t> packed_row(const Samples& samples, uint32_t y, int bits) {
  const size_t count = size_t{samples.width} * samples.channels, first = y * count;
  std::vector<uint8_t> out((count * static_cast<size_t>(bits) + 7) / 8);
  for (size_t i = 0; i < count; ++i) {
    const uint32_t value = samples.values[first + i];
    const size_t bit = i * static_cast<size_t>(bits);
    if (bits == 16) out[2 * i] = static_cast<uint8_t>(value >> 8u);
    const size_t shift = bits == 16 ? 0 : 8 - static_cast<size_t>(bits) - bit % 8;
    out[bits == 16 ? 2 * i + 1 : bit / 8] |= static_cast<uint8_t>(value << shift);
  }
  return out;
}

void set_transparency(png_structp png, png_infop info, const PngOptions& options) {
  std::vector<png_color> palette;
  for (const uint32_t rgb : options.palette)
    palette.push_back(
        {static_cast<png_byte>(rgb >> 16u), static_cast<png_byte>(rgb >> 8u), static_cast<png_byte>(rgb)});
  if (!palette.empty()) png_set_PLTE(png, info, palette.data(), static_cast<int>(palette.size()));
  if (!options.palette_alphas.empty())
    png_set_tRNS(png, info, options.palette_alphas.data(), static_cast<int>(options.palette_alphas.size()), nullptr);
  if (options.transparent.empty()) return;
  png_color_16 colour{};
  colour.gray = colour.red = options.transparent[0];
  if (options.transparent.size() == 3) colour.green = options.transparent[1], colour.blue = options.transparent[2];
  png_set_tRNS(png, info, nullptr, 0, &colour);
}

void set_profiles(png_structp png, png_infop info) {
  png_set_gAMA_fixed(png, info, 100000);
  png_set_cHRM(png, info, 0.3, 0.3, 0.7, 0.2, 0.2, 0.7, 0.1, 0.1);
}

void append(png_structp png, png_bytep bytes, size_t size) {
  static_cast<std::string*>(png_get_io_ptr(png))->append(reinterpret_cast<const char*>(bytes), size);
}

}  // namespace

Samples ramps(uint32_t width, uint32_t height, uint32_t channels, uint32_t most) {
  Samples out{width, height, channels, {}};
  for (uint32_t y = 0; y < height; ++y)
    for (uint32_t x = 0; x < width; ++x)
      for (uint32_t c = 0; c < channels; ++c) {
        const double u = (x + 0.5) / width, v = (y + 0.5) / height;
        const double value = c == 0 ? u : c == 1 ? v : c == 2 ? 1 - u * v : 0.25 + 0.5 * v + 0.25 * u;
        out.values.push_back(static_cast<uint16_t>(value * most + 0.5));
      }
  return out;
}

std::string png_file(const Samples& samples, const PngOptions& options) {
  std::string out;
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
  png_infop info = png_create_info_struct(png);
  png_set_write_fn(png, &out, append, [](png_structp) {});
  png_set_IHDR(png, info, samples.width, samples.height, options.bits, options.colour_type,
               options.interlaced ? PNG_INTERLACE_ADAM7 : PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_BASE,
               PNG_FILTER_TYPE_BASE);
  set_transparency(png, info, options);
  if (options.profiles) set_profiles(png, info);
  png_write_info(png, info);
  if (options.profiles) png_write_chunk(png, reinterpret_cast<png_const_bytep>("iCCP"), nullptr, 0);
  const int passes = png_set_interlace_handling(png);
  for (int pass = 0; pass < passes; ++pass)
    for (uint32_t y = 0; y < samples.height; ++y) png_write_row(png, packed_row(samples, y, options.bits).data());
  png_write_end(png, info);
  png_destroy_write_struct(&png, &info);
  return out;
}

std::string jpeg_file(const Samples& samples, const JpegOptions& options) {
  constexpr J_COLOR_SPACE spaces[] = {JCS_UNKNOWN, JCS_GRAYSCALE, JCS_UNKNOWN, JCS_RGB, JCS_CMYK};
  jpeg_compress_struct jpeg{};
  jpeg_error_mgr errors{};
  jpeg.err = jpeg_std_error(&errors);
  jpeg_create_compress(&jpeg);
  unsigned char* bytes = nullptr;
  unsigned long size = 0;
  jpeg_mem_dest(&jpeg, &bytes, &size);
  jpeg.image_width = samples.width;
  jpeg.image_height = samples.height;
  jpeg.input_components = static_cast<int>(samples.channels);
  jpeg.in_color_space = spaces[samples.channels];
  jpeg_set_defaults(&jpeg);
  if (options.rgb) jpeg_set_colorspace(&jpeg, JCS_RGB);
  if (samples.channels == 4) jpeg_set_colorspace(&jpeg, options.inks ? JCS_CMYK : JCS_YCCK);
  if (samples.channels == 4) jpeg.write_Adobe_marker = options.adobe;
  jpeg_set_quality(&jpeg, 100, TRUE);
  for (int c = 0; c < jpeg.num_components; ++c) jpeg.comp_info[c].h_samp_factor = jpeg.comp_info[c].v_samp_factor = 1;
  if (options.progressive) jpeg_simple_progression(&jpeg);
  jpeg.restart_in_rows = options.restart_rows;
  jpeg_start_compress(&jpeg, TRUE);
  for (uint32_t y = 0; y < samples.height; ++y) {
    std::vector<uint8_t> row = packed_row(samples, y, 8);
    JSAMPROW from = row.data();
    jpeg_write_scanlines(&jpeg, &from, 1);
  }
  jpeg_finish_compress(&jpeg);
  jpeg_destroy_compress(&jpeg);
  std::string out = text_of(bytes, size);
  std::free(bytes);
  return out;
}

std::string webp_file(const Samples& samples, bool lossless) {
  const std::vector<uint8_t> texels(samples.values.begin(), samples.values.end());
  const int width = static_cast<int>(samples.width), height = static_cast<int>(samples.height);
  uint8_t* bytes = nullptr;
  const size_t size = lossless ? WebPEncodeLosslessRGBA(texels.data(), width, height, width * 4, &bytes)
                               : WebPEncodeRGBA(texels.data(), width, height, width * 4, 100, &bytes);
  std::string out = text_of(bytes, size);
  WebPFree(bytes);
  return out;
}

std::string avif_file(const Samples& samples, uint32_t bits) {
  avifImage* image = avifImageCreate(samples.width, samples.height, bits, AVIF_PIXEL_FORMAT_YUV444);
  image->matrixCoefficients = AVIF_MATRIX_COEFFICIENTS_IDENTITY;
  image->yuvRange = AVIF_RANGE_FULL;
  avifRGBImage rgb{};
  avifRGBImageSetDefaults(&rgb, image);
  std::vector<uint16_t> texels = samples.values;
  std::vector<uint8_t> narrow(texels.begin(), texels.end());
  rgb.pixels = bits == 8 ? narrow.data() : reinterpret_cast<uint8_t*>(texels.data());
  rgb.rowBytes = samples.width * (bits == 8 ? 4 : 8);
  avifEncoder* encoder = avifEncoderCreate();
  encoder->speed = AVIF_SPEED_FASTEST;
  encoder->minQuantizer = encoder->maxQuantizer = AVIF_QUANTIZER_LOSSLESS;
  encoder->minQuantizerAlpha = encoder->maxQuantizerAlpha = AVIF_QUANTIZER_LOSSLESS;
  avifRWData file = AVIF_DATA_EMPTY;
  if (avifImageRGBToYUV(image, &rgb) != AVIF_RESULT_OK || avifEncoderWrite(encoder, image, &file) != AVIF_RESULT_OK)
    throw std::runtime_error("libavif encodes nothing here");
  std::string out = text_of(file.data, file.size);
  avifRWDataFree(&file);
  avifEncoderDestroy(encoder);
  avifImageDestroy(image);
  return out;
}

}  // namespace crsh::test
