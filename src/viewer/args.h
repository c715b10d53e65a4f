#pragma once
// The command line of crsh-view: the options of `crsh render` that one picture has, and the viewer's own.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "cli/render_options.h"

namespace crsh::viewer {

struct Arguments {
  cli::RenderCommand render;      ///< its scene may be empty: one is dropped onto the window
  uint32_t max_samples = 64;      ///< samples of a picture at rest
  float budget_ms = 50;           ///< for a frame while the camera moves
  bool watch = false;             ///< the scene is loaded anew when its file changes
  std::string script;             ///< path or empty
  std::optional<uint32_t> after;  ///< ends after so many frames were shown with all samples
  std::string screenshot, save;   ///< paths or empty
  bool print_command = false;
};

/// Reads what follows the program's name. Where that asks for help, prints it and returns nothing. Throws UserError.
[[nodiscard]] std::optional<Arguments> parse_arguments(const std::vector<std::string>& arguments);

}  // namespace crsh::viewer
