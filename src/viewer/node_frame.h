#pragma once
// A coarse frame of one kind of rays, for looking at how they are sorted and bundled.

#include <cstdint>
#include <utility>
#include <vector>

#include "crsh/built.h"
#include "crsh/renderer.h"

namespace crsh::viewer {

struct NodeFrame {
  Picture order;  ///< layer `order_layer`: place of the pixel's ray in sorted order, 0 to 1; NaN: it has none
  std::vector<RayNode> nodes;                         ///< over the rays of the first bounce
  std::vector<std::pair<uint32_t, uint32_t>> places;  ///< pixel and RayTable::sorted of each ray, sorted by pixel
  std::vector<ObjectBox> boxes;
  std::vector<float> reaches;  ///< of each node, metres: how far its rays go
  uint64_t wish = 0, serial = 0;
};

inline constexpr const char* order_layer = "Order";

struct NodeFrameIn {
  RenderOptions options;  ///< of the fine picture
  double seconds = 0;
  uint32_t kind = 0;    ///< of the rays
  uint32_t lights = 1;  ///< of the scene
  bool moving = false;  ///< the camera moves: the frame is coarser still
};

/// Renders such a frame. It changes the renderer's options, and does not change them back.
[[nodiscard]] NodeFrame render_node_frame(Renderer& renderer, const NodeFrameIn& in);

}  // namespace crsh::viewer
