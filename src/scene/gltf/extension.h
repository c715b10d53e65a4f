#pragma once
// An extension's object, as tinygltf keeps it, read field by field.

#include <tiny_gltf.h>
#include <array>
#include <functional>
#include <optional>
#include <string>

#include "scene/gltf/checked.h"

namespace crsh::scene {

/// Types were checked before (shape.h): a field that is missing gives nothing or the default.
class Extension {
 public:
  /// The extension of this name that an object at `where` has, if it has.
  [[nodiscard]] static std::optional<Extension> of(const tinygltf::ExtensionMap& all, const std::string& name,
                                                   const std::string& where);

  [[nodiscard]] const std::string& where() const { return where_; }
  [[nodiscard]] std::string name_of(const std::string& key) const { return where_ + "." + key; }
  [[nodiscard]] bool has(const std::string& key) const { return value().Has(key); }

  [[nodiscard]] std::optional<float> number(const std::string& key) const;
  [[nodiscard]] float number(const std::string& key, float otherwise) const { return number(key).value_or(otherwise); }
  template <size_t N>
  [[nodiscard]] std::optional<std::array<float, N>> numbers(const std::string& key) const {
    const tinygltf::Value& list = value().Get(key);
    if (!list.IsArray() || list.ArrayLen() != N) return {};
    std::array<float, N> out;
    for (size_t i = 0; i < N; ++i) out[i] = finite(list.Get(static_cast<int>(i)).GetNumberAsDouble(), name_of(key));
    return out;
  }
  [[nodiscard]] bool flag(const std::string& key, bool otherwise) const;
  /// How many elements a list has; 0 where it is missing.
  [[nodiscard]] size_t count(const std::string& key) const;
  /// Element i of a list of places in another.
  [[nodiscard]] int index(const std::string& key, size_t i) const;
  /// A place in a list, or -1.
  [[nodiscard]] int index(const std::string& key) const;
  [[nodiscard]] std::string text(const std::string& key) const;
  [[nodiscard]] std::optional<Extension> object(const std::string& key) const;
  /// Element `index` of an array of objects; a Fault that names `key` and the index where there is none.
  [[nodiscard]] Extension element(const std::string& key, int index) const;

 private:
  Extension(const tinygltf::Value& value, std::string where) : value_(value), where_(std::move(where)) {}
  [[nodiscard]] const tinygltf::Value& value() const { return value_.get(); }

  std::reference_wrapper<const tinygltf::Value> value_;
  std::string where_;
};

}  // namespace crsh::scene
