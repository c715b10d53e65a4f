#pragma once
// Pictures in the formats of glTF and its extensions: PNG, JPEG, WebP, AVIF.

#include <cstdint>
#include <span>
#include <string>

#include "scene/gltf/fault.h"
#include "scene/scene.h"

namespace crsh::scene {

/// A file of pictures in a format that is not read here.
class FormatFault : public Fault {
 public:
  using Fault::Fault;
};

struct ImageSize {
  uint32_t width = 0, height = 0;
  [[nodiscard]] uint64_t texels() const { return uint64_t{width} * height; }
};

struct DecodedImage {
  Image image;
  std::string remark;  ///< what is wrong with a file that can be drawn all the same ("is cut short"), else empty
};

/// The size that a picture's head tells; nothing is unpacked. Its content says of which format it is. A Fault where
/// that is none of ours (a FormatFault), where the head is broken, or where there are more texels than 8192 x 8192 or
/// than so few bytes can hold.
[[nodiscard]] ImageSize image_size(std::span<const uint8_t> bytes);

/// The picture as RGBA8: 16 bits are rounded to 8, alpha is straight. Colour profiles, gAMA and orientation are ignored
/// (glTF 2.0, section 3.8.3): texels are taken as they are stored. A Fault where image_size() has one, or where it
/// cannot be decoded. Takes up to 12 bytes a texel, the picture's own 4 included. May run on any thread.
[[nodiscard]] DecodedImage decode_image(std::span<const uint8_t> bytes);

}  // namespace crsh::scene
