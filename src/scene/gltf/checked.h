#pragma once
// Reads of tinygltf's lists and numbers that name what is wrong with them.

#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "scene/gltf/fault.h"

namespace crsh::scene {

/// "meshes[2]": how messages call element `index` of the file's list `name`.
[[nodiscard]] inline std::string place(std::string_view name, int64_t index) {
  return std::string(name) + "[" + std::to_string(index) + "]";
}

/// Element `index` of the file's list `name`; a Fault that names both where there is none.
template <class T>
[[nodiscard]] const T& at(const std::vector<T>& list, int64_t index, std::string_view name) {
  if (index < 0 || static_cast<uint64_t>(index) >= list.size())
    throw Fault(place(name, index) + " is referred to but is not in the file");
  return list[static_cast<size_t>(index)];
}

/// The number as a float; a Fault that names it where it is none.
[[nodiscard]] inline float finite(double value, const std::string& name) {
  const auto number = static_cast<float>(value);
  if (!std::isfinite(number)) throw Fault(name + " is not a finite number");
  return number;
}

}  // namespace crsh::scene
