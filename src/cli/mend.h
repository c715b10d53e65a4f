#pragma once
// The library's messages in the words of the command line.

#include <string>

#include "crsh/error.h"
#include "crsh/options.h"

namespace crsh::cli {

/// The error's line, with its mend as options to give.
[[nodiscard]] std::string line_of(const UserError& error);

/// Where the eye stands and looks, as options to paste: "--eye 1,2,3 --target 4,5,6".
[[nodiscard]] std::string option_of(const ViewOption& view);

/// A light as an option to paste: "--light 1,2,3,4".
[[nodiscard]] std::string option_of(const LightOption& light);

}  // namespace crsh::cli
