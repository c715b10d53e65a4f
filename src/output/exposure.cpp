#include "output/exposure.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "output/png.h"

namespace crsh::output {
namespace {

constexpr double median_target = 0.25;

/// The value of the brightest channel of each pixel that is not black.
std::vector<double> lit_pixels(const Layer& beauty) {
  std::vector<double> lit;
  for (size_t first = 0; first + 4 <= beauty.values.size(); first += 4) {
    const float* rgb = &beauty.values[first];
    const double brightest = std::max({rgb[0], rgb[1], rgb[2]});
    if (brightest > 0 && std::isfinite(brightest)) lit.push_back(brightest);
  }
  return lit;
}

double exposure_for(std::vector<double>& lit) {
  if (lit.empty()) return 0;
  const auto middle = lit.begin() + static_cast<std::ptrdiff_t>(lit.size() / 2);
  std::nth_element(lit.begin(), middle, lit.end());
  return std::round(std::log2(median_target / *middle) * 10) / 10;
}

struct Count {
  size_t clipped = 0, black = 0;
  [[nodiscard]] size_t bad() const { return clipped + black; }
};

Count count_bad(const std::vector<double>& lit, double exposure) {
  const double scale = std::exp2(exposure);
  Count count;
  for (const double value : lit) {
    count.clipped += value * scale > 1;
    count.black += srgb_byte(value * scale) == 0;
  }
  return count;
}

}  // namespace

double automatic_exposure(const Layer& beauty) {
  std::vector<double> lit = lit_pixels(beauty);
  return exposure_for(lit);
}

std::optional<ExposureAdvice> exposure_advice(const Layer& beauty, double exposure) {
  const size_t pixels = beauty.values.size() / 4;
  std::vector<double> lit = lit_pixels(beauty);
  if (lit.empty()) return ExposureAdvice{"every pixel is black: nothing in view is lit", {}};
  const Count now = count_bad(lit, exposure);
  const double better = exposure_for(lit);
  const size_t dark = pixels - lit.size();  // black at any exposure
  if ((now.bad() + dark) * 2 <= pixels || now.bad() * 2 <= lit.size()) return {};
  if (count_bad(lit, better).bad() >= now.bad()) return {};
  return ExposureAdvice{fmt::format("{} of the lit pixels {}", now.bad() == lit.size() ? "all" : "over half",
                                    now.clipped > now.black ? "clip" : "are black"),
                        better};
}

}  // namespace crsh::output
