// What the layers of a picture mean, and that asking for them changes nothing else.

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string>

#include "support/device.h"
#include "support/kinds.h"
#include "support/render.h"

namespace crsh::test {
namespace {

RenderOptions small() {
  RenderOptions options;
  options.width = 40;
  options.height = 30;
  options.bounces = 2;
  options.layers = LayerSet::all();
  return options;
}

double sum_of(const Picture& picture, const std::string& layer) {
  const std::vector<float>& values = picture.find(layer)->values;
  return std::accumulate(values.begin(), values.end(), 0.0);
}

/// The picture without what the algorithm needed for it.
Picture without_tests(Picture picture) {
  std::erase_if(picture.layers, [](const Layer& layer) { return layer.name.starts_with("Tests."); });
  return picture;
}

TEST_SUITE_BEGIN("subset");

TEST_CASE("all layers of a picture are rendered without a validation message") {
  RenderOptions options = small();
  options.width = 12;
  options.height = 9;
  const Picture picture = render(own_scene("glass"), options).picture;
  CHECK(picture.layers.size() == layer_count);
  CHECK(device().validation_messages() == 0);
}

TEST_SUITE_END();

void check_parts(const Picture& picture) {
  const std::vector<float>& beauty = picture.find("")->values;
  for (size_t i = 0; i < beauty.size(); ++i) {
    if (i % 4 == 3) continue;
    double sum = 0;
    for (const char* part : {"Direct", "Emission", "Reflection", "Refraction", "Background"})
      sum += picture.find(part)->values[i / 4 * 3 + i % 4];
    CHECK(sum == doctest::Approx(beauty[i]).epsilon(1e-5));
  }
}

TEST_CASE("the parts of light add up to the beauty, and all of them are there") {
  RenderOptions options = small();
  options.samples = 3;
  options.background = {0.25f, 0.5f, 2};
  const Picture moving = render(own_scene("moving"), options).picture;
  options.samples = 1;
  const Picture glass = render(own_scene("glass"), options).picture,
                office = render(own_scene("office"), options).picture;
  for (const Picture* picture : {&moving, &glass, &office}) check_parts(*picture);
  for (const char* part : {"Direct", "Background"}) CHECK(sum_of(moving, part) > 1);
  for (const char* part : {"Reflection", "Refraction"}) CHECK(sum_of(glass, part) > 1);
  CHECK(sum_of(office, "Emission") > 1);
}

TEST_CASE("a transparent background is no light") {
  RenderOptions options = small();
  options.background.reset();
  const Picture picture = render(own_scene("moving"), options).picture;
  check_parts(picture);
  CHECK(sum_of(picture, "Background") == 0);
}

TEST_CASE("P is where Z and the camera say, and 0 where nothing is") {
  const Picture picture = render(own_scene("moving"), small()).picture;
  const std::vector<float>&p = picture.find("P")->values, &z = picture.find("Z")->values;
  size_t met = 0;
  for (size_t pixel = 0; pixel < z.size(); ++pixel) {
    const glm::vec3 point(p[pixel * 3], p[pixel * 3 + 1], p[pixel * 3 + 2]);
    if (z[pixel] == 1e10f) {
      CHECK(point == glm::vec3(0));
      continue;
    }
    ++met;
    CHECK((picture.world_to_camera * glm::dvec4(point, 1)).z == doctest::Approx(z[pixel]).epsilon(1e-5));
    const glm::dvec4 at = picture.world_to_ndc * glm::dvec4(point, 1);
    CHECK(at.x / at.w * 40 == doctest::Approx(pixel % 40 + 0.5).epsilon(1e-3));
    CHECK(at.y / at.w * 30 == doctest::Approx(pixel / 40 + 0.5).epsilon(1e-3));
  }
  CHECK(met > 100);
  CHECK(met < z.size());
}

TEST_CASE("ids are 0 exactly where nothing is, and name instances and materials from 1 on") {
  const scene::Scene& scene = own_scene("moving");
  const Picture picture = render(scene, small()).picture;
  const std::vector<uint32_t>&objects = picture.find("Object")->ids, &materials = picture.find("Material")->ids;
  const std::vector<float>& z = picture.find("Z")->values;
  for (size_t pixel = 0; pixel < z.size(); ++pixel) {
    CHECK((objects[pixel] == 0) == (z[pixel] == 1e10f));
    CHECK((materials[pixel] == 0) == (z[pixel] == 1e10f));
  }
  CHECK(std::ranges::max(objects) <= scene.instances.size());
  CHECK(std::ranges::max(materials) <= scene.materials.size());
  std::vector<uint32_t> different = objects;
  std::ranges::sort(different);
  CHECK(std::unique(different.begin(), different.end()) - different.begin() > 3);
}

TEST_CASE("Shadow is between 0 and 1, reaches both, and is above 0 where light arrives") {
  const Picture picture = render(own_scene("cornell"), small()).picture;
  const std::vector<float>& shadow = picture.find("Shadow")->values;
  CHECK(std::ranges::min(shadow) == 0);
  CHECK(std::ranges::max(shadow) == 1);
  const std::vector<float>& direct = picture.find("Direct")->values;
  for (size_t pixel = 0; pixel < shadow.size(); ++pixel)
    if (direct[pixel * 3] > 0) CHECK(shadow[pixel] > 0);
}

TEST_CASE("without shadow rays nothing is visible from a lamp") {
  RenderOptions options = small();
  options.rays[shared::kind_shadow] = false;
  CHECK(sum_of(render(own_scene("cornell"), options).picture, "Shadow") == 0);
}

/// Each pixel is rounded to a float once.
void check_tests(const Rendered& rendered) {
  uint64_t triangle = 0, node = 0, object = 0;
  for (const RayStatistics& row : rendered.statistics.rays) {
    triangle += row.triangle_tests;
    node += row.paper_tests() - row.triangle_tests;
    object += row.object_tests();
  }
  CHECK(sum_of(rendered.picture, "Tests.triangle") == doctest::Approx(double(triangle)).epsilon(1e-7));
  CHECK(sum_of(rendered.picture, "Tests.node") == doctest::Approx(double(node)).epsilon(1e-7));
  CHECK(sum_of(rendered.picture, "Tests.object") == doctest::Approx(double(object)).epsilon(1e-7));
}

TEST_CASE("the tests of all pixels add up to the counters, by every algorithm") {
  RenderOptions options = small();
  options.width = 24, options.height = 18, options.samples = 2;
  for (const std::string& name : preset_names())
    for (const char* scene : {"glass", "cornell"}) {
      CAPTURE(name);
      CAPTURE(scene);
      check_tests(render_with(name, own_scene(scene), options));
    }
}

TEST_CASE("the tests of all pixels add up to the counters however rays are bundled and shared out") {
  RenderOptions options = small();
  options.algorithm = preset("crsh");
  options.algorithm.arity = 3;
  options.algorithm.levels = in_turn<uint32_t>({5, 2, 1});
  check_tests(render(own_scene("glass"), options));
  options.algorithm.mixed_batches = false;
  options.algorithm.ray_order = RayOrder::tiles;
  options.submit_work = 1 << 16;
  check_tests(render(own_scene("glass"), options));
}

TEST_CASE("all layers but Tests are bit-identical between algorithms, and between two runs these too") {
  RenderOptions options = small();
  options.width = 24, options.height = 18;
  const Rendered ours = render_with("crsh", own_scene("glass"), options);
  for (const std::string& name : preset_names()) {
    CAPTURE(name);
    CHECK(difference(without_tests(ours.picture),
                     without_tests(render_with(name, own_scene("glass"), options).picture)) == "");
  }
  CHECK(difference(ours, render_with("crsh", own_scene("glass"), options)) == "");
}

TEST_CASE("asking for layers changes neither the others nor a counter") {
  RenderOptions options = small();
  options.width = 16, options.height = 12;
  const auto with = [&](const LayerSet& layers) {
    return options.layers = layers, render(own_scene("glass"), options);
  };
  const Rendered all = with(LayerSet::all()), beauty = with({});
  CHECK(beauty.picture.layers.size() == 1);
  CHECK(beauty.picture.find("")->values == all.picture.find("")->values);
  CHECK(difference_of_counters(all.statistics, beauty.statistics) == "");
  for (size_t third = 0; third < 3; ++third) {
    LayerSet some;
    for (size_t id = third; id < layer_count; id += 3) some.add(LayerId(id));
    for (const Layer& layer : with(some).picture.layers) {
      CAPTURE(layer.name);
      CHECK(layer.values == all.picture.find(layer.name)->values);
      CHECK(layer.ids == all.picture.find(layer.name)->ids);
    }
  }
}

}  // namespace
}  // namespace crsh::test
