#pragma once
// Pictures against the baselines beside this file.

#include <string>

#include "crsh/picture.h"

namespace crsh::test {

/// Compares the picture's PNG with baselines/NAME.png, within what two versions of a driver's rasteriser may differ by.
/// Empty where they agree; else a sentence, with the paths of the actual picture and of the difference, which are
/// written to the build folder. With CRSH_BLESS=1 the picture becomes the baseline.
[[nodiscard]] std::string difference_to_baseline(const std::string& name, const Picture& picture);

}  // namespace crsh::test
