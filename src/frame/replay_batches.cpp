#include "frame/replay_batches.h"

#include <algorithm>
#include <tuple>

#include "rays/create.h"

namespace crsh {
namespace {

/// The place of a pixel in the order of shaders/lib/pixel_order.glsl.
uint32_t tiled_place(uint32_t pixel, uint32_t width, uint32_t height) {
  constexpr uint32_t side = 8;
  const uint32_t x = pixel % width, y = pixel / width;
  const uint32_t left = x / side * side, top = y / side * side;
  const uint32_t tile_width = std::min(side, width - left), tile_height = std::min(side, height - top);
  return top * width + left * tile_height + (y - top) * tile_width + (x - left);
}

/// The bits of a path in reversed order. Surfaces of a bounce are ordered by the last turn of their path, then by the
/// one before, and so on, and last by pixel.
uint64_t reversed(uint64_t path) {
  constexpr uint64_t turn = (1u << shared::path_bits) - 1;
  uint64_t result = 0;
  for (uint32_t read = 0; read < 32; read += shared::path_bits, path >>= shared::path_bits)
    result = result << shared::path_bits | (path & turn);
  return result;
}

/// What the rays of a segment are ordered by.
struct Place {
  uint32_t batch = 0, bounce = 0, kind = 0, light = 0, pixel = 0, row = 0;
  uint64_t turns = 0;
  [[nodiscard]] auto batch_key() const { return std::tuple(batch, bounce); }
  [[nodiscard]] auto segment_key() const { return std::tuple(kind, light); }
  [[nodiscard]] bool operator<(const Place& other) const {
    return std::tuple(batch, bounce, kind, light, turns, pixel, row) <
           std::tuple(other.batch, other.bounce, other.kind, other.light, other.turns, other.pixel, other.row);
  }
};

std::vector<Place> sorted_places(const RayTable& table, RayOrder order) {
  std::vector<Place> places(table.size());
  for (uint32_t row = 0; row < table.size(); ++row) {
    places[row] = {table.batch[row], table.bounce[row], table.kind[row], table.light[row], 0, row, 0};
    if (!table.width) continue;
    const uint32_t pixel = table.pixel[row];
    places[row].turns = reversed(table.path[row]);
    places[row].pixel = order == RayOrder::tiles ? tiled_place(pixel, table.width, table.height) : pixel;
  }
  std::sort(places.begin(), places.end());
  return places;
}

}  // namespace

std::vector<ReplayBatch> replay_batches(const RayTable& table, const AlgorithmOptions& options) {
  std::vector<ReplayBatch> batches;
  const Place* before = nullptr;
  const std::vector<Place> places = sorted_places(table, options.ray_order);
  for (const Place& place : places) {
    bool new_batch = !before || before->batch_key() != place.batch_key();
    new_batch |= before && !options.mixed_batches && before->kind != place.kind;
    new_batch |= before && batches.back().rows.size() == shared::max_batch_rays;
    bool new_segment = new_batch || before->segment_key() != place.segment_key();
    new_batch |= new_segment && !batches.empty() && batches.back().segments.size() == rays::max_segments;
    if (new_batch) batches.push_back({place.bounce, {}, {}});
    ReplayBatch& batch = batches.back();
    const auto first = static_cast<uint32_t>(batch.rows.size());
    if (new_segment) batch.segments.push_back({place.kind, place.light, first, 0});
    batch.rows.push_back(place.row);
    ++batch.segments.back().count;
    before = &place;
  }
  return batches;
}

}  // namespace crsh
