#include "viewer/node_frame.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace crsh::viewer {
namespace {

constexpr uint32_t box_depth = 8;
constexpr double max_rays = 250'000, max_moving = 20'000;

/// The options for one kind of rays, and for a picture so small that a table holds its rays with ease.
RenderOptions reduced(const NodeFrameIn& in) {
  const RayKind& kind = ray_kinds[in.kind];
  RenderOptions options = in.options;
  options.rays.fill(false);
  options.rays[in.kind] = true;
  options.bounces = kind.cast_at(0, 0) ? 0 : 1;
  options.layers = {LayerId::beauty};
  const double rays = double(options.width) * options.height * (kind.one_a_light ? std::max(in.lights, 1u) : 1);
  const double by = std::sqrt(std::max(rays / (in.moving ? max_moving : max_rays), 1.0));
  options.width = std::max(1u, uint32_t(options.width / by));
  options.height = std::max(1u, uint32_t(options.height / by));
  return options;
}

/// Fills the layer with each pixel's place among the sorted rays; of shadow rays, those of the first light.
void fill_order(const RayTable& table, NodeFrame& made) {
  Layer layer{.name = order_layer, .channels = {"Y"}, .values = {}, .ids = {}};
  layer.values.assign(size_t(made.order.width) * made.order.height, std::numeric_limits<float>::quiet_NaN());
  uint32_t low = UINT32_MAX, high = 0;
  const auto is_meant = [&](uint32_t row) { return table.light[row] == table.light[0] && table.bounce[row] == 0; };
  for (uint32_t row = 0; row < table.size(); ++row)
    if (is_meant(row)) low = std::min(low, table.sorted[row]), high = std::max(high, table.sorted[row]);
  for (uint32_t row = 0; row < table.size(); ++row)
    if (is_meant(row))
      layer.values[table.pixel[row]] = float(table.sorted[row] - low) / float(std::max(high - low, 1u));
  made.order.layers.push_back(std::move(layer));
}

/// Fills in how far the rays of each node go: to what they hit; shadow rays, which start at the light, to their end.
void fill_reaches(const RayTable& table, NodeFrame& made) {
  constexpr float far = 1e15f;
  std::vector<float> of_place(table.size());
  for (uint32_t row = 0; row < table.size(); ++row) {
    const float reach = std::min(table.t[row], table.tmax[row]);
    of_place[table.sorted[row]] = reach < far ? reach : 0;
  }
  for (const RayNode& node : made.nodes)
    made.reaches.push_back(*std::max_element(of_place.begin() + node.first, of_place.begin() + node.end));
}

}  // namespace

NodeFrame render_node_frame(Renderer& renderer, const NodeFrameIn& in) {
  NodeFrame made;
  RayTable table;
  renderer.change(reduced(in));
  renderer.watch_nodes(&made.nodes);
  try {
    made.order = renderer.render(in.seconds, {}, &table);
  } catch (...) {
    renderer.watch_nodes(nullptr);
    throw;
  }
  renderer.watch_nodes(nullptr);
  fill_order(table, made);
  for (uint32_t row = 0; row < table.size(); ++row)
    if (table.bounce[row] == 0) made.places.emplace_back(table.pixel[row], table.sorted[row]);
  std::ranges::sort(made.places);
  std::erase_if(made.nodes, [](const RayNode& node) { return node.bounce != 0; });
  fill_reaches(table, made);
  made.boxes = renderer.object_boxes(box_depth);
  return made;
}

}  // namespace crsh::viewer
