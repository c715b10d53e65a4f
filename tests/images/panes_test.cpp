// Glass behind glass: what is seen and what shadows fall through it do not depend on the order of triangles.

#include <doctest/doctest.h>

#include <algorithm>
#include <random>

#include "images/built_scene.h"
#include "support/render.h"

namespace crsh::test {
namespace {

scene::Material glass(glm::vec3 colour) {
  scene::Material material = matt(colour);
  material.transmission = 1;
  material.roughness = 0;
  return material;
}

/// A pane of many triangles, leaning a little.
void add_pane(Triangles& triangles, float z, uint32_t material) {
  constexpr int cells = 7;
  const auto at = [&](int i, int j) {
    return glm::vec3(-1 + 2.0f * i / cells, -0.9f + 1.9f * j / cells, z + 0.11f * i / cells + 0.07f * j / cells);
  };
  for (int i = 0; i < cells; ++i)
    for (int j = 0; j < cells; ++j)
      triangles.add_quad(at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1), material);
}

/// A floor, and a wall behind three panes.
Triangles panes() {
  Triangles triangles;
  triangles.add_quad({-3, -1, 3}, {3, -1, 3}, {3, -1, -3}, {-3, -1, -3});
  triangles.add_quad({-3, -1, -2}, {3, -1, -2.1f}, {3, 3, -2}, {-3, 3, -2.2f});
  for (uint32_t pane = 0; pane < 3; ++pane) add_pane(triangles, -0.8f + 0.6f * float(pane), 1 + pane);
  return triangles;
}

Triangles shuffled(Triangles triangles, uint32_t seed) {
  std::mt19937 random(seed);
  for (size_t i = triangles.triangles.size() - 1; i > 0; --i) {
    const size_t other = random() % (i + 1);
    std::swap(triangles.triangles[i], triangles.triangles[other]);
    std::swap(triangles.materials[i], triangles.materials[other]);
  }
  return triangles;
}

Picture picture_of(const Triangles& triangles) {
  RenderOptions options;
  options.width = options.height = 96;
  options.view.eye = {0.63f, 0.41f, 3.57f};
  options.view.target = {0.02f, -0.13f, 0};
  options.lights = {{{0.7f, 1.9f, 2.3f}, 30.0f}, {{-1.3f, 2.2f, -1.6f}, 20.0f}};
  const scene::Scene scene = built_scene(triangles, {matt({0.8f, 0.8f, 0.7f}), glass({0.9f, 0.5f, 0.4f}),
                                                     glass({0.5f, 0.9f, 0.5f}), glass({0.4f, 0.6f, 0.9f})});
  return render(scene, options).picture;
}

TEST_CASE("three panes behind one another give the same bytes with their triangles shuffled") {
  const Picture ordered = picture_of(panes());
  for (uint32_t seed = 1; seed <= 3; ++seed) CHECK(difference(ordered, picture_of(shuffled(panes(), seed))) == "");
}

}  // namespace
}  // namespace crsh::test
