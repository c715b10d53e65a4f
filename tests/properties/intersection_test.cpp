// Closed surfaces have no gaps.

#include <doctest/doctest.h>

#include <algorithm>
#include <vector>

#include "shared/limits.h"
#include "support/cases_trace.h"
#include "support/device.h"

using namespace crsh;
using namespace crsh::test;

namespace {

/// At corners and edges, from inside.
std::vector<shared::Ray> seam_rays(Random& random, const std::vector<Triangle>& mesh, const glm::vec3& centre,
                                   float radius, uint32_t count) {
  std::vector<shared::Ray> rays;
  while (rays.size() < count) {
    const Triangle& triangle = mesh[random.below(uint32_t(mesh.size()))];
    const glm::vec3 seam = random.below(2) ? triangle.a : glm::mix(triangle.a, triangle.b, random.uniform(0, 1));
    rays.push_back(
        ray_between(centre + random.unit() * radius * random.uniform(0, 0.5f), seam, shared::kind_reflection));
  }
  return rays;
}

uint32_t count_misses(const std::vector<Triangle>& mesh, const std::vector<shared::Ray>& rays) {
  Tracer tracer(test::device());
  const scene::GpuScene scene = make_scene(tracer.recorder(), {{.triangles = mesh}});
  const Traced traced = tracer.trace_all(scene, make_batch(test::device(), {rays}));
  return uint32_t(std::ranges::count_if(traced.hits, [](const glm::uvec4& hit) { return hit.y == shared::none; }));
}

}  // namespace

TEST_CASE("no ray leaves a closed mesh through an edge or a corner, small or large, near or far from the origin") {
  for (const auto& [distance, radius] :
       {std::pair{0.0f, 1.0f}, {0.0f, 1e-5f}, {0.0f, 1e4f}, {10.0f, 0.1f}, {1e4f, 100.0f}, {1e4f, 1.0f}})
    for (const uint32_t splits : {0u, 2u}) {
      Random random(splits + 1);
      const glm::vec3 centre = random.unit() * distance;
      const std::vector<Triangle> mesh = closed_mesh(splits, centre, radius);
      CAPTURE(distance);
      CAPTURE(radius);
      CAPTURE(splits);
      CHECK(count_misses(mesh, seam_rays(random, mesh, centre, radius, 4000)) == 0);
    }
}

TEST_CASE("no ray slips between the triangles of a wall that it grazes") {
  Random random(7);
  const std::vector<Triangle> triangles = wall(16);
  std::vector<shared::Ray> rays;
  for (uint32_t i = 0; i < 8000; ++i) {
    const Triangle& triangle = triangles[random.below(512)];
    const glm::vec3 seam = random.below(2) ? triangle.a : glm::mix(triangle.a, triangle.c, random.uniform(0, 1));
    if (std::max(std::abs(seam.x), std::abs(seam.y)) > 0.9f) continue;  // not the wall's own border
    const glm::vec3 along =
        glm::normalize(glm::vec3(random.uniform(-1, 1), random.uniform(-1, 1), random.scale(1e-4f, 1)));
    rays.push_back(ray_between(seam + along * random.scale(0.1f, 10), seam, shared::kind_reflection));
  }
  CHECK(count_misses(triangles, rays) == 0);
}
