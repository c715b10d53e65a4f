#pragma once
// Decodes pictures on all cores.

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "scene/gltf/image.h"
#include "scene/gltf/parallel.h"

namespace crsh::scene {

struct EncodedImage {
  std::span<const uint8_t> bytes;
  ImageSize size;  ///< what image_size() said of them
};

/// One picture, or why there is none.
struct Decoding {
  std::optional<DecodedImage> picture;
  std::string fault;
};

/// Decodes each; the results are in the same order, and the same on any number of threads. Beside the pictures
/// themselves, decoders hold 1 GiB at most, or what one picture takes.
[[nodiscard]] std::vector<Decoding> decode_images(std::span<const EncodedImage> images,
                                                  unsigned threads = threads_here());

}  // namespace crsh::scene
