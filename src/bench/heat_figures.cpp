#include "bench/heat_figures.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "bench/svg.h"
#include "output/heat_map.h"

namespace crsh::bench {
namespace {

/// log10(1 + tests): algorithms differ so much, a hundredfold, that a linear scale would show nothing of the better
/// ones.
std::vector<float> logarithms(const std::vector<float>& tests) {
  std::vector<float> values(tests.size());
  std::ranges::transform(tests, values.begin(), [](float value) { return std::log10(1 + std::max(value, 0.0f)); });
  return values;
}

/// Round numbers on that scale, from 0.
std::vector<output::HeatTick> log_ticks(double maximum) {
  std::vector<output::HeatTick> ticks = {{0, "0"}};
  const double highest = std::log10(1 + maximum);
  for (double power = highest > 4 ? 100 : 10; power <= maximum * (1 + 1e-9); power *= highest > 4 ? 100 : 10)
    ticks.push_back({std::log10(1 + power) / highest, count_text(static_cast<uint64_t>(power))});
  return ticks;
}

std::string figure_html(const std::string& png, const std::string& caption) {
  return fmt::format("<figure><img alt='{0}' src='{1}'><figcaption>{0}</figcaption></figure>\n", escaped(caption),
                     data_address("image/png", png));
}

std::string legend_html(double maximum) {
  std::string html = fmt::format("<div class='scale'><img alt='' src='{}'><div>",
                                 data_address("image/png", output::encode_colour_png(output::heat_legend(256, 1))));
  for (const output::HeatTick& tick : log_ticks(maximum))
    html += fmt::format("<span style='left:{:.2f}%'>{}</span>", 100 * tick.place, tick.label);
  // The end of the scale gets a tick of its own only where no other one is near.
  if (const auto ticks = log_ticks(maximum); ticks.back().place < 0.85)
    html += fmt::format("<span style='left:100%'>{}</span>", count_text(static_cast<uint64_t>(maximum)));
  return html + "</div></div>\n<p class='note'>Tests a pixel, of all its rays; one scale for all pictures.</p>\n";
}

}  // namespace

std::string data_address(const std::string& type, const std::string& bytes) {
  static constexpr char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text = fmt::format("data:{};base64,", type);
  for (size_t i = 0; i < bytes.size(); i += 3) {
    const auto byte = [&](size_t k) {
      return i + k < bytes.size() ? uint32_t(static_cast<uint8_t>(bytes[i + k])) : 0u;
    };
    const uint32_t word = byte(0) << 16 | byte(1) << 8 | byte(2);
    text += digits[word >> 18];
    text += digits[word >> 12 & 63];
    text += i + 1 < bytes.size() ? digits[word >> 6 & 63] : '=';
    text += i + 2 < bytes.size() ? digits[word & 63] : '=';
  }
  return text;
}

std::string heat_figures_html(const SceneResults& scene) {
  double maximum = 0;
  for (const Result& result : scene.results)
    if (!result.heat.empty()) maximum = std::max(maximum, output::heat_maximum(result.heat));
  if (maximum <= 0) return "";
  std::string html =
      "<div class='figures'>\n" + figure_html(scene.results.front().picture_png, "The picture, the same for all");
  for (const Result& result : scene.results) {
    if (result.heat.empty()) continue;
    const output::ColourPicture map =
        output::heat_map(logarithms(result.heat), result.width, result.height, std::log10(1 + maximum));
    html += figure_html(output::encode_colour_png(map), row_name(result));
  }
  html += "</div>\n" + legend_html(maximum);
  for (const Result& result : scene.results)
    if (!result.counted_from.empty())
      html += fmt::format("<p class='note'>{} was counted, not traced: it has no picture here.</p>\n",
                          escaped(row_name(result)));
  return html;
}

}  // namespace crsh::bench
