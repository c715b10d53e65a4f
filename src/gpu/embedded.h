#pragma once
// The table of shaders that the build makes (tools/cmake/shaders.cmake).

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace crsh::gpu {

/// SPIR-V words from `first` to before `end`.
struct EmbeddedFile {
  std::string_view name;
  const uint32_t *first, *end;
};

/// Ends with an empty name.
extern const EmbeddedFile embedded_table[];

/// From here on these words stand for the embedded file. Pipelines that are there already stay as they are.
void replace_spirv(std::string_view file, std::vector<uint32_t> words);

/// Why these words cannot stand for the embedded file: other bindings, names or push constants than the program gives
/// it.
/// Empty: they can.
[[nodiscard]] std::string misfit(std::string_view file, std::span<const uint32_t> words);

}  // namespace crsh::gpu
