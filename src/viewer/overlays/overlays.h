#pragma once
// What is drawn above the picture: the line between two pictures, the heat scale, ray nodes and bounds of objects.

#include "viewer/model.h"
#include "viewer/panels/panels.h"

namespace crsh::viewer {

/// Draws all of it; `heat`: the greatest value of the heat scale.
void draw_overlays(const Model& model, const Layout& layout, double heat);

/// Draws ray nodes and bounds of objects, where they are to be shown.
void draw_nodes_and_boxes(const Model& model, const Layout& layout);

}  // namespace crsh::viewer
