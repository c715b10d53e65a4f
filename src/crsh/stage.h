#pragma once
// The stages of a frame that are timed.

#include <array>
#include <cstddef>
#include <cstdint>
#include <string_view>

namespace crsh {

/// The rows of the paper's Table 3, and besides the raster pass, shading and the object hierarchy.
enum class Stage : uint32_t {
  raster,
  ray_creation,
  ray_compression,
  ray_sorting,
  ray_decompression,
  hierarchy_creation,
  hierarchy_traversal,
  final_intersection,
  shading,
  object_hierarchy
};
inline constexpr size_t stage_count = 10;

/// Their names in statistics, report and viewer, by Stage.
inline constexpr std::array<std::string_view, stage_count> stage_names = {"raster",
                                                                          "ray creation",
                                                                          "ray compression",
                                                                          "ray sorting",
                                                                          "ray decompression",
                                                                          "hierarchy creation",
                                                                          "hierarchy traversal",
                                                                          "final intersection",
                                                                          "shading",
                                                                          "object hierarchy"};

}  // namespace crsh
