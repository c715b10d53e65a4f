// AVIF, by libavif (EXT_texture_avif).

#include <avif/avif.h>
#include <memory>

#include "scene/gltf/image_format.h"

namespace crsh::scene {

namespace {

void expect_ok(avifResult result) {
  if (result == AVIF_RESULT_OUT_OF_MEMORY) throw std::bad_alloc();
  if (result == AVIF_RESULT_TRUNCATED_DATA) throw Fault("is cut short");
  if (result != AVIF_RESULT_OK) throw Fault("cannot be decoded");
}

bool is_avif(std::span<const uint8_t> bytes) {
  const avifROData data{bytes.data(), bytes.size()};
  return avifPeekCompatibleFileType(&data) != 0;
}

using Decoder = std::unique_ptr<avifDecoder, decltype(&avifDecoderDestroy)>;

/// A decoder that has read the head.
Decoder opened(std::span<const uint8_t> bytes) {
  Decoder decoder(avifDecoderCreate(), avifDecoderDestroy);
  if (!decoder) throw std::bad_alloc();
  decoder->ignoreExif = decoder->ignoreXMP = AVIF_TRUE;
  decoder->strictFlags = AVIF_STRICT_DISABLED;  // as browsers do: old encoders left properties out
  decoder->imageSizeLimit = static_cast<uint32_t>(most_image_texels);
  decoder->maxThreads = 1;  // pictures are decoded beside each other
  expect_ok(avifDecoderSetIOMemory(decoder.get(), bytes.data(), bytes.size()));
  expect_ok(avifDecoderParse(decoder.get()));
  return decoder;
}

ImageSize avif_size(std::span<const uint8_t> bytes) {
  const Decoder decoder = opened(bytes);
  return {decoder->image->width, decoder->image->height};
}

/// The first picture of a sequence. Of a broken one dav1d tells stderr besides; libavif has no switch for that. Its
/// other decoders do not heed the size limit.
///
///  10 and 12 bits are rounded to 8; alpha that the colours are multiplied by is divided
/// out. Rotation and mirroring are ignored as orientation in other formats is.
std::string decode_avif(std::span<const uint8_t> bytes, ImageSize size, std::span<uint8_t> rgba) {
  const Decoder decoder = opened(bytes);
  expect_ok(avifDecoderNextImage(decoder.get()));
  if (decoder->image->width != size.width || decoder->image->height != size.height) throw Fault("cannot be decoded");
  avifRGBImage out{};
  avifRGBImageSetDefaults(&out, decoder->image);
  out.format = AVIF_RGB_FORMAT_RGBA;
  out.depth = 8;
  out.pixels = rgba.data();
  out.rowBytes = size.width * 4;
  expect_ok(avifImageYUVToRGB(decoder->image, &out));
  return {};
}

}  // namespace

const ImageFormat avif_format = {is_avif, avif_size, decode_avif, 0};

}  // namespace crsh::scene
