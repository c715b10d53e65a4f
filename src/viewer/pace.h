#pragma once
// How coarse a picture has to be so that a frame keeps to its budget.

#include <array>
#include <cstddef>

#include "raster/camera.h"

namespace crsh::viewer {

/// Learns from the frames that it is told of.
class Pace {
 public:
  /// Of a frame that may take `budget_ms`; at least a pixel.
  [[nodiscard]] raster::ImageSize size(raster::ImageSize full, double budget_ms);
  /// A frame of this size took so long.
  void measured(raster::ImageSize size, raster::ImageSize full, double ms);

 private:
  /// By how much each side is divided.
  static constexpr std::array<double, 9> divisors = {1, 1.5, 2, 3, 4, 6, 8, 12, 16};
  size_t step_ = 2;
  double ms_ = 0;  ///< of a frame of this step; 0: unknown
};

}  // namespace crsh::viewer
