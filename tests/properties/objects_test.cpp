// No box of the object hierarchy rejects a ray that hits something in it.

#include <doctest/doctest.h>

#include <vector>

#include "shared/ray.h"
#include "support/cases_trace.h"
#include "support/device.h"

using namespace crsh;
using namespace crsh::test;

namespace {

using Triangles = std::vector<Triangle>;
using Rays = std::vector<shared::Ray>;

size_t count_different(const Triangles& triangles, const std::vector<Rays>& lists) {
  Tracer tracer(test::device());
  const scene::GpuScene scene = make_scene(tracer.recorder(), {{.triangles = triangles}});
  const SortedBatch rays = make_batch(test::device(), lists);
  return different_hits(tracer.trace_all(scene, rays), tracer.trace_single(scene, rays)).size();
}

Triangles moved(Triangles triangles, const glm::vec3& by) {
  for (Triangle& t : triangles) t = {t.a + by, t.b + by, t.c + by};
  return triangles;
}

/// Along one axis or within one plane of two, with zeros of both signs, from and to corners: in the planes of boxes.
Rays axis_rays(Random& random, const Triangles& triangles, size_t count) {
  Rays rays;
  while (rays.size() < count) {
    const glm::vec3 place = place_on(random, triangles[random.below(uint32_t(triangles.size()))]);
    glm::vec3 direction = random.unit();
    const int axis = int(random.below(3));
    if (random.below(2)) direction = glm::vec3(0), direction[axis] = random.below(2) ? 1.0f : -1.0f;
    else direction[axis] = random.below(2) ? 0.0f : -0.0f;
    const glm::vec3 unit = glm::normalize(direction);
    rays.push_back({glm::vec4(place - unit * random.scale(0.01f, 100), std::numeric_limits<float>::infinity()),
                    glm::vec4(unit, float(shared::kind_reflection))});
  }
  return rays;
}

}  // namespace

TEST_CASE("no hit on a hard triangle is culled, near or far from the origin") {
  for (const float distance : {0.0f, 100.0f, 1e4f})
    for (uint32_t seed = 1; seed <= 4; ++seed) {
      Random random(seed);
      const Triangles triangles = moved(hard_triangles(random, 300), random.unit() * distance);
      CAPTURE(distance);
      CAPTURE(seed);
      CHECK(count_different(triangles, {light_rays(random, triangles, 2000),
                                        mirror_rays(random, triangles, 2000, shared::kind_reflection),
                                        stray_rays(random, triangles, 2000, shared::kind_refraction)}) == 0);
    }
}

TEST_CASE("no hit is culled of rays along axes and in the planes of boxes") {
  for (const float distance : {0.0f, 1e4f}) {
    Random random(5);
    const Triangles flat = moved(wall(12), glm::vec3(distance)),
                    round = moved(closed_mesh(2, glm::vec3(0), 1), glm::vec3(distance)),
                    slivers = moved(hard_triangles(random, 300), glm::vec3(distance));
    for (const Triangles& triangles : {flat, round, slivers}) {
      CAPTURE(distance);
      CAPTURE(triangles.size());
      CHECK(count_different(triangles, {axis_rays(random, triangles, 4000)}) == 0);
    }
  }
}

TEST_CASE("no hit is culled of rays that come from very far away") {
  Random random(6);
  const Triangles triangles = closed_mesh(3, glm::vec3(0), 1);
  Rays rays;
  for (int i = 0; i < 4000; ++i)
    rays.push_back(ray_between(random.unit() * random.scale(1e3f, 1e7f),
                               place_on(random, triangles[random.below(uint32_t(triangles.size()))]),
                               shared::kind_reflection));
  CHECK(count_different(triangles, {rays}) == 0);
}
