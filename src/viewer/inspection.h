#pragma once
// A coarse frame of one kind of rays, for looking at how they are sorted and bundled.

#include <cstdint>
#include <utility>
#include <vector>

#include "crsh/built.h"
#include "crsh/renderer.h"

namespace crsh::viewer {

struct Inspection {
  Picture order;  ///< layer `order_layer`: a pixel's ray's place among the first light's, 0 to 1; NaN: none
  std::vector<RayNode> nodes;                         ///< over the rays of the first bounce
  std::vector<std::pair<uint32_t, uint32_t>> places;  ///< pixel and RayTable::sorted of each ray, rising
  std::vector<ObjectBox> boxes;
  std::vector<float> reaches;  ///< of each node, metres: how far its rays go
  uint64_t wish = 0, serial = 0;
};

inline constexpr const char* order_layer = "Order";

struct InspectIn {
  RenderOptions options;  ///< of the fine picture
  double seconds = 0;
  uint32_t kind = 0;    ///< of the rays
  uint32_t lights = 1;  ///< that there are
  bool moving = false;  ///< coarser still
};

/// Renders it. The renderer's options are others afterwards.
[[nodiscard]] Inspection inspect(Renderer& renderer, const InspectIn& in);

}  // namespace crsh::viewer
