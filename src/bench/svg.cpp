#include "bench/svg.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace crsh::bench {
namespace {

/// A pattern's background and strokes, in a square of eight units.
struct Pattern {
  const char *ground, *strokes;
};
constexpr std::array<Pattern, pattern_count> patterns = {{
    {"#1b3a5c", ""},
    {"#c8d9e8", "<path d='M-2 2L2 -2M0 8L8 0M6 10L10 6' stroke='#1b3a5c' stroke-width='2'/>"},
    {"#e8a33d", ""},
    {"#fff3dc", "<path d='M0 0L8 8M-2 6L2 10M6 -2L10 2' stroke='#a5620a' stroke-width='1.5'/>"},
    {"#dfe9d8", "<circle cx='2' cy='2' r='1.4' fill='#2f5d1e'/><circle cx='6' cy='6' r='1.4' fill='#2f5d1e'/>"},
    {"#6f9f58", "<path d='M0 2H8M0 6H8' stroke='#1f4212' stroke-width='1.5'/>"},
    {"#3f7fb5", "<path d='M2 0V8M6 0V8' stroke='#e4f0fa' stroke-width='1.2'/>"},
    {"#7a1f2b", "<path d='M0 0L8 8M0 8L8 0' stroke='#f3c9cf' stroke-width='1'/>"},
    {"#eeeeee", ""},
    {"#ffffff", "<path d='M0 4H8M4 0V8' stroke='#555' stroke-width='1'/>"},
}};

constexpr double bars_left = 25, bars_width = 53;  ///< per cent of a chart's width

std::string text_at(const std::string& x, double y, const std::string& text, const char* attributes = "") {
  return fmt::format("<text x='{}' y='{:.1f}' {}>{}</text>", x, y, attributes, escaped(text));
}

std::string open_svg(double height, const std::string& title) {
  return fmt::format("<svg class='chart' width='100%' height='{:.0f}' role='img'><title>{}</title>", height,
                     escaped(title));
}

std::string power_text(int power) {
  static constexpr std::array<const char*, 3> suffixes = {"", "k", "M"};
  if (power < 0) return fmt::format("{:g}", std::pow(10, power));
  if (power < 9)
    return fmt::format("{}{}", std::llround(std::pow(10, power % 3)), suffixes[static_cast<size_t>(power / 3)]);
  return fmt::format("{}G", std::llround(std::pow(10, power - 9)));
}

/// A logarithmic scale between powers of ten that enclose all values, which are positive.
struct LogScale {
  int low = 0, high = 1;
  [[nodiscard]] double place(double value) const { return (std::log10(value) - low) / (high - low); }
};

template <class Values>
LogScale scale_of(const Values& values) {
  const auto [least, most] = std::ranges::minmax(values);
  LogScale scale{static_cast<int>(std::floor(std::log10(least))), static_cast<int>(std::ceil(std::log10(most)))};
  scale.high = std::max(scale.high, scale.low + 1);
  return scale;
}

/// Which powers of ten have a mark: all, or every second or third where there would be more than `most`.
std::vector<int> marks_of(const LogScale& scale, int most) {
  const int step = (scale.high - scale.low + most - 1) / most;
  std::vector<int> marks;
  for (int power = scale.low; power <= scale.high; power += step) marks.push_back(power);
  return marks;
}

double percent_x(double place) { return bars_left + bars_width * place; }

std::string bar_row(const Bar& bar, const LogScale& scale, double y) {
  // The smallest value gets a visible bar, too.
  const double width = bars_width * std::max(scale.place(bar.value), 0.01);
  return text_at(fmt::format("{}%", bars_left - 2), y + 11, bar.name, "text-anchor='end'") +
         fmt::format(
             "<rect x='{}%' y='{:.1f}' width='{:.2f}%' height='13' fill='url(#p{})' stroke='#222' stroke-width='.7'/>",
             bars_left, y, width, bar.pattern % pattern_count) +
         text_at(fmt::format("{:.2f}%", bars_left + width + 1), y + 11, bar.label);
}

std::string log_grid(const LogScale& scale, double height) {
  std::string svg;
  for (const int power : marks_of(scale, 5)) {
    const double x = percent_x(scale.place(std::pow(10, power)));
    svg += fmt::format("<line x1='{0:.2f}%' x2='{0:.2f}%' y1='16' y2='{1:.0f}' stroke='#ccc'/>", x, height);
    svg += text_at(fmt::format("{:.2f}%", x), 11, power_text(power), "text-anchor='middle' fill='#555'");
  }
  return svg;
}

// ---- curves

constexpr double plot_left = 13, plot_width = 84, plot_top = 24, plot_height = 230;

/// The dashes of the i-th curve.
constexpr std::array<const char*, 5> dashes = {"", "7 3", "2 3", "9 3 2 3", "1 5"};
constexpr std::array<const char*, 6> marks = {"\u25CF", "\u25A0", "\u25B2", "\u25C6", "\u25CB", "\u25A1"};
constexpr std::array<const char*, 6> inks = {"#1b3a5c", "#a5620a", "#2f5d1e", "#7a1f2b", "#3f7fb5", "#444444"};

struct Plot {
  LogScale x, y;
  [[nodiscard]] double left(double value) const { return plot_left + plot_width * x.place(value); }
  [[nodiscard]] double top(double value) const { return plot_top + plot_height * (1 - y.place(value)); }
};

std::string curve_svg(const Curve& curve, const Plot& plot, size_t index) {
  const char* ink = inks[index % inks.size()];
  std::string svg;
  for (size_t i = 0; i < curve.points.size(); ++i) {
    const auto& [x, y] = curve.points[i];
    if (i)
      svg += fmt::format(
          "<line x1='{:.2f}%' y1='{:.1f}' x2='{:.2f}%' y2='{:.1f}' stroke='{}' stroke-width='1.8' "
          "stroke-dasharray='{}'/>",
          plot.left(curve.points[i - 1].first), plot.top(curve.points[i - 1].second), plot.left(x), plot.top(y), ink,
          dashes[index % dashes.size()]);
    svg += fmt::format("<text x='{:.2f}%' y='{:.1f}' text-anchor='middle' font-size='13' fill='{}'>{}</text>",
                       plot.left(x), plot.top(y) + 4.5, ink, marks[index % marks.size()]);
  }
  return svg;
}

std::string plot_grid(const Plot& plot, const std::string& x_name, const std::string& y_name) {
  std::string svg;
  for (const int power : marks_of(plot.y, 5)) {
    const double y = plot.top(std::pow(10, power));
    svg += fmt::format("<line x1='{}%' x2='{}%' y1='{:.1f}' y2='{:.1f}' stroke='#ccc'/>", plot_left,
                       plot_left + plot_width, y, y);
    svg += text_at(fmt::format("{}%", plot_left - 1.5), y + 4, power_text(power), "text-anchor='end' fill='#555'");
  }
  for (const int power : marks_of(plot.x, 5)) {
    const double x = plot.left(std::pow(10, power));
    svg += fmt::format("<line x1='{0:.2f}%' x2='{0:.2f}%' y1='{1}' y2='{2}' stroke='#ccc'/>", x, plot_top,
                       plot_top + plot_height);
    svg += text_at(fmt::format("{:.2f}%", x), plot_top + plot_height + 15, power_text(power),
                   "text-anchor='middle' fill='#555'");
  }
  svg += text_at("55%", plot_top + plot_height + 32, x_name, "text-anchor='middle'");
  return svg + text_at("0", 9, y_name);
}

std::string curve_legend(const std::vector<Curve>& curves) {
  std::string html = "<p class='legend'>";
  for (size_t i = 0; i < curves.size(); ++i)
    html += fmt::format(
        "<span><svg width='34' height='14'><line x1='0' x2='34' y1='7' y2='7' stroke='{0}' stroke-width='1.8' "
        "stroke-dasharray='{1}'/><text x='17' y='11.5' text-anchor='middle' font-size='13' "
        "fill='{0}'>{2}</text></svg>{3}</span>",
        inks[i % inks.size()], dashes[i % dashes.size()], marks[i % marks.size()], escaped(curves[i].name));
  return html + "</p>";
}

}  // namespace

