#pragma once
// All images of a scene in a few storage buffers, because not every device can choose another texture in each lane.

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "scene/scene.h"

namespace crsh::scene {

inline constexpr size_t texel_page_count = 4;

/// An image as it is packed: alone, or with all its smaller levels behind it.
struct Picture {
  uint32_t image = 0;
  bool srgb = false;  ///< how its levels are averaged
  bool mips = false;
  auto operator<=>(const Picture&) const = default;
};

/// Where a level's texels are: rows from the top, a word of RGBA8 each.
struct Placement {
  uint32_t page = 0, first = 0, width = 1, height = 1;
};

struct TexelPages {
  std::array<std::vector<uint32_t>, texel_page_count> pages;
  std::vector<std::vector<Placement>> placements;  ///< of each picture: its levels, the largest first
  std::vector<std::string> notes;                  ///< what had to be made smaller, a line each
};

/// Packs the pictures into pages of at most `page_texels`; where they don't fit, the largest are halved until they do.
[[nodiscard]] TexelPages pack_texels(const std::vector<Image>& images, std::span<const Picture> pictures,
                                     uint64_t page_texels);

}  // namespace crsh::scene
