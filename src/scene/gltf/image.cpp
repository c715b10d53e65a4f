#include "scene/gltf/image.h"

#include <algorithm>

#include "scene/gltf/image_format.h"

namespace crsh::scene {

namespace {

constexpr size_t largest_file = size_t{1} << 30u;
constexpr std::array<uint8_t, 12> ktx2_start = {0xAB, 'K', 'T', 'X', ' ', '2', '0', 0xBB, '\r', '\n', 0x1A, '\n'};

const ImageFormat& format_of(std::span<const uint8_t> bytes) {
  for (const ImageFormat* format : {&png_format, &jpeg_format, &webp_format, &avif_format})
    if (format->is(bytes)) return *format;
  // No library that Debian packages reads Basis Universal.
  if (begins_with(bytes, ktx2_start)) throw FormatFault("is KTX2, which crsh does not read");
  throw FormatFault("is neither PNG, JPEG, WebP nor AVIF");
}

ImageSize checked_size(const ImageFormat& format, std::span<const uint8_t> bytes) {
  if (bytes.size() > largest_file) throw Fault("is larger than 1 GiB");
  const ImageSize size = format.size(bytes);
  if (size.texels() == 0) throw Fault("has no texels");
  if (std::max(size.width, size.height) > longest_image_side || size.texels() > most_image_texels)
    throw Fault("has too many texels");
  // A file that claims to have more is truncated or hostile.
  if (format.max_texels_a_byte != 0 && size.texels() > bytes.size() * format.max_texels_a_byte)
    throw Fault("is cut short");
  return size;
}

}  // namespace

ImageSize image_size(std::span<const uint8_t> bytes) { return checked_size(format_of(bytes), bytes); }

DecodedImage decode_image(std::span<const uint8_t> bytes) {
  const ImageFormat& format = format_of(bytes);
  const ImageSize size = checked_size(format, bytes);
  DecodedImage out;
  out.image = {size.width, size.height, std::vector<uint8_t>(size.texels() * 4)};
  out.remark = format.decode(bytes, size, out.image.rgba);
  return out;
}

}  // namespace crsh::scene
