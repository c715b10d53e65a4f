#include "scene/gltf/container.h"

#include <string>

#include "scene/gltf/fault.h"

namespace crsh::scene {

namespace {

constexpr uint32_t glb_magic = 0x46546C67, json_chunk = 0x4E4F534A, binary_chunk = 0x004E4942;

uint32_t word_at(std::span<const uint8_t> bytes, size_t offset) {
  return bytes[offset] | uint32_t{bytes[offset + 1]} << 8u | uint32_t{bytes[offset + 2]} << 16u |
         uint32_t{bytes[offset + 3]} << 24u;
}

/// Takes one chunk (length, type, content) off the front of `rest`.
std::span<const uint8_t> take_chunk(std::span<const uint8_t>& rest) {
  const uint32_t length = word_at(rest, 0);
  if (length > rest.size() - 8) throw Fault("is cut short", "copy or export it again");
  const std::span<const uint8_t> content = rest.subspan(8, length);
  rest = rest.subspan(8 + size_t{length});
  return content;
}

/// glTF 2.0, section 4.4: a header of 12 bytes, the JSON chunk, perhaps the binary one, others to be ignored.
Container split_glb(std::span<const uint8_t> bytes) {
  if (bytes.size() < 20) throw Fault("is cut short", "copy or export it again");
  if (word_at(bytes, 4) != 2)
    throw Fault("is a binary glTF of version " + std::to_string(word_at(bytes, 4)), "convert it to glTF 2.0");
  const uint32_t length = word_at(bytes, 8);
  if (length > bytes.size()) throw Fault("is cut short", "copy or export it again");
  if (length < 20) throw Fault("has a broken header");
  std::span<const uint8_t> rest = bytes.subspan(12, length - 12);
  if (word_at(rest, 4) != json_chunk) throw Fault("does not start with a JSON chunk");
  Container out{take_chunk(rest), std::nullopt};
  if (rest.size() >= 8 && word_at(rest, 4) == binary_chunk) out.binary = take_chunk(rest);
  return out;
}

}  // namespace

Container open_container(std::span<const uint8_t> bytes) {
  if (bytes.empty()) throw Fault("is empty", "give a .gltf or .glb file");
  const bool glb = bytes.size() >= 4 && word_at(bytes, 0) == glb_magic;
  return glb ? split_glb(bytes) : Container{bytes, std::nullopt};
}

}  // namespace crsh::scene
