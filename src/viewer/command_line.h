#pragma once
// The command line that renders what is shown.

#include <string>

#include "cli/render_options.h"
#include "viewer/job.h"

namespace crsh::viewer {

/// The command of a picture: `base` with the picture's options and time.
[[nodiscard]] cli::RenderCommand command_of(const Shown& shown, const cli::RenderCommand& base);

/// "crsh render scene.glb --size 640x480 ... -o picture.png", quoted for a shell: every option that differs from its
/// default and changes the picture or what it costs.
[[nodiscard]] std::string command_line(cli::RenderCommand command);

}  // namespace crsh::viewer
