#include "scene/gltf/image.h"

#include <memory>

#include "scene/gltf/fault.h"

// A private copy of the decoder, with only the two formats of glTF. Its symbols cannot clash with those of other
// copies.
#define STB_IMAGE_STATIC
#define STB_IMAGE_IMPLEMENTATION
#define STBI_ONLY_PNG
#define STBI_ONLY_JPEG
#define STBI_NO_STDIO
#define STBI_MAX_DIMENSIONS 16384
#include <stb/stb_image.h>

namespace crsh::scene {

Image decode_image(std::span<const uint8_t> bytes) {
  constexpr uint64_t max_texels = uint64_t{1} << 26u;  // 8192 x 8192, 256 MiB
  // Deflate compresses to 1/1032 at best, and a PNG has up to eight texels in a byte. A file that claims to have more
  // is truncated or hostile.
  constexpr uint64_t max_texels_a_byte = 8 * 1032 + 64;
  int width = 0, height = 0, channels = 0;
  if (bytes.size() > (size_t{1} << 30u)) throw Fault("is larger than 1 GiB");
  const int size = static_cast<int>(bytes.size());
  if (!stbi_info_from_memory(bytes.data(), size, &width, &height, &channels) || width < 1 || height < 1)
    throw Fault("is neither PNG nor JPEG");
  const uint64_t texels = static_cast<uint64_t>(width) * static_cast<uint64_t>(height);
  if (width > STBI_MAX_DIMENSIONS || height > STBI_MAX_DIMENSIONS || texels > max_texels)
    throw Fault("has too many texels");
  if (texels > bytes.size() * max_texels_a_byte) throw Fault("is cut short");
  const std::unique_ptr<stbi_uc, void (*)(void*)> data(
      stbi_load_from_memory(bytes.data(), size, &width, &height, &channels, 4), stbi_image_free);
  if (!data) throw Fault("cannot be decoded");
  const size_t length = static_cast<size_t>(width) * static_cast<size_t>(height) * 4;
  return {static_cast<uint32_t>(width), static_cast<uint32_t>(height), {data.get(), data.get() + length}};
}

}  // namespace crsh::scene
