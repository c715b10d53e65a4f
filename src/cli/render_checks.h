#pragma once
// Checks of `crsh render`'s options, before anything is loaded.

#include "cli/render_options.h"

namespace crsh::cli {

/// Throws UserError (wrong usage) where options do not go together.
void check_combinations(const RenderCommand& command);

/// Throws UserError (wrong usage) where both the time of one picture and a range of frames are given.
void check_time(const RenderCommand& command);

/// Throws UserError (wrong usage) where options of the camera do not go together.
void check_view(const ViewOption& view, const std::string& camera);

/// Throws UserError where an output of any frame, or the statistics, could not be written.
void check_places(const RenderCommand& command);

}  // namespace crsh::cli
