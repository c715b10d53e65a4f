#pragma once
// What is drawn above the picture: the line between two, the heat scale, and later bounds and nodes.

#include "viewer/model.h"
#include "viewer/panels/panels.h"

namespace crsh::viewer {

/// `heat`: what the heat scale ends at.
void draw_overlays(const Model& model, const Layout& layout, double heat);

/// Ray nodes and bounds of objects, where they are wished for.
void draw_inside(const Model& model, const Layout& layout);

}  // namespace crsh::viewer
