#pragma once
// Random triangles and rays that are hard to treat right, the same on every machine for one seed.

#include <cstdint>
#include <glm/glm.hpp>
#include <random>
#include <vector>

#include "support/twin.h"

namespace crsh::test {

/// Numbers from a seed; only std::mt19937 itself, whose output the standard fixes.
class Random {
 public:
  explicit Random(uint32_t seed) : engine_(seed) {}
  [[nodiscard]] uint32_t below(uint32_t n) { return static_cast<uint32_t>(engine_() % n); }
  [[nodiscard]] float uniform(float low, float high) { return low + (high - low) * float(engine_() >> 8) * 0x1p-24f; }
  /// Evenly over the orders of magnitude.
  [[nodiscard]] float scale(float low, float high);
  [[nodiscard]] glm::vec3 point(float size) {
    return {uniform(-size, size), uniform(-size, size), uniform(-size, size)};
  }
  [[nodiscard]] glm::vec3 unit();

 private:
  std::mt19937 engine_;
};

/// Slivers, points, huge (1e4) and tiny (1e-5) ones, axis-aligned, near-degenerate, and some far (1e4) from the origin.
[[nodiscard]] std::vector<Triangle> hard_triangles(Random& random, size_t count);

/// A sphere of triangles without a gap: an icosahedron whose faces are split `splits` times.
[[nodiscard]] std::vector<Triangle> closed_mesh(uint32_t splits, const glm::vec3& centre, float radius);

/// A wall of 2 n² triangles across z = 0, from -1 to 1.
[[nodiscard]] std::vector<Triangle> wall(uint32_t n);

/// A place in the triangle: often a corner, a point of an edge, or the inside.
[[nodiscard]] glm::vec3 place_on(Random& random, const Triangle& triangle);

/// From a to b; tmax is `reach` times their distance. `kind` is one of shared::kind_*.
[[nodiscard]] shared::Ray ray_between(const glm::vec3& a, const glm::vec3& b, uint32_t kind,
                                      float reach = std::numeric_limits<float>::infinity());

/// Rays of one light: one origin, aimed at the triangles, ending before, just behind or far behind them.
[[nodiscard]] std::vector<shared::Ray> light_rays(Random& random, const std::vector<Triangle>& triangles, size_t count);
/// Rays as off a mirror: neighbouring origins, aimed at and about the triangles, without end.
[[nodiscard]] std::vector<shared::Ray> mirror_rays(Random& random, const std::vector<Triangle>& triangles, size_t count,
                                                   uint32_t kind);
/// Rays from anywhere: aimed at triangles, along their planes, and at random.
[[nodiscard]] std::vector<shared::Ray> stray_rays(Random& random, const std::vector<Triangle>& triangles, size_t count,
                                                  uint32_t kind);

}  // namespace crsh::test
