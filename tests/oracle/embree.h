#pragma once
// Embree, an independent ray tracer, version 3 or 4.

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "oracle/geometry.h"

namespace crsh::test {

struct OracleRay {
  glm::vec3 origin{0}, direction{0};
  float tmax = 0;
};

struct Crossing {
  uint32_t triangle = 0;
  float t = 0;
  glm::dvec2 weights{0};  ///< of the corners b and c
};

/// Its scene of these triangles, which must outlive it. Robust: no ray slips between triangles.
class Embree {
 public:
  explicit Embree(std::span<const OracleTriangle> triangles);
  ~Embree();

  /// The nearest triangle whose front the ray meets, or whose back, where that does not let it pass; where
  /// alpha leaves it there.
  [[nodiscard]] std::optional<Crossing> closest(const OracleRay& ray) const;
  /// Every triangle on the ray's way, once each, whatever its alpha.
  [[nodiscard]] std::vector<Crossing> all(const OracleRay& ray) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace crsh::test
