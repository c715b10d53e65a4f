#pragma once
// The table of shaders that the build makes (tools/cmake/shaders.cmake).

#include <cstdint>
#include <string_view>

namespace crsh::gpu {

/// SPIR-V words from `first` to before `end`.
struct EmbeddedFile {
  std::string_view name;
  const uint32_t *first, *end;
};

/// Ends with an empty name.
extern const EmbeddedFile embedded_table[];

}  // namespace crsh::gpu
