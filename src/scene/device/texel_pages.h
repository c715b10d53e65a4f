#pragma once
// All images of a scene in a few storage buffers, because not every device can choose another texture in each lane.

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "scene/scene.h"

namespace crsh::scene {

inline constexpr size_t texel_page_count = 4;

/// Where an image's texels are: rows from the top, a word of RGBA8 each.
struct Placement {
  uint32_t page = 0, first = 0, width = 1, height = 1;
};

struct TexelPages {
  std::array<std::vector<uint32_t>, texel_page_count> pages;
  std::vector<std::optional<Placement>> placements;  ///< by image; none where it is not used
  std::vector<std::string> notes;                    ///< what had to be made smaller, a line each
};

/// Packs the used images into pages of at most `page_texels`; where they don't fit, the largest are halved until they
/// do.
[[nodiscard]] TexelPages pack_texels(const std::vector<Image>& images, const std::vector<bool>& used,
                                     uint64_t page_texels);

}  // namespace crsh::scene
