// Scenes far from the file's origin, and walls whose backs the eye looks past.

#include <doctest/doctest.h>

#include "images/built_scene.h"
#include "scene/origin.h"
#include "support/device.h"
#include "support/render.h"

namespace crsh::test {
namespace {

/// A box of a metre on a floor of six, moved by its node.
scene::Scene box_on_floor(const glm::dvec3& by) {
  Triangles t;
  t.add_quad({-3, 0, 3}, {3, 0, 3}, {3, 0, -3}, {-3, 0, -3});
  for (const float x : {-0.5f, 0.5f}) t.add_quad({x, 0, -0.5f}, {x, 1, -0.5f}, {x, 1, 0.5f}, {x, 0, 0.5f});
  for (const float z : {-0.5f, 0.5f}) t.add_quad({-0.5f, 0, z}, {-0.5f, 1, z}, {0.5f, 1, z}, {0.5f, 0, z});
  t.add_quad({-0.5f, 1, 0.5f}, {0.5f, 1, 0.5f}, {0.5f, 1, -0.5f}, {-0.5f, 1, -0.5f});
  scene::Scene scene = built_scene(t, {matt(glm::vec3(0.5f))});
  scene.nodes[0].transform.translation = by;
  scene::choose_origin(scene);
  return scene;
}

RenderOptions seen(const glm::dvec3& by) {
  RenderOptions options;
  options.width = options.height = 48;
  options.bounces = 1;
  options.override_mirror = true;
  options.view.eye = by + glm::dvec3(2.5, 5, 4.25);
  options.view.target = by;
  options.lights = {{by + glm::dvec3(4, 5, 1), 30.0f}};
  options.layers = {LayerId::normal, LayerId::depth, LayerId::shadow, layer_named("P")};
  return options;
}

TEST_CASE("subset: a scene moved by a round number gives the same picture, bit for bit, and P where it is") {
  const Rendered here = render(box_on_floor({}), seen({}));
  const glm::dvec3 by(131072, -1024, 98304);
  Rendered there = render(box_on_floor(by), seen(by));
  CHECK(difference_of_hits(here.statistics, there.statistics) == "");
  const std::vector<float>&p = here.picture.find("P")->values, &z = here.picture.find("Z")->values;
  for (Layer& layer : there.picture.layers) {
    if (layer.name != "P") CHECK(layer.values == here.picture.find(layer.name)->values);
    for (size_t i = 0; layer.name == "P" && i < p.size(); ++i)
      CHECK(layer.values[i] == (z[i / 3] == 1e10f ? 0 : float(double(p[i]) + by[int(i % 3)])));
  }
  const glm::dvec4 target = there.picture.world_to_ndc * glm::dvec4(by, 1);
  CHECK(target.x / target.w == doctest::Approx(0.5));
}

TEST_CASE("shadows are there at 100 km, by every preset alike") {
  const glm::dvec3 by(100000, 0, -100000);
  const Rendered here = render(box_on_floor({}), seen({}));
  const uint64_t hits = rays_of(here.statistics, "shadow", 0).hits;
  CHECK(hits > 20);
  const scene::Scene far = box_on_floor(by);
  for (const std::string& name : preset_names()) {
    CAPTURE(name);
    CHECK(rays_of(render_with(name, far, seen(by)).statistics, "shadow", 0).hits == hits);
  }
}

TEST_CASE("rays of a far scene are dumped from its centre, and replayed from anywhere") {
  const glm::dvec3 by(131072, 0, 0);
  const scene::Scene far = box_on_floor(by);
  RayTable rays, again;
  Renderer renderer(borrowed(device()), borrowed(far), seen(by));
  (void)renderer.render(0, {}, &rays);
  CHECK(rays.centre == by);
  renderer.replay(rays, 0, &again);
  CHECK(again.transmittance == rays.transmittance);
  CHECK(again.hit == rays.hit);
  rays.centre -= glm::dvec3(16, 0, 0);
  for (glm::vec3& origin : rays.origin) origin.x += 16;
  RayTable moved;
  renderer.replay(rays, 0, &moved);
  CHECK(moved.centre == by);
  CHECK(glm::distance(moved.origin[0], again.origin[0]) < 1e-5f);
}

/// A room with single-sided walls that face inwards, a floor and a roof, all around.
scene::Scene dolls_house() {
  Triangles t;
  t.add_quad({-2, 0, 2}, {2, 0, 2}, {2, 0, -2}, {-2, 0, -2});
  t.add_quad({-2, 2, -2}, {2, 2, -2}, {2, 2, 2}, {-2, 2, 2});
  t.add_quad({-2, 0, -2}, {2, 0, -2}, {2, 2, -2}, {-2, 2, -2});
  t.add_quad({2, 0, 2}, {-2, 0, 2}, {-2, 2, 2}, {2, 2, 2});
  t.add_quad({-2, 0, 2}, {-2, 0, -2}, {-2, 2, -2}, {-2, 2, 2});
  t.add_quad({2, 0, -2}, {2, 0, 2}, {2, 2, 2}, {2, 2, -2});
  scene::Material wall = matt(glm::vec3(0.6f));
  wall.double_sided = false;
  return built_scene(t, {wall});
}

TEST_CASE("subset: the chosen light shines past the backs that the eye looks past, by every preset alike") {
  const scene::Scene house = dolls_house();
  RenderOptions options;
  options.width = options.height = 32;
  const Rendered lit = render(house, options);
  const std::vector<float>& beauty = lit.picture.find("")->values;
  size_t light = 0, seen_pixels = 0;
  for (size_t i = 0; i < beauty.size(); i += 4) {
    seen_pixels += lit.picture.find("Z")->values[i / 4] != 1e10f;
    light += beauty[i] > 0;
  }
  CHECK(seen_pixels > 300);
  CHECK(light == seen_pixels);
  for (const std::string& name : preset_names()) {
    CAPTURE(name);
    CHECK(difference(render_with(name, house, options), lit) == "");
  }
}

TEST_CASE("the chosen light as an option gives the same picture, and without past-backs walls block it") {
  const scene::Scene house = dolls_house();
  RenderOptions options;
  options.width = options.height = 32;
  const Rendered chosen = render(house, options);
  Renderer renderer(borrowed(device()), borrowed(house), options);
  options.lights = renderer.chosen_lights();
  REQUIRE(options.lights.size() == 1);
  CHECK(options.lights[0].past_backs);
  CHECK(difference(render(house, options), chosen) == "");
  options.lights[0].past_backs = false;
  const RayStatistics blocked = rays_of(render(house, options).statistics, "shadow", 0);
  CHECK(blocked.hits == blocked.count);
}

}  // namespace
}  // namespace crsh::test