std::string pattern_definitions() {
  std::string svg = "<svg width='0' height='0' style='position:absolute' aria-hidden='true'><defs>";
  for (size_t i = 0; i < patterns.size(); ++i)
    svg += fmt::format(
        "<pattern id='p{}' width='8' height='8' patternUnits='userSpaceOnUse'><rect width='8' height='8' "
        "fill='{}'/>{}</pattern>",
        i, patterns[i].ground, patterns[i].strokes);
  return svg + "</defs></svg>\n";
}

std::string swatch(size_t pattern) {
  return fmt::format(
      "<svg width='24' height='14'><rect x='.5' y='.5' width='23' height='13' fill='url(#p{})' stroke='#222' "
      "stroke-width='.7'/></svg>",
      pattern % pattern_count);
}

std::string bars_svg(const std::vector<BarGroup>& groups, const std::string& title) {
  std::vector<double> values;
  for (const BarGroup& group : groups)
    for (const Bar& bar : group.bars)
      if (bar.value > 0) values.push_back(bar.value);
  if (values.empty()) return "";
  const LogScale scale = scale_of(values);
  std::string rows;
  double y = 20;
  for (const BarGroup& group : groups) {
    rows += text_at("0", y + 13, group.name, "font-weight='bold'");
    y += 19;
    for (const Bar& bar : group.bars) {
      if (!(bar.value > 0)) continue;
      rows += bar_row(bar, scale, y);
      y += 17;
    }
    y += 7;
  }
  return open_svg(y, title) + log_grid(scale, y) + rows + "</svg>\n";
}

