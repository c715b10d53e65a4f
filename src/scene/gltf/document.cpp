#include "scene/gltf/document.h"

#include <cstdio>
#include <nlohmann/json.hpp>
#include <utility>

#include "scene/gltf/fault.h"

namespace crsh::scene {

namespace {

using nlohmann::json;
constexpr uint32_t glb_magic = 0x46546C67, json_chunk = 0x4E4F534A, binary_chunk = 0x004E4942;

uint32_t word_at(std::span<const uint8_t> bytes, size_t offset) {
  return bytes[offset] | uint32_t{bytes[offset + 1]} << 8u | uint32_t{bytes[offset + 2]} << 16u |
         uint32_t{bytes[offset + 3]} << 24u;
}

struct Container {
  std::span<const uint8_t> text;
  std::optional<std::span<const uint8_t>> binary;
};

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

std::unique_ptr<json> parse(std::span<const uint8_t> text) {
  while (!text.empty() && text.back() == 0) text = text.first(text.size() - 1);  // some exporters pad with zeros
  try {
    return std::make_unique<json>(json::parse(text.begin(), text.end()));
  } catch (const json::parse_error& error) {
    throw Fault("is no glTF: its JSON is broken at byte " + std::to_string(error.byte), "give a .gltf or .glb file");
  } catch (const json::exception&) {
    throw Fault("is no glTF: its JSON is broken", "give a .gltf or .glb file");
  }
}

/// "2.0" → 2, 0; anything else is refused.
std::pair<unsigned, unsigned> version_of(const std::string& text) {
  unsigned major = 0, minor = 0;
  char rest = 0;
  if (text.size() > 6 || std::sscanf(text.c_str(), "%u.%u%c", &major, &minor, &rest) != 2)
    throw Fault("its glTF version is " + in_quotes(text, 20), "convert it to glTF 2.0");
  return {major, minor};
}

void check_version(const Fields& root) {
  const std::optional<Fields> asset = root.object("asset");
  if (!asset) throw Fault("is no glTF: 'asset' is missing", "give a .gltf or .glb file");
  const auto version = version_of(asset->text("version"));
  const std::string& least = asset->text("minVersion");
  if (version.first != 2 || (!least.empty() && version_of(least) > std::pair(2u, 0u)))
    throw Fault("needs glTF " + printable(least.empty() ? asset->text("version") : least, 20),
                "convert it to glTF 2.0");
}

}  // namespace

Document::Document(const std::filesystem::path& path, uint64_t most_work)
    : folder_(path.parent_path()), work_left_(most_work) {
  const Bytes bytes = read_file(path);
  if (bytes.empty()) throw Fault("is empty", "give a .gltf or .glb file");
  if (bytes.size() >= 4 && word_at(bytes, 0) == glb_magic) {
    const Container container = split_glb(bytes);
    json_ = parse(container.text);
    if (container.binary) binary_.emplace(container.binary->begin(), container.binary->end());
  } else {
    json_ = parse(bytes);
  }
  check_version(root());
}

Document::~Document() = default;

Fields Document::root() const { return {*json_, ""}; }

Bytes Document::read_buffer(const Fields& fields, uint64_t index, uint64_t length) const {
  const std::string& uri = fields.text("uri");
  if (!uri.empty()) return read_uri(uri, folder_, length);
  if (index == 0 && binary_) return *binary_;
  throw Fault(fields.where() + " has no data");
}

std::span<const uint8_t> Document::buffer(uint64_t index) {
  const Fields fields = root().element("buffers", index);
  const uint64_t length = fields.needed_whole("byteLength");
  auto found = buffers_.find(index);
  if (found == buffers_.end()) found = buffers_.emplace(index, read_buffer(fields, index, length)).first;
  if (found->second.size() < length)
    throw Fault(fields.where() + " is cut short: " + std::to_string(found->second.size()) + " of " +
                    std::to_string(length) + " bytes",
                "copy or export it again");
  return std::span(found->second).first(length);
}

std::span<const uint8_t> Document::view(uint64_t index) {
  const Fields fields = root().element("bufferViews", index);
  const std::span<const uint8_t> whole = buffer(fields.needed_whole("buffer"));
  const uint64_t offset = fields.whole("byteOffset", 0), length = fields.needed_whole("byteLength");
  if (offset + length > whole.size()) throw Fault(fields.where() + " reaches past the end of its buffer");
  return whole.subspan(offset, length);
}

void Document::spend(uint64_t elements) {
  if (elements > work_left_) throw Fault("is too large to be drawn", "simplify the scene");
  work_left_ -= elements;
}

}  // namespace crsh::scene
