#include "output/png.h"

#include <fmt/format.h>
#include <stb_image.h>
#include <stb_image_write.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <memory>
#include <new>
#include <span>

#include "crsh/error.h"

namespace crsh::output {
namespace {

uint8_t byte_of(double value) { return static_cast<uint8_t>(std::clamp(value, 0.0, 1.0) * 255 + 0.5); }

std::string encode(const std::vector<uint8_t>& pixels, uint32_t width, uint32_t height, uint32_t channels) {
  std::string bytes;
  const auto append = [](void* target, void* data, int size) {
    static_cast<std::string*>(target)->append(static_cast<const char*>(data), static_cast<size_t>(size));
  };
  if (!stbi_write_png_to_func(append, &bytes, static_cast<int>(width), static_cast<int>(height),
                              static_cast<int>(channels), pixels.data(), static_cast<int>(width * channels)))
    throw std::bad_alloc();
  return bytes;
}

/// A premultiplied linear pixel as straight sRGB bytes and alpha.
std::array<uint8_t, 4> display_pixel(const float* rgba, double scale) {
  const double coverage = std::isnan(rgba[3]) ? 0 : std::clamp(double(rgba[3]), 0.0, 1.0);
  const double factor = coverage > 0 ? scale / coverage : 0;
  return {srgb_byte(rgba[0] * factor), srgb_byte(rgba[1] * factor), srgb_byte(rgba[2] * factor), byte_of(coverage)};
}

/// The names of an image's channels, given how many it has, in the order in which stb_image interleaves them.
std::span<const char* const> channel_names(int count) {
  static constexpr std::array names = {"Y", "A", "R", "G", "B", "A"};
  return count <= 2 ? std::span(names).first(static_cast<size_t>(count))
                    : std::span(names).subspan(2, static_cast<size_t>(count));
}

template <class T>
std::vector<Channel> split(const T* pixels, size_t count, int channels, Sample sample) {
  std::vector<Channel> result;
  const auto step = static_cast<size_t>(channels);
  for (size_t index = 0; index < step; ++index) {
    Channel& channel = result.emplace_back(Channel{channel_names(channels)[index], sample, {}});
    channel.bits.resize(count);
    for (size_t pixel = 0; pixel < count; ++pixel) channel.bits[pixel] = pixels[pixel * step + index];
  }
  std::ranges::sort(result, {}, &Channel::name);
  return result;
}

}  // namespace

uint8_t srgb_byte(double linear) {
  if (!(linear > 0)) return 0;
  return byte_of(linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - 0.055);
}

std::string encode_png(const Layer& beauty, uint32_t width, uint32_t height, double exposure) {
  const size_t count = size_t(width) * height;
  const double scale = std::exp2(exposure);
  std::vector<uint8_t> rgb(count * 3), rgba(count * 4);
  bool opaque = true;
  for (size_t pixel = 0; pixel < count; ++pixel) {
    const auto shown = display_pixel(&beauty.values[pixel * 4], scale);
    std::copy_n(shown.begin(), 3, &rgb[pixel * 3]);
    std::copy_n(shown.begin(), 4, &rgba[pixel * 4]);
    opaque = opaque && shown[3] == 255;
  }
  return opaque ? encode(rgb, width, height, 3) : encode(rgba, width, height, 4);
}

std::string encode_grey_png(const std::vector<uint8_t>& pixels, uint32_t width, uint32_t height) {
  return encode(pixels, width, height, 1);
}

std::string encode_rgb_png(const std::vector<uint8_t>& pixels, uint32_t width, uint32_t height) {
  return encode(pixels, width, height, 3);
}

Image decode_png(const std::string& bytes, const std::string& name) {
  const auto* data = reinterpret_cast<const stbi_uc*>(bytes.data());
  const int size = static_cast<int>(std::min<size_t>(bytes.size(), INT32_MAX));
  const auto refuse = [&](std::string_view why) {
    throw UserError(fmt::format("{}: broken or unsupported PNG file ({})", name, why));
  };
  int width = 0, height = 0, channels = 0;
  if (!stbi_info_from_memory(data, size, &width, &height, &channels)) refuse(stbi_failure_reason());
  if (width > int(longest_side) || height > int(longest_side))
    refuse(fmt::format("{}x{} pixels, more than {} a side", width, height, longest_side));
  const bool deep = stbi_is_16_bit_from_memory(data, size);
  using Pixels = std::unique_ptr<void, decltype(&stbi_image_free)>;
  const Pixels pixels(deep ? static_cast<void*>(stbi_load_16_from_memory(data, size, &width, &height, &channels, 0))
                           : static_cast<void*>(stbi_load_from_memory(data, size, &width, &height, &channels, 0)),
                      stbi_image_free);
  if (!pixels) refuse(stbi_failure_reason());
  const size_t count = size_t(width) * size_t(height);
  return {.format = Format::png,
          .width = uint32_t(width),
          .height = uint32_t(height),
          .channels = deep ? split(static_cast<const uint16_t*>(pixels.get()), count, channels, Sample::word)
                           : split(static_cast<const uint8_t*>(pixels.get()), count, channels, Sample::byte)};
}

}  // namespace crsh::output
