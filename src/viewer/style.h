#pragma once
// How the panels look.

namespace crsh::viewer {

/// Sets colours, spacing and font of ImGui's current context, all `scale` times as large as usual.
void set_style(float scale);

}  // namespace crsh::viewer
