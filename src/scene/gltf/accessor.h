#pragma once
// A glTF accessor: any component type, stride, normalisation and sparse substitution, read element by element.

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <initializer_list>
#include <span>

#include "scene/gltf/document.h"
#include "scene/gltf/element_type.h"

namespace crsh::scene {

/// As the file says. A Fault for a type that is none of glTF's, or that nothing here reads.
[[nodiscard]] ElementType element_type(const Document& document, int64_t index);

class Accessor {
 public:
  /// Checks that every element lies within its bufferView; a Fault where it does not.
  Accessor(Document& document, int64_t index);

  [[nodiscard]] const std::string& where() const { return where_; }
  [[nodiscard]] uint64_t count() const { return count_; }
  [[nodiscard]] uint32_t components() const { return components_; }
  [[nodiscard]] Component component() const { return component_; }

  /// Element i as floats, normalised integers decoded; components that it lacks are 0.
  [[nodiscard]] glm::vec4 at(uint64_t i) const;
  /// Element i of an unsigned integer scalar.
  [[nodiscard]] uint32_t integer_at(uint64_t i) const;
  /// The 16 floats of element i of a MAT4, column by column.
  [[nodiscard]] glm::mat4 matrix_at(uint64_t i) const;

  /// A Fault unless the type is one of `allowed` numbers of components.
  void need_components(std::initializer_list<uint32_t> allowed) const;
  /// A Fault unless this is an unsigned integer scalar.
  void need_indices() const;

 private:
  void read_dense(Document& document, const tinygltf::Accessor& from);
  void substitute(Document& document, const tinygltf::Accessor& from);
  void copy_tightly(Document& document);
  [[nodiscard]] const uint8_t* element(uint64_t i) const { return data_.data() + i * stride_; }
  [[nodiscard]] float value(const uint8_t* bytes) const;

  std::string where_;
  uint64_t count_ = 0, stride_ = 0;
  uint32_t components_ = 1, size_ = 0;  // size_: bytes of one element
  Component component_ = Component::f32;
  bool normalised_ = false;
  std::span<const uint8_t> data_;  // in the document's buffer or in owned_
  Bytes owned_;
};

}  // namespace crsh::scene
