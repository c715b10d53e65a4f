#pragma once
// A JSON object of a glTF file, read field by field with every type and range checked.

#include <array>
#include <cstdint>
#include <functional>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

namespace crsh::scene {

/// One object of the file and where it stands there ("meshes[2].primitives[0]"), for messages.
/// A field that is missing gives nothing or the default; one of the wrong type throws a Fault that names it.
class Fields {
 public:
  Fields(const nlohmann::json& object, std::string where);

  [[nodiscard]] const std::string& where() const { return where_; }
  /// The field's full name, for messages.
  [[nodiscard]] std::string name_of(const char* key) const;
  [[nodiscard]] bool has(const char* key) const { return find(key) != nullptr; }

  /// A whole number from 0 to 2^40 (1.0 counts as whole).
  [[nodiscard]] std::optional<uint64_t> whole(const char* key) const;
  [[nodiscard]] uint64_t whole(const char* key, uint64_t otherwise) const { return whole(key).value_or(otherwise); }
  [[nodiscard]] uint64_t needed_whole(const char* key) const;
  /// A finite number.
  [[nodiscard]] std::optional<float> number(const char* key) const;
  [[nodiscard]] float number(const char* key, float otherwise) const { return number(key).value_or(otherwise); }
  [[nodiscard]] float needed_number(const char* key) const;
  /// Exactly N finite numbers.
  template <size_t N>
  [[nodiscard]] std::optional<std::array<float, N>> numbers(const char* key) const {
    std::array<float, N> out{};
    return fill(key, out.data(), N) ? std::optional(out) : std::nullopt;
  }
  [[nodiscard]] bool flag(const char* key, bool otherwise) const;
  /// The text of a field, empty where it is missing. Never copied: some are whole buffers.
  [[nodiscard]] const std::string& text(const char* key) const;
  [[nodiscard]] std::vector<std::string> texts(const char* key) const;
  [[nodiscard]] std::vector<uint64_t> wholes(const char* key) const;
  [[nodiscard]] std::optional<Fields> object(const char* key) const;
  /// The object of an extension, where this object has it.
  [[nodiscard]] std::optional<Fields> extension(const char* name) const;
  /// How many elements the array has (0: no such array).
  [[nodiscard]] size_t size(const char* key) const;
  /// Element `index` of an array of objects; a Fault that names `key` and the index where there is none.
  [[nodiscard]] Fields element(const char* key, uint64_t index) const;

 private:
  [[nodiscard]] const nlohmann::json* find(const char* key) const;
  [[nodiscard]] const nlohmann::json* array(const char* key) const;
  bool fill(const char* key, float* out, size_t count) const;

  std::reference_wrapper<const nlohmann::json> object_;
  std::string where_;
};

}  // namespace crsh::scene
