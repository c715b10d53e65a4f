#pragma once
// How the panels look.

namespace crsh::viewer {

/// Colours, spacing and the font of ImGui's current context; everything `scale` times as large as usual.
void set_style(float scale);

}  // namespace crsh::viewer
