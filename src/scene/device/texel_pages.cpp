#include "scene/device/texel_pages.h"

#include <fmt/format.h>

#include <algorithm>
#include <numeric>

namespace crsh::scene {
namespace {

struct Size {
  uint32_t width = 0, height = 0;
  uint32_t halvings = 0;
  [[nodiscard]] uint64_t texels() const { return uint64_t(width) * height; }
  void halve() {
    width = std::max(width / 2, 1u);
    height = std::max(height / 2, 1u);
    ++halvings;
  }
};

/// The image at half its size; each texel is the mean of four.
Image halved(const Image& image) {
  Image half{std::max(image.width / 2, 1u), std::max(image.height / 2, 1u), {}};
  half.rgba.resize(size_t(half.width) * half.height * 4);
  for (size_t i = 0; i < half.rgba.size(); ++i) {
    const uint32_t x = uint32_t(i / 4 % half.width), y = uint32_t(i / 4 / half.width);
    uint32_t sum = 2;
    for (uint32_t corner = 0; corner < 4; ++corner) {
      const uint32_t from_x = std::min(2 * x + corner % 2, image.width - 1);
      const uint32_t from_y = std::min(2 * y + corner / 2, image.height - 1);
      sum += image.rgba[(size_t(from_y) * image.width + from_x) * 4 + i % 4];
    }
    half.rgba[i] = uint8_t(sum / 4);
  }
  return half;
}

/// Places images, the largest first, each in the first page that has room. Nothing where one fits into no page.
std::optional<std::vector<std::optional<Placement>>> place(const std::vector<Size>& sizes, uint64_t page_texels) {
  std::vector<size_t> order(sizes.size());
  std::iota(order.begin(), order.end(), size_t(0));
  std::stable_sort(order.begin(), order.end(),
                   [&](size_t a, size_t b) { return sizes[a].texels() > sizes[b].texels(); });
  std::array<uint64_t, texel_page_count> filled{};
  std::vector<std::optional<Placement>> placements(sizes.size());
  for (const size_t i : order) {
    const uint64_t texels = sizes[i].texels();
    if (texels == 0) continue;
    const auto page = std::find_if(filled.begin(), filled.end(), [&](uint64_t f) { return f + texels <= page_texels; });
    if (page == filled.end()) return std::nullopt;
    placements[i] = Placement{uint32_t(page - filled.begin()), uint32_t(*page), sizes[i].width, sizes[i].height};
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

}  // namespace

TexelPages pack_texels(const std::vector<Image>& images, const std::vector<bool>& used, uint64_t page_texels) {
  std::vector<Size> sizes(images.size());
  for (size_t i = 0; i < images.size(); ++i)
    if (used[i]) sizes[i] = {images[i].width, images[i].height, 0};
  TexelPages out;
  std::optional<std::vector<std::optional<Placement>>> placements;
  while (!(placements = place(sizes, page_texels)))
    std::max_element(sizes.begin(), sizes.end(), [](const Size& a, const Size& b) {
      return a.texels() < b.texels();
    })->halve();
  out.placements = std::move(*placements);
  for (size_t i = 0; i < images.size(); ++i) {
    if (!out.placements[i]) continue;
    Image smaller;
    for (uint32_t n = 0; n < sizes[i].halvings; ++n) smaller = halved(n == 0 ? images[i] : smaller);
    write(sizes[i].halvings ? smaller : images[i], *out.placements[i], out);
    if (sizes[i].halvings)
      out.notes.push_back(fmt::format("image {} is used at {}x{} instead of {}x{}: the textures do not fit the device",
                                      i, sizes[i].width, sizes[i].height, images[i].width, images[i].height));
  }
  return out;
}

}  // namespace crsh::scene
