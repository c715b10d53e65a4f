#include "scene/gltf/document.h"

#include <utility>

#include "scene/gltf/checked.h"
#include "scene/gltf/container.h"
#include "scene/gltf/fault.h"
#include "scene/gltf/json.h"
#include "scene/gltf/tiny_model.h"

namespace crsh::scene {

namespace {

/// Fills `names` on the way.
Prepared prepared_json(std::span<const uint8_t> text, bool lenient, ExtensionNames& names) {
  nlohmann::json root = parse_json(text);
  check_version(root);
  names = extensions_in(root);
  if (!lenient) check_required(names);
  return prepare(std::move(root));
}

/// Gives the model back what prepare() kept from tinygltf.
void restore(tinygltf::Model& model, const Prepared& prepared) {
  for (const uint64_t index : prepared.bare) model.accessors[index].bufferView = -1;
  model.bufferViews.resize(prepared.strides.size());
  for (size_t i = 0; i < prepared.strides.size(); ++i) model.bufferViews[i].byteStride = prepared.strides[i];
}

}  // namespace

Document::Document(const std::filesystem::path& path, Reach reach, uint64_t max_work, bool lenient)
    : folder_(path.parent_path()), reach_(reach), work_left_(max_work) {
  const Bytes bytes = read_file(path);
  const Container container = open_container(bytes);
  Prepared prepared = prepared_json(container.text, lenient, extensions_);
  model_ = tiny_model(prepared.text);
  restore(model_, prepared);
  sources_ = std::move(prepared.buffers);
  images_ = std::move(prepared.images);
  compressed_ = std::move(prepared.compressed);
  broken_ = std::move(prepared.broken);
  if (container.binary) binary_.emplace(container.binary->begin(), container.binary->end());
}

Bytes Document::read(const std::string& uri) const { return read_uri(uri, folder_, reach_); }

Bytes Document::read_buffer(const BufferSource& source, int64_t index) const {
  if (!source.uri.empty()) return read_uri(source.uri, folder_, reach_, *source.length);
  if (index == 0 && binary_) return *binary_;
  throw Fault(place("buffers", index) + " has no data");
}

std::span<const uint8_t> Document::buffer(int64_t index) {
  const BufferSource& source = at(sources_, index, "buffers");
  const std::string where = place("buffers", index);
  if (!source.length) throw Fault(where + ".byteLength is missing");
  auto found = buffers_.find(index);
  if (found == buffers_.end()) found = buffers_.emplace(index, read_buffer(source, index)).first;
  if (found->second.size() < *source.length)
    throw Fault(where + " is cut short: " + std::to_string(found->second.size()) + " of " +
                    std::to_string(*source.length) + " bytes",
                "copy or export it again");
  return std::span(found->second).first(*source.length);
}

std::span<const uint8_t> Document::view(int64_t index) {
  const tinygltf::BufferView& view = at(model_.bufferViews, index, "bufferViews");
  const auto compressed = compressed_.find(index);
  if (compressed != compressed_.end()) {
    try {
      return decompress(index, compressed->second);
    } catch (const Fault&) {
      if (!has_own_data(view.buffer)) throw;  // else it has the same once more, uncompressed
    }
  }
  return part(view.buffer, view.byteOffset, view.byteLength, place("bufferViews", index));
}

std::span<const uint8_t> Document::part(int64_t of_buffer, uint64_t offset, uint64_t length, const std::string& where) {
  const std::span<const uint8_t> whole = buffer(of_buffer);
  if (offset + length > whole.size()) throw Fault(where + " reaches past the end of its buffer");
  return whole.subspan(offset, length);
}

std::span<const uint8_t> Document::decompress(int64_t index, const CompressedView& view) {
  const auto found = decompressed_.find(index);
  if (found != decompressed_.end()) return found->second;
  const std::string where = place("bufferViews", index);
  spend(checked_size(view, where) / sizeof(float));
  return decompressed_[index] = decompressed(view, part(view.buffer, view.offset, view.length, where), where);
}

bool Document::has_own_data(int64_t buffer) const {
  return buffer >= 0 && static_cast<uint64_t>(buffer) < sources_.size() &&
         !sources_[static_cast<size_t>(buffer)].uri.empty();
}

const Decoded* Document::decoded(int64_t accessor) const {
  const auto found = decoded_.find(accessor);
  return found == decoded_.end() ? nullptr : &found->second;
}

const ImageSource& Document::image(int64_t index) const { return at(images_, index, "images"); }

void Document::check(const std::string& where) const {
  const auto found = broken_.find(where);
  if (found != broken_.end()) throw Fault(found->second);
}

void Document::spend(uint64_t elements) {
  if (elements > work_left_) throw LimitFault();
  work_left_ -= elements;
}

}  // namespace crsh::scene
