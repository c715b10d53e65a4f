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

/// Where over half of the pixels clip or are black at `exposure`: a sentence that names the value which mends it, or
/// that nothing is lit. Nothing where no value would be better.
[[nodiscard]] std::optional<std::string> exposure_advice(const Layer& beauty, double exposure);

}  // namespace crsh::output