std::string stacks_svg(const std::vector<Stack>& stacks, const std::vector<std::string>& part_names,
                       const std::string& unit, const std::string& title) {
  double longest = 0;
  for (const Stack& stack : stacks) {
    double sum = 0;
    for (const double part : stack.parts) sum += part;
    longest = std::max(longest, sum);
  }
  if (!(longest > 0)) return "";
  std::string svg = open_svg(double(stacks.size()) * 46, title);
  double y = 0;
  for (const Stack& stack : stacks) {
    svg += text_at("0", y + 13, stack.name, "font-weight='bold'") +
           text_at("100%", y + 13, stack.label, "text-anchor='end'");
    double x = 0;
    for (size_t i = 0; i < stack.parts.size(); ++i) {
      const double width = 100 * stack.parts[i] / longest;
      svg += fmt::format(
          "<rect x='{:.3f}%' y='{:.1f}' width='{:.3f}%' height='20' fill='url(#p{})' stroke='#222' stroke-width='.7'>"
          "<title>{}: {:.2f} {}</title></rect>",
          x, y + 18, width, i % pattern_count, escaped(part_names[i]), stack.parts[i], unit);
      x += width;
    }
    y += 46;
  }
  svg += "</svg>\n<p class='legend'>";
  for (size_t i = 0; i < part_names.size(); ++i)
    svg += fmt::format("<span>{}{}</span>", swatch(i), escaped(part_names[i]));
  return svg + "</p>\n";
}

std::string curves_svg(const std::vector<Curve>& curves, const std::string& x_name, const std::string& y_name,
                       const std::string& title) {
  std::vector<double> xs, ys;
  for (const Curve& curve : curves)
    for (const auto& [x, y] : curve.points) xs.push_back(x), ys.push_back(y);
  if (xs.empty()) return "";
  const Plot plot{scale_of(xs), scale_of(ys)};
  std::string svg = open_svg(plot_top + plot_height + 40, title) + plot_grid(plot, x_name, y_name);
  for (size_t i = 0; i < curves.size(); ++i) svg += curve_svg(curves[i], plot, i);
  return svg + "</svg>\n" + curve_legend(curves);
}

std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (c == '&') result += "&amp;";
    else if (c == '<') result += "&lt;";
    else if (c == '>') result += "&gt;";
    else if (c == '\'') result += "&#39;";
    else if (c == '"') result += "&quot;";
    else result += c;
  }
  return result;
}

}  // namespace crsh::bench
