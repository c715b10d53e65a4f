// What animations change besides places: materials, lights, visibility.

#include <doctest/doctest.h>

#include "images/built_scene.h"
#include "scene/properties.h"
#include "support/device.h"
#include "support/render.h"

namespace crsh::test {
namespace {

constexpr uint32_t base_colour = 0;  // a row of scene::material_properties

/// A floor with a pane above it, in two instances, under a light.
scene::Scene pane_above_floor() {
  Triangles triangles;
  triangles.add_quad({-2, 0, 2}, {2, 0, 2}, {2, 0, -2}, {-2, 0, -2});
  scene::Scene scene = built_scene(triangles, {matt(glm::vec3(0.8f)), matt(glm::vec3(0.2f, 0.9f, 0.4f))});
  Triangles pane;
  pane.add_quad({-0.6f, 0.7f, 0.6f}, {0.6f, 0.7f, 0.6f}, {0.6f, 0.7f, -0.6f}, {-0.6f, 0.7f, -0.6f}, 1);
  scene::Scene other = built_scene(pane, {matt(glm::vec3(1)), matt(glm::vec3(1))});
  scene.meshes.push_back(other.meshes.front());
  scene.nodes.resize(2);
  scene.instances = {{0, 0}, {1, 1}};
  return scene;
}

RenderOptions seen() {
  RenderOptions options;
  options.width = 40, options.height = 30, options.bounces = 1;
  options.view.eye = glm::vec3(1.4f, 1.9f, 2.4f), options.view.target = glm::vec3(0, 0.3f, 0);
  options.lights = {{glm::vec3(0.3f, 2.5f, 0.2f), 20.0f}};
  return options;
}

/// An animation of one channel from second 0 to second 2.
void animate(scene::Scene& scene, const scene::Target& target, const std::vector<float>& values) {
  scene::Animation animation;
  animation.channels.push_back({target, scene::Interpolation::linear, uint32_t(values.size() / 2), {0, 2}, values});
  scene.animations.push_back(std::move(animation));
}

TEST_CASE("a frame in which an animation changes a material is as a scene that has it so, by every algorithm") {
  scene::Scene moving = pane_above_floor(), still = pane_above_floor();
  animate(moving, {scene::Driven::material, 1, scene::material_transmission}, {0, 1});
  animate(moving, {scene::Driven::material, 1, base_colour}, {1, 0, 0, 1, 0.5f, 1, 0, 1});
  moving.materials[1].may_transmit = true;
  still.materials[1].transmission = 0.5f;
  still.materials[1].base_colour = {0.75f, 0.5f, 0, 1};
  const Picture wanted = render(still, seen()).picture;
  for (const std::string& name : {"crsh-bvh", "crsh", "brute"})
    CHECK(difference(wanted, render_with(name, moving, seen(), 1).picture) == "");
}

TEST_CASE("a material is the file's again in a frame that does not change it") {
  scene::Scene moving = pane_above_floor();
  animate(moving, {scene::Driven::material, 0, base_colour}, {1, 0, 0, 1, 0, 0, 1, 1});
  Renderer renderer(borrowed(device()), borrowed(moving), seen());
  const Picture start = renderer.render(0);
  CHECK(difference(start, renderer.render(1.5)) != "");
  CHECK(difference(start, renderer.render(0)) == "");
}

TEST_CASE("what an animation hides casts no shadow and is seen by no ray") {
  scene::Scene moving = pane_above_floor(), without = pane_above_floor();
  animate(moving, {scene::Driven::node, 1, scene::node_visible}, {1, 0});
  without.instances.pop_back();
  const Picture empty = render(without, seen()).picture, whole = render(pane_above_floor(), seen()).picture;
  for (const std::string& name : {"crsh-bvh", "bvh", "crsh", "brute"}) {
    CHECK(difference(whole, render_with(name, moving, seen(), 0).picture) == "");
    // Only the light: the camera's near end is chosen by what the scene holds at time 0.
    CHECK(empty.find("")->values == render_with(name, moving, seen(), 2).picture.find("")->values);
  }
}

}  // namespace
}  // namespace crsh::test
