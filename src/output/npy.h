#pragma once
// Arrays as NumPy stores them, one a .npy file: a line that says type and shape, then the values.

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace crsh::output {

/// 'f': real numbers, 'i' and 'u': whole ones with and without a sign, 'b': true and false, 'S' and 'U': words of up to
/// so many bytes, with one or four a letter, filled up with zeros.
struct NpyType {
  char kind = 'f';
  uint32_t bytes = 4;
  [[nodiscard]] bool operator==(const NpyType&) const = default;
};

struct NpyArray {
  NpyType type;
  std::vector<uint64_t> shape;
  bool columns_first = false;  ///< NumPy's Fortran order: the first index runs fastest
  std::string values;          ///< little-endian
  [[nodiscard]] uint64_t size() const;
  /// "float32 (100, 3)", as NumPy would say.
  [[nodiscard]] std::string description() const;
};

[[nodiscard]] std::string encode_npy(const NpyArray& array);

/// Versions 1 to 3 of the format; types of NpyType, little-endian, numbers with 1 to 8 bytes. Throws UserError that
/// begins with `name`.
[[nodiscard]] NpyArray decode_npy(std::string bytes, const std::string& name);

}  // namespace crsh::output
