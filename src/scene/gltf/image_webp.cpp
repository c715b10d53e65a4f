// WebP, by libwebp (EXT_texture_webp).

#include <webp/decode.h>
#include <cstring>

#include "scene/gltf/image_format.h"

namespace crsh::scene {

namespace {

bool is_webp(std::span<const uint8_t> bytes) {
  return bytes.size() >= 12 && std::memcmp(bytes.data(), "RIFF", 4) == 0 && std::memcmp(&bytes[8], "WEBP", 4) == 0;
}

[[noreturn]] void refuse(VP8StatusCode status) {
  const bool cut = status == VP8_STATUS_NOT_ENOUGH_DATA || status == VP8_STATUS_SUSPENDED;
  throw Fault(cut ? "is cut short" : "cannot be decoded");
}

WebPBitstreamFeatures features_of(std::span<const uint8_t> bytes) {
  WebPBitstreamFeatures features;
  const VP8StatusCode status = WebPGetFeatures(bytes.data(), bytes.size(), &features);
  if (status != VP8_STATUS_OK) refuse(status);
  if (features.has_animation) throw Fault("is an animation");
  return features;
}

ImageSize webp_size(std::span<const uint8_t> bytes) {
  const WebPBitstreamFeatures features = features_of(bytes);
  return {static_cast<uint32_t>(features.width), static_cast<uint32_t>(features.height)};
}

/// MODE_RGBA is straight alpha. A file that is cut short is not drawn, as with PNG.
std::string decode_webp(std::span<const uint8_t> bytes, ImageSize size, std::span<uint8_t> rgba) {
  WebPDecoderConfig config;
  if (!WebPInitDecoderConfig(&config)) throw Fault("cannot be decoded");
  config.input = features_of(bytes);
  config.output.colorspace = MODE_RGBA;
  config.output.is_external_memory = 1;
  config.output.u.RGBA = {rgba.data(), static_cast<int>(size.width * 4), rgba.size()};
  const VP8StatusCode status = WebPDecode(bytes.data(), bytes.size(), &config);
  WebPFreeDecBuffer(&config.output);
  if (status != VP8_STATUS_OK) refuse(status);
  return {};
}

}  // namespace

const ImageFormat webp_format = {is_webp, webp_size, decode_webp, 0};  // one colour takes no bits at all

}  // namespace crsh::scene
