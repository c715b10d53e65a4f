#pragma once
// Saving what the window shows.

#include <string>

#include "gpu/window/swapchain.h"
#include "viewer/model.h"

namespace crsh::viewer {

/// The picture that is shown, in full resolution, as `crsh render` would write it with the command that C copies: .png,
/// or .exr with the layers of --layers. Throws UserError.
void save_picture(const Model& model, const std::string& path);
/// Whether the shown picture has all that this file needs.
[[nodiscard]] bool can_save(const Model& model, const std::string& path);

void save_screenshot(const gpu::Screenshot& screenshot, const std::string& path);

/// A name for what F12 saves that no file has yet, such as "office-3.png".
[[nodiscard]] std::string free_name(const Model& model, const std::string& extension);

/// The command that C copies.
[[nodiscard]] std::string copied_command(const Model& model);

}  // namespace crsh::viewer
