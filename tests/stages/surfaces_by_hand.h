#pragma once
// Surfaces without a scene, for the stages that start from them.

#include <bit>
#include <vector>

#include "gpu/buffer.h"
#include "support/cases.h"
#include "support/device.h"
#include "surfaces/surfaces.h"

namespace crsh::test {

/// One point to shade; rays came along `incoming` from a unit vector's way.
struct Point {
  uint32_t triangle = 0;
  glm::vec3 position{0}, normal{0, 0, 1}, geometric{0, 0, 1}, incoming{0, 0, -1};
  glm::vec3 diffuse{0.5f}, specular{0.04f}, emission{0};
  float transmission = 0, roughness = 0, eta = 1;
  uint32_t pixel = 0, path = 1;
};

struct HandMade {
  surfaces::Surfaces surfaces;
  surfaces::Generation generation;
};

inline HandMade upload_points(const std::vector<Point>& points) {
  std::vector<glm::vec4> position, normal, geometric, incoming, diffuse, specular, emission;
  for (Point p : points) {
    if (p.triangle == shared::none) p.normal = p.geometric = p.diffuse = p.specular = p.emission = glm::vec3(0);
    position.emplace_back(p.position, std::bit_cast<float>(p.triangle));
    normal.emplace_back(p.normal, p.transmission);
    geometric.emplace_back(p.geometric, p.roughness);
    incoming.emplace_back(p.incoming, p.eta);
    diffuse.emplace_back(p.diffuse, std::bit_cast<float>(p.pixel));
    specular.emplace_back(p.specular, std::bit_cast<float>(p.path));
    emission.emplace_back(p.emission, p.triangle == shared::none ? -1.0f : 0.04f);
  }
  HandMade made;
  gpu::Device& d = device();
  made.surfaces = {gpu::upload(d, position, "position"),
                   gpu::upload(d, normal, "normal"),
                   gpu::upload(d, geometric, "geometric"),
                   gpu::upload(d, incoming, "incoming"),
                   gpu::upload(d, diffuse, "diffuse"),
                   gpu::upload(d, specular, "specular"),
                   gpu::upload(d, std::vector<glm::vec2>(points.size(), {0, 1}), "footprints"),
                   gpu::upload(d, std::vector<glm::vec4>(1, glm::vec4(0)), "no lobes"),
                   uint32_t(points.size())};
  made.generation.emission = gpu::upload(d, emission, "emission");
  made.generation.direct = gpu::upload(d, std::vector<glm::vec4>(points.size(), glm::vec4(0)), "direct");
  made.generation.count = uint32_t(points.size());
  return made;
}

/// Anything a ray may find: any side, tilted shading normals, glass that bends, and here and there nothing.
inline std::vector<Point> random_points(Random& random, size_t count) {
  std::vector<Point> points(count);
  for (Point& p : points) {
    p.triangle = random.below(8) == 0 ? shared::none : random.below(100);
    p.position = random.point(random.scale(0.1f, 1000));
    p.geometric = random.unit();
    p.incoming = random.unit();
    if (glm::dot(p.incoming, p.geometric) > 0) p.incoming = -p.incoming;
    p.normal = glm::normalize(p.geometric + 0.6f * random.unit());
    if (glm::dot(p.normal, p.incoming) > -1e-3f) p.normal = p.geometric;
    p.diffuse = glm::vec3(random.uniform(0, 1), random.uniform(0, 1), random.uniform(0, 1));
    p.specular = random.below(2) ? glm::vec3(0.04f) : p.diffuse;
    p.roughness = random.below(2) ? 0.0f : random.uniform(0, 1);
    p.transmission = random.below(2) ? 0.0f : random.uniform(0, 1);
    if (p.transmission > 0) p.eta = std::vector<float>{1.0f, 1 / 1.5f, 1.5f}[random.below(3)];
  }
  return points;
}

}  // namespace crsh::test
