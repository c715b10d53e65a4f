#pragma once
// Exposure of PNG files, in stops.

#include <cstdint>
#include <optional>
#include <string>

#include "crsh/picture.h"

namespace crsh::output {

/// The exposure that puts the median of the lit pixels' brightest channel at a quarter of white, to a tenth of a stop;
/// 0 where nothing is lit.
[[nodiscard]] double automatic_exposure(const Layer& beauty);

struct ExposureAdvice {
  std::string reason;            ///< what is wrong, as a clause
  std::optional<double> better;  ///< the exposure that mends it; none: nothing is lit
};

/// Where over half of the pixels clip or are black at `exposure`. Nothing where no value would be better.
[[nodiscard]] std::optional<ExposureAdvice> exposure_advice(const Layer& beauty, double exposure);

}  // namespace crsh::output
