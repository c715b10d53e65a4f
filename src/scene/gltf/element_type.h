#pragma once
// What the elements of an accessor are.

#include <cstdint>

namespace crsh::scene {

/// glTF 2.0, section 3.6.2.2.
enum class Component : uint32_t { i8 = 5120, u8 = 5121, i16 = 5122, u16 = 5123, u32 = 5125, f32 = 5126 };

/// What one element of an accessor is.
struct ElementType {
  uint32_t components = 1;
  Component component = Component::f32;
};

}  // namespace crsh::scene
