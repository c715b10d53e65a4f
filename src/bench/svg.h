#pragma once
// Charts as SVG that stretches: widths are per cent of the page's, so that letters keep their size on a phone. Bars
// differ by pattern and lines by mark and dashes, so that they can be told apart in grey.

#include <string>
#include <utility>
#include <vector>

namespace crsh::bench {

/// How many patterns there are; the next one is the first again.
inline constexpr size_t pattern_count = 10;

/// The patterns' definitions, which the page needs once, before all charts.
[[nodiscard]] std::string pattern_definitions();

/// A small square of a pattern, for legends.
[[nodiscard]] std::string swatch(size_t pattern);

struct Bar {
  std::string name;
  double value = 0;
  std::string label;  ///< the value as text
  size_t pattern = 0;
};
struct BarGroup {
  std::string name;
  std::vector<Bar> bars;
};
/// Horizontal bars below the name of each group, on one logarithmic scale. Bars of value 0 are left out.
[[nodiscard]] std::string bars_svg(const std::vector<BarGroup>& groups, const std::string& title);

/// A bar made of parts, as long as their sum, with `label` for the sum; on one linear scale.
struct Stack {
  std::string name, label;
  std::vector<double> parts;  ///< the i-th has pattern i
};
[[nodiscard]] std::string stacks_svg(const std::vector<Stack>& stacks, const std::vector<std::string>& part_names,
                                     const std::string& unit, const std::string& title);

struct Curve {
  std::string name;
  std::vector<std::pair<double, double>> points;  ///< positive
};
/// Lines through their points on two logarithmic scales.
[[nodiscard]] std::string curves_svg(const std::vector<Curve>& curves, const std::string& x_name,
                                     const std::string& y_name, const std::string& title);

/// Text with the characters escaped that mean something in HTML and SVG.
[[nodiscard]] std::string escaped(const std::string& text);

}  // namespace crsh::bench
