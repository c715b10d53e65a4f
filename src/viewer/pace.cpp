#include "viewer/pace.h"

#include <algorithm>
#include <cmath>

namespace crsh::viewer {
namespace {

/// A finer picture must take no more than this share of the budget, or the size would change to and fro.
constexpr double spare = 0.8;

uint32_t divided(uint32_t side, double by) { return std::max(1u, static_cast<uint32_t>(std::lround(side / by))); }

}  // namespace

raster::ImageSize Pace::size(raster::ImageSize full, double budget_ms) {
  const auto expected = [&](size_t step) { return ms_ * std::pow(divisors[step_] / divisors[step], 2); };
  if (ms_ > 0) {
    size_t step = step_;
    while (step + 1 < divisors.size() && expected(step) > budget_ms) ++step;
    while (step > 0 && step <= step_ && expected(step - 1) < spare * budget_ms) --step;
    if (step != step_) ms_ = expected(step), step_ = step;
  }
  return {divided(full.width, divisors[step_]), divided(full.height, divisors[step_])};
}

void Pace::measured(raster::ImageSize size, raster::ImageSize full, double ms) {
  const double share = double(size.width) * size.height / (double(full.width) * full.height);
  // From the time of a whole picture follows roughly that of one of this step's size.
  const double now = ms / share / (divisors[step_] * divisors[step_]);
  const bool own = size.width == divided(full.width, divisors[step_]);
  if (own) ms_ = ms;
  else if (ms_ == 0) ms_ = now;
}

}  // namespace crsh::viewer
