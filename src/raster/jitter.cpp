#include "raster/jitter.h"

#include <cmath>

namespace crsh::raster {
namespace {

/// Reciprocals of the plastic number and of its square.
constexpr double r2_x = 0.7548776662466927, r2_y = 0.5698402909980532;

double fraction(double x) { return x - std::floor(x); }

/// A hash of the seed, 0 for seed 0 (the finaliser of MurmurHash3).
uint32_t mixed(uint32_t x) {
  x = (x ^ (x >> 16)) * 0x85EBCA6Bu;
  x = (x ^ (x >> 13)) * 0xC2B2AE35u;
  return x ^ (x >> 16);
}

}  // namespace

glm::vec2 jitter(uint32_t index, uint32_t seed) {
  if (index == 0) return glm::vec2(0);
  const double turn_x = mixed(seed) / 4294967296.0, turn_y = mixed(mixed(seed)) / 4294967296.0;
  return {float(fraction(0.5 + index * r2_x + turn_x) - 0.5), float(fraction(0.5 + index * r2_y + turn_y) - 0.5)};
}

}  // namespace crsh::raster
