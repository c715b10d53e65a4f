#include "scene/gltf/accessor.h"

#include <algorithm>
#include <cstring>
#include <glm/gtc/type_ptr.hpp>
#include <limits>

#include "scene/gltf/checked.h"
#include "scene/gltf/fault.h"

namespace crsh::scene {

namespace {

// An accessor without data stands for zeros: the one way to ask for much memory with few bytes.
constexpr uint64_t max_zeros = uint64_t{1} << 24u;
constexpr uint64_t longest_stride = 65535;

uint32_t components_of(int type, const std::string& where) {
  switch (type) {
    case TINYGLTF_TYPE_SCALAR: return 1;
    case TINYGLTF_TYPE_VEC2: return 2;
    case TINYGLTF_TYPE_VEC3: return 3;
    case TINYGLTF_TYPE_VEC4: return 4;
    case TINYGLTF_TYPE_MAT4: return 16;
    case TINYGLTF_TYPE_MAT2: throw Fault(where + ".type 'MAT2' is not known here");
    default: throw Fault(where + ".type 'MAT3' is not known here");
  }
}

Component component_of(int code, const std::string& where) {
  switch (code) {
    case TINYGLTF_COMPONENT_TYPE_BYTE:
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE:
    case TINYGLTF_COMPONENT_TYPE_SHORT:
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT:
    case TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT:
    case TINYGLTF_COMPONENT_TYPE_FLOAT: return static_cast<Component>(code);
    default: throw Fault(where + ".componentType " + std::to_string(code) + " is none of glTF's");
  }
}

uint32_t size_of(Component component) {
  switch (component) {
    case Component::i8:
    case Component::u8: return 1;
    case Component::i16:
    case Component::u16: return 2;
    default: return 4;
  }
}

template <class T>
T load_as(const uint8_t* bytes) {
  T out;
  std::memcpy(&out, bytes, sizeof out);
  return out;
}

uint32_t unsigned_at(const uint8_t* bytes, Component component) {
  switch (component) {
    case Component::u8: return *bytes;
    case Component::u16: return load_as<uint16_t>(bytes);
    default: return load_as<uint32_t>(bytes);
  }
}

/// glTF 2.0, section 3.11: c / max, signed ones not below -1.
template <class T>
float normalised(T c) {
  return std::max(static_cast<float>(c) / static_cast<float>(std::numeric_limits<T>::max()), -1.0f);
}

bool is_index_type(Component component) {
  return component == Component::u8 || component == Component::u16 || component == Component::u32;
}

/// `count` elements of `size` bytes, `stride` apart, from `offset` on: a Fault unless `view` holds them all.
std::span<const uint8_t> range(std::span<const uint8_t> view, uint64_t offset, uint64_t count, uint64_t stride,
                               uint64_t size, const std::string& where) {
  if (offset > view.size()) throw Fault(where + " starts past the end of its bufferView");
  if (count > 0 && (count - 1) * stride + size > view.size() - offset)
    throw Fault(where + " reaches past the end of its bufferView");
  return view.subspan(offset);
}

}  // namespace

ElementType element_type(const Document& document, int64_t index) {
  const tinygltf::Accessor& from = at(document.model().accessors, index, "accessors");
  const std::string where = place("accessors", index);
  return {components_of(from.type, where), component_of(from.componentType, where)};
}

Accessor::Accessor(Document& document, int64_t index) : where_(place("accessors", index)) {
  const tinygltf::Accessor& from = scene::at(document.model().accessors, index, "accessors");
  document.check(where_);
  const Decoded* decoded = document.decoded(index);
  const ElementType type = decoded ? decoded->type : element_type(document, index);
  count_ = decoded ? decoded->count : from.count;
  components_ = type.components;
  component_ = type.component;
  normalised_ = from.normalized;
  size_ = components_ * size_of(component_);
  if (decoded) {
    stride_ = size_;
    data_ = decoded->bytes;
    return;
  }
  read_dense(document, from);
  if (from.sparse.isSparse) substitute(document, from);
}

void Accessor::read_dense(Document& document, const tinygltf::Accessor& from) {
  stride_ = size_;
  if (from.bufferView >= 0) {
    const uint64_t stride = scene::at(document.model().bufferViews, from.bufferView, "bufferViews").byteStride;
    if (stride != 0) stride_ = stride;
    if (stride_ < size_ || stride_ > longest_stride)
      throw Fault(where_ + " does not fit the byteStride of its bufferView");
    data_ = range(document.view(from.bufferView), from.byteOffset, count_, stride_, size_, where_);
    return;
  }
  if (count_ > max_zeros) throw Fault(where_ + " has " + std::to_string(count_) + " elements but no data");
  document.spend(count_);
  owned_.resize(count_ * size_);
  data_ = owned_;
}

void Accessor::copy_tightly(Document& document) {
  if (!owned_.empty()) return;
  document.spend(count_);
  Bytes copy(count_ * size_);
  for (uint64_t i = 0; i < count_; ++i) std::memcpy(copy.data() + i * size_, element(i), size_);
  owned_ = std::move(copy);
  stride_ = size_;
  data_ = owned_;
}

void Accessor::substitute(Document& document, const tinygltf::Accessor& from) {
  const auto& indices = from.sparse.indices;
  const auto& values = from.sparse.values;
  const std::string where = where_ + ".sparse";
  const auto many = static_cast<uint64_t>(from.sparse.count);
  if (many > count_) throw Fault(where + " has more elements than " + where_);
  const Component type = component_of(indices.componentType, where + ".indices");
  if (!is_index_type(type)) throw Fault(where + ".indices.componentType is not an unsigned integer");
  const uint32_t step = size_of(type);
  const auto places = range(document.view(indices.bufferView), static_cast<uint64_t>(indices.byteOffset), many, step,
                            step, where + ".indices");
  const auto news = range(document.view(values.bufferView), static_cast<uint64_t>(values.byteOffset), many, size_,
                          size_, where + ".values");
  copy_tightly(document);
  for (uint64_t i = 0; i < many; ++i) {
    const uint32_t place = unsigned_at(places.data() + i * step, type);
    if (place >= count_) throw Fault(where + ".indices names an element that " + where_ + " does not have");
    std::memcpy(owned_.data() + place * size_, news.data() + i * size_, size_);
  }
}

float Accessor::value(const uint8_t* bytes) const {
  switch (component_) {
    case Component::i8: {
      const auto c = load_as<int8_t>(bytes);
      return normalised_ ? normalised(c) : static_cast<float>(c);
    }
    case Component::u8: return normalised_ ? normalised(*bytes) : static_cast<float>(*bytes);
    case Component::i16: {
      const auto c = load_as<int16_t>(bytes);
      return normalised_ ? normalised(c) : static_cast<float>(c);
    }
    case Component::u16: {
      const auto c = load_as<uint16_t>(bytes);
      return normalised_ ? normalised(c) : static_cast<float>(c);
    }
    case Component::u32: return static_cast<float>(load_as<uint32_t>(bytes));
    default: return load_as<float>(bytes);
  }
}

glm::vec4 Accessor::at(uint64_t i) const {
  glm::vec4 out{0};
  const uint32_t step = size_of(component_);
  const uint8_t* bytes = element(i);
  for (uint32_t c = 0; c < std::min(components_, 4u); ++c) out[static_cast<int>(c)] = value(bytes + c * step);
  return out;
}

uint32_t Accessor::integer_at(uint64_t i) const { return unsigned_at(element(i), component_); }

glm::mat4 Accessor::matrix_at(uint64_t i) const {
  float values[16] = {};
  const uint32_t step = size_of(component_);
  for (uint32_t c = 0; c < std::min(components_, 16u); ++c) values[c] = value(element(i) + c * step);
  return glm::make_mat4(values);
}

void Accessor::need_components(std::initializer_list<uint32_t> allowed) const {
  if (std::find(allowed.begin(), allowed.end(), components_) == allowed.end())
    throw Fault(where_ + " has the wrong type for its use");
}

void Accessor::need_indices() const {
  if (components_ != 1 || !is_index_type(component_) || normalised_)
    throw Fault(where_ + " is used as indices but does not hold unsigned whole numbers");
}

}  // namespace crsh::scene
