#pragma once
// How coarse a picture has to be so that a frame keeps to its budget.

#include <array>
#include <cstddef>

#include "raster/camera.h"

namespace crsh::viewer {

/// Chooses the size of pictures by the time that those before took.
class Pace {
 public:
  /// The size of a picture that may take `budget_ms`; at least one pixel.
  [[nodiscard]] raster::ImageSize size(raster::ImageSize full, double budget_ms);
  /// Tells that a frame of this size took so long.
  void measured(raster::ImageSize size, raster::ImageSize full, double ms);

 private:
  /// By how much each side of the picture is divided, a step each.
  static constexpr std::array<double, 9> divisors = {1, 1.5, 2, 3, 4, 6, 8, 12, 16};
  size_t step_ = 2;
  double ms_ = 0;  ///< that a frame of this step takes; 0: unknown
};

}  // namespace crsh::viewer
