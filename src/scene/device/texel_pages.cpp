#include "scene/device/texel_pages.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>
#include <optional>

#include "scene/device/mip_levels.h"

namespace crsh::scene {
namespace {

struct Size {
  uint32_t width = 0, height = 0;
  bool mips = false;
  uint32_t halvings = 0;

  [[nodiscard]] uint64_t texels() const {
    uint64_t sum = 0;
    for (const Size& level : levels()) sum += uint64_t(level.width) * level.height;
    return sum;
  }
  [[nodiscard]] std::vector<Size> levels() const {
    std::vector<Size> all = {*this};
    for (uint32_t left = mips ? levels_below(width, height) : 0; left > 0; --left)
      all.push_back({halved(all.back().width), halved(all.back().height)});
    return all;
  }
  void halve() {
    width = halved(width);
    height = halved(height);
    ++halvings;
  }
};

/// The levels of a picture that begins at `first`.
std::vector<Placement> placed(const Size& size, uint32_t page, uint32_t first) {
  std::vector<Placement> out;
  for (const Size& level : size.levels()) {
    out.push_back({page, first, level.width, level.height});
    first += level.width * level.height;
  }
  return out;
}

/// Places pictures, the largest first, each in the first page that has room. Nothing where one fits into no page.
std::optional<std::vector<std::vector<Placement>>> place(const std::vector<Size>& sizes, uint64_t page_texels) {
  std::vector<size_t> order(sizes.size());
  std::iota(order.begin(), order.end(), size_t(0));
  std::stable_sort(order.begin(), order.end(),
                   [&](size_t a, size_t b) { return sizes[a].texels() > sizes[b].texels(); });
  std::array<uint64_t, texel_page_count> filled{};
  std::vector<std::vector<Placement>> placements(sizes.size());
  for (const size_t i : order) {
    const uint64_t texels = sizes[i].texels();
    if (texels == 0) continue;
    const auto page = std::find_if(filled.begin(), filled.end(), [&](uint64_t f) { return f + texels <= page_texels; });
    if (page == filled.end()) return std::nullopt;
    placements[i] = placed(sizes[i], uint32_t(page - filled.begin()), uint32_t(*page));
    *page += texels;
  }
  return placements;
}

void write(const Image& image, const Placement& at, TexelPages& out) {
  std::vector<uint32_t>& page = out.pages[at.page];
  const size_t texels = size_t(at.width) * at.height;
  if (page.size() < at.first + texels) page.resize(at.first + texels);
  for (size_t i = 0; i < texels; ++i) {
    const uint8_t* rgba = &image.rgba[i * 4];
    page[at.first + i] = uint32_t(rgba[0]) | uint32_t(rgba[1]) << 8 | uint32_t(rgba[2]) << 16 | uint32_t(rgba[3]) << 24;
  }
}

/// Writes a picture, after as many halvings as its size has had.
void write_levels(const Image& whole, const Picture& picture, const Size& size,
                  const std::vector<Placement>& placements, TexelPages& out) {
  Image smaller;
  for (uint32_t n = 0; n < size.halvings; ++n) smaller = next_level(n == 0 ? whole : smaller, picture.srgb);
  write(size.halvings ? smaller : whole, placements[0], out);
  for (size_t level = 1; level < placements.size(); ++level) {
    smaller = next_level(level == 1 && !size.halvings ? whole : smaller, picture.srgb);
    write(smaller, placements[level], out);
  }
}

}  // namespace

TexelPages pack_texels(const std::vector<Image>& images, std::span<const Picture> pictures, uint64_t page_texels) {
  std::vector<Size> sizes;
  for (const Picture& picture : pictures)
    sizes.push_back({images[picture.image].width, images[picture.image].height, picture.mips});
  TexelPages out;
  std::optional<std::vector<std::vector<Placement>>> placements;
  while (!(placements = place(sizes, page_texels)))
    std::max_element(sizes.begin(), sizes.end(), [](const Size& a, const Size& b) {
      return a.texels() < b.texels();
    })->halve();
  out.placements = std::move(*placements);
  for (size_t i = 0; i < pictures.size(); ++i) {
    if (out.placements[i].empty()) continue;
    const Image& whole = images[pictures[i].image];
    write_levels(whole, pictures[i], sizes[i], out.placements[i], out);
    if (sizes[i].halvings)
      out.notes.push_back(fmt::format("image {} is used at {}x{} instead of {}x{}: the textures do not fit the device",
                                      pictures[i].image, sizes[i].width, sizes[i].height, whole.width, whole.height));
  }
  return out;
}

}  // namespace crsh::scene
