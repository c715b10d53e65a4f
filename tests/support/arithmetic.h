#pragma once
// How the device rounds. Vulkan asks for correctly rounded sums and products, but a division may be off by 2.5 units in
// the last place, a square root by more, and numbers below the normal ones may be zeros. So two devices may differ in
// the last bits of where a ray meets a triangle, though no two kernels of one device do.

#include <string>

namespace crsh::test {

struct Arithmetic {
  bool division = true, square_root = true;  ///< correctly rounded
  bool separate = true;                      ///< a product is rounded before it is added, where the shader says so
  bool subnormals = true;                    ///< kept

  /// Bit-for-bit twins in C++, and figures recorded with such arithmetic, hold.
  [[nodiscard]] bool is_ieee() const { return division && square_root && separate && subnormals; }
  /// "NAME divides inexactly, ...", for tests that then compare less.
  [[nodiscard]] std::string text() const;
};

/// That of the device that all tests share, tried once.
[[nodiscard]] const Arithmetic& arithmetic();

}  // namespace crsh::test
