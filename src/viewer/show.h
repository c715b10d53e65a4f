#pragma once
// The ways of looking at a picture: its light, how its rays are sorted, or one of its layers in colours.

#include <cstdint>
#include <string_view>
#include <vector>

#include "crsh/layers.h"
#include "crsh/picture.h"

namespace crsh::viewer {

/// Rows of show_table: these, then every layer that says how it is painted (crsh/layers.h).
enum class Show : uint32_t { light, tests, order };

struct ShowRow {
  std::string_view name, help;
  LayerSet layers = {};  ///< that it needs
  Paint paint = Paint::nothing;
};

/// By Show.
[[nodiscard]] const std::vector<ShowRow>& show_table();
[[nodiscard]] inline const ShowRow& row_of(Show show) { return show_table()[static_cast<size_t>(show)]; }
/// Whether it is shown on the heat scale.
[[nodiscard]] bool is_heat(Show show);

/// RGBA bytes, rows from the top.
struct Pixels {
  uint32_t width = 0, height = 0;
  std::vector<uint8_t> rgba;
};

/// The greatest value of a heat scale that suits this picture; 0 where it has no such layers.
[[nodiscard]] double heat_end(const Picture& picture, Show show);
/// The picture in colours; black where it lacks the layer. `exposure`, in stops, is for light; `heat` is the greatest
/// value of the heat scale.
[[nodiscard]] Pixels in_colours(const Picture& picture, Show show, double exposure, double heat);

}  // namespace crsh::viewer
