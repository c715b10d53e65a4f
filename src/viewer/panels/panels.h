#pragma once
// The panels around the picture.

#include <glm/glm.hpp>

#include "viewer/model.h"
#include "viewer/widgets.h"

namespace crsh::viewer {

/// Where things are, as ImGui has it: from the upper left corner of the window.
struct Layout {
  glm::vec2 window{0};
  float left = 0, right = 0, bottom = 0, status = 0;  ///< widths of the panels, height of what is below the picture
  [[nodiscard]] glm::vec2 low() const { return {left, 0}; }
  [[nodiscard]] glm::vec2 high() const {
    return glm::max(glm::vec2(window.x - right, window.y - bottom), low() + 1.0f);
  }
};

/// The layout in a window of this size; `text`: the height of a line of text.
[[nodiscard]] Layout layout_of(const Model& model, glm::vec2 window, float text);

/// Draws all panels, and changes `model` as people change them.
void draw_panels(Model& model, Widgets& widgets, const Layout& layout);

// Their parts, a file each.
void draw_view_section(Model& model, Widgets& widgets);
void draw_algorithm_section(Model& model, Widgets& widgets);
void draw_rays_section(Model& model, Widgets& widgets);
void draw_scene_section(Model& model, Widgets& widgets);
void draw_measures(Model& model, Widgets& widgets);
void draw_bottom(Model& model, Widgets& widgets, const Layout& layout);
void draw_messages(Model& model, const Layout& layout);
void draw_keys_help(Model& model, const Layout& layout);

}  // namespace crsh::viewer
