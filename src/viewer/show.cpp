#include "viewer/show.h"

#include <algorithm>
#include <cmath>

#include "output/heat_map.h"
#include "output/png.h"
#include "viewer/node_frame.h"

namespace crsh::viewer {
namespace {

/// srgb_byte by a table of 65,536 values, which is much finer than a byte even where the curve is steepest.
uint8_t quick_srgb(float linear) {
  static const std::vector<uint8_t> bytes = [] {
    std::vector<uint8_t> made(65536);
    for (size_t i = 0; i < made.size(); ++i) made[i] = output::srgb_byte(double(i) / 65535);
    return made;
  }();
  return bytes[static_cast<size_t>(linear > 0 ? std::min(linear, 1.0f) * 65535.0f + 0.5f : 0.0f)];
}

struct Colour {
  uint8_t r = 0, g = 0, b = 0;
};

/// A picture of the colours colour(pixel).
template <class Of>
Pixels paint(const Picture& picture, Of colour) {
  Pixels pixels{picture.width, picture.height, {}};
  const size_t count = size_t(picture.width) * picture.height;
  pixels.rgba.resize(4 * count);
  for (size_t p = 0; p < count; ++p) {
    const Colour c = colour(p);
    pixels.rgba[4 * p] = c.r, pixels.rgba[4 * p + 1] = c.g, pixels.rgba[4 * p + 2] = c.b, pixels.rgba[4 * p + 3] = 255;
  }
  return pixels;
}

Pixels black(const Picture& picture) {
  return paint(picture, [](size_t) { return Colour{}; });
}

Pixels light(const Picture& picture, double exposure) {
  const Layer& beauty = *picture.find("");
  const float scale = float(std::exp2(exposure));
  return paint(picture, [&](size_t p) {
    const float* c = &beauty.values[4 * p];
    return Colour{quick_srgb(c[0] * scale), quick_srgb(c[1] * scale), quick_srgb(c[2] * scale)};
  });
}

/// The one layer that a row shows; null where the picture lacks it, or the row shows something else.
const Layer* layer_of(const Picture& picture, Show show) {
  return row_of(show).paint == Paint::nothing ? nullptr
                                              : picture.find(picture_layer(row_of(show).layers.members().front()));
}

/// All tests, or those of one layer.
std::vector<float> tests_of(const Picture& picture, Show show) {
  if (show == Show::tests) return output::tests_of(picture);
  const Layer* layer = layer_of(picture, show);
  return layer ? layer->values : std::vector<float>();
}

Pixels heat(const Picture& picture, Show show, double end) {
  const std::vector<float> tests = tests_of(picture, show);
  if (tests.empty()) return black(picture);
  return paint(picture, [&](size_t p) {
    const auto rgb = output::heat_colour(double(tests[p]) / end);
    return Colour{rgb[0], rgb[1], rgb[2]};
  });
}

/// The order of rays on the heat scale, from the first to the last; grey where there is no ray.
Pixels order(const Picture& picture, const Layer& layer) {
  return paint(picture, [&](size_t p) {
    if (std::isnan(layer.values[p])) return Colour{24, 24, 26};
    const auto rgb = output::heat_colour(layer.values[p]);
    return Colour{rgb[0], rgb[1], rgb[2]};
  });
}

uint8_t byte_of(float share) { return static_cast<uint8_t>(std::clamp(share, 0.0f, 1.0f) * 255 + 0.5f); }

/// Each channel between its least and greatest value in the picture, where anything is.
Pixels extent(const Picture& picture, const Layer& layer) {
  float low[3] = {INFINITY, INFINITY, INFINITY}, high[3] = {-INFINITY, -INFINITY, -INFINITY};
  const auto is_hit = [&](size_t p) {
    return layer.values[3 * p] != 0 || layer.values[3 * p + 1] != 0 || layer.values[3 * p + 2] != 0;
  };
  for (size_t p = 0; p < layer.values.size() / 3; ++p)
    for (size_t c = 0; c < 3 && is_hit(p); ++c) {
      low[c] = std::min(low[c], layer.values[3 * p + c]);
      high[c] = std::max(high[c], layer.values[3 * p + c]);
    }
  return paint(picture, [&](size_t p) {
    if (!is_hit(p)) return Colour{};
    const auto share = [&](size_t c) {
      return byte_of((layer.values[3 * p + c] - low[c]) / std::max(high[c] - low[c], 1e-12f));
    };
    return Colour{share(0), share(1), share(2)};
  });
}

/// From -1 to 1; black where all are 0.
Pixels vector(const Picture& picture, const Layer& layer) {
  return paint(picture, [&](size_t p) {
    const float* n = &layer.values[3 * p];
    if (n[0] == 0 && n[1] == 0 && n[2] == 0) return Colour{};
    return Colour{byte_of(n[0] * 0.5f + 0.5f), byte_of(n[1] * 0.5f + 0.5f), byte_of(n[2] * 0.5f + 0.5f)};
  });
}

Pixels colour(const Picture& picture, const Layer& layer) {
  return paint(picture, [&](size_t p) {
    const float* c = &layer.values[3 * p];
    return Colour{quick_srgb(c[0]), quick_srgb(c[1]), quick_srgb(c[2])};
  });
}

Pixels grey(const Picture& picture, const Layer& layer) {
  return paint(picture, [&](size_t p) {
    const uint8_t value = quick_srgb(layer.values[p]);
    return Colour{value, value, value};
  });
}

/// Near is bright, in steps of equal ratio: near things and far ones have room on it.
Pixels distance(const Picture& picture, const Layer& layer) {
  float low = INFINITY, high = 0;
  for (const float z : layer.values)
    if (z > 0 && z < 1e9f) low = std::min(low, z), high = std::max(high, z);
  const float extent = std::max(std::log(high / low), 1e-6f);
  return paint(picture, [&](size_t p) {
    const float z = layer.values[p];
    if (!(z < 1e9f)) return Colour{};
    const uint8_t grey = byte_of(1 - 0.9f * std::log(std::max(z, low) / low) / extent);
    return Colour{grey, grey, grey};
  });
}

/// Ids as colours. From one number to the next the hue turns by the golden ratio, so that neighbours look different.
Pixels numbers(const Picture& picture, const Layer& layer) {
  return paint(picture, [&](size_t p) {
    const uint32_t id = layer.ids[p];
    if (id == 0) return Colour{};
    const float hue = 6 * std::fmod(float(id) * 0.618034f, 1.0f), value = id % 3 == 0   ? 0.65f
                                                                          : id % 3 == 1 ? 0.95f
                                                                                        : 0.8f;
    const auto part = [&](float shift) {
      const float at = std::fmod(hue + shift, 6.0f);
      return byte_of(value * (0.25f + 0.75f * std::clamp(std::abs(at - 3) - 1, 0.0f, 1.0f)));
    };
    return Colour{part(0), part(4), part(2)};
  });
}

Pixels paint_layer(const Picture& picture, const Layer& layer, Paint how) {
  switch (how) {
    case Paint::colour: return colour(picture, layer);
    case Paint::grey: return grey(picture, layer);
    case Paint::extent: return extent(picture, layer);
    case Paint::vector: return vector(picture, layer);
    case Paint::distance: return distance(picture, layer);
    case Paint::numbers: return numbers(picture, layer);
    case Paint::heat:  // in_colours knows the scale's end
    case Paint::nothing: break;
  }
  return black(picture);
}

}  // namespace

const std::vector<ShowRow>& show_table() {
  static const std::vector<ShowRow> table = [] {
    std::vector<ShowRow> rows = {
        {"light", "The picture"},
        {"tests", "All tests that a pixel's rays took", LayerSet::filled_by(LayerFill::tests)},
        {"hash order", "Which rays are sorted together: the first bounce's, from first (violet) to last (yellow)"}};
    for (const LayerId id : LayerSet::all().members())
      if (const LayerShow& show = crsh::row_of(id).show; show.paint != Paint::nothing)
        rows.push_back({show.name, show.help, {id}, show.paint});
    return rows;
  }();
  return table;
}

bool is_heat(Show show) { return show == Show::tests || row_of(show).paint == Paint::heat; }

double heat_end(const Picture& picture, Show show) {
  const std::vector<float> tests = tests_of(picture, show);
  return tests.empty() ? 0 : output::heat_maximum(tests);
}

Pixels in_colours(const Picture& picture, Show show, double exposure, double heat_scale) {
  if (show == Show::light) return light(picture, exposure);
  if (is_heat(show)) return heat(picture, show, std::max(heat_scale, 1.0));
  const Layer* layer = show == Show::order ? picture.find(order_layer) : layer_of(picture, show);
  if (!layer) return black(picture);
  return show == Show::order ? order(picture, *layer) : paint_layer(picture, *layer, row_of(show).paint);
}

}  // namespace crsh::viewer
