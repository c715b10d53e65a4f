// Nodes, scenes, instances, cameras and lights.

#include <doctest/doctest.h>

#include <cmath>

#include "crsh/error.h"
#include "scene_file.h"

using namespace crsh;
using test::GltfText;
using test::one_triangle;

namespace {

GltfText with_nodes(const std::string& nodes, const std::string& scenes = R"("scenes":[{"nodes":[0]}])") {
  GltfText file = one_triangle();
  file.nodes = nodes;
  file.scenes = scenes;
  return file;
}

glm::vec3 origin_of(const glm::mat4& m) { return glm::vec3(m[3]); }

/// Of the scene's instance, in the file's coordinates.
glm::dvec3 place_of(const scene::Scene& scene, size_t instance) {
  return scene.origin + glm::dvec3(origin_of(scene.pose(0, {}).instances.at(instance)));
}

}  // namespace

TEST_CASE("transforms and matrices multiply down the hierarchy, children listed before their parents too") {
  const scene::Scene scene =
      with_nodes(
          R"({"children":[2],"translation":[1,2,3],"scale":[2,2,2]},{"mesh":0,"translation":[0,0,1]},
         {"matrix":[0,1,0,0,-1,0,0,0,0,0,1,0,10,0,0,1],"children":[1],"mesh":0})")
          .load();
  const scene::Pose pose = scene.pose(0, {});
  REQUIRE(pose.instances.size() == 2);
  CHECK(place_of(scene, 0) == glm::dvec3(21, 2, 3));
  CHECK(place_of(scene, 1) == glm::dvec3(21, 2, 5));
  const glm::vec3 origin(scene.origin);
  CHECK(glm::vec3(pose.instances[1] * glm::vec4(1, 0, 0, 1)) + origin == glm::vec3(21, 4, 5));
  const scene::Bounds bounds = scene.bounds(pose);
  CHECK(bounds.low + origin == glm::vec3(19, 2, 3));
  CHECK(bounds.high + origin == glm::vec3(21, 4, 5));
  CHECK(scene.meshes.size() == 1);
  CHECK(scene.triangle_count() == 2);
}

TEST_CASE("rotations that are not unit are made so, zero is none") {
  const scene::Scene scene =
      with_nodes(R"({"children":[1,2]},{"mesh":0,"rotation":[0,0,3,3]},{"mesh":0,"rotation":[0,0,0,0]})").load();
  const scene::Pose pose = scene.pose(0, {});
  CHECK(glm::distance(glm::vec3(pose.instances[0][0]), glm::vec3(0, 1, 0)) < 1e-6f);
  CHECK(pose.instances[1] == glm::mat4(1));
}

TEST_CASE("a scene is chosen by index or name, else the default one, else the first") {
  GltfText file = with_nodes(R"({"mesh":0},{"mesh":0,"translation":[5,0,0]})",
                             R"("scenes":[{"name":"left","nodes":[0]},{"name":"right","nodes":[1]}])");
  const auto x = [&](const std::string& which) { return place_of(file.load(which), 0).x; };
  CHECK(x("") == 0);
  CHECK(x("1") == 5);
  CHECK(x("right") == 5);
  CHECK(x("left") == 0);
  CHECK_THROWS_WITH_AS(x("middle"), doctest::Contains("choose one of 0 'left', 1 'right'"), UserError);
  file.scenes += R"(,"scene":1)";
  CHECK(x("") == 5);
  CHECK(file.load().name == "right");
  CHECK(file.load().scene_names == std::vector<std::string>{"left", "right"});
}

TEST_CASE("a file without scenes shows all its root nodes") {
  CHECK(with_nodes(R"({"mesh":0,"children":[1]},{"mesh":0},{"mesh":0})", R"("extras":0)").load().instances.size() == 3);
}

TEST_CASE("cameras come in the file's order, with their nodes") {
  GltfText file =
      with_nodes(R"({"children":[1,2]},{"camera":1,"name":"a"},{"camera":0,"name":"b","translation":[0,0,4]})");
  file.more = R"(,"cameras":[{"type":"perspective","perspective":{"yfov":0.5,"znear":0.1,"aspectRatio":2}},
                             {"name":"flat","type":"orthographic","orthographic":{"xmag":4,"ymag":2,"zfar":9,
"znear":0}}])";
  const scene::Scene scene = file.load();
  REQUIRE(scene.cameras.size() == 2);
  CHECK(scene.cameras[0].name == "b");
  CHECK(scene.cameras[0].yfov == 0.5f);
  CHECK(scene.cameras[0].aspect == 2.0f);
  CHECK(origin_of(scene.pose(0, {}).cameras[0]) == glm::vec3(0, 0, 4));
  CHECK(scene.cameras[1].orthographic);
  CHECK(scene.cameras[1].name == "flat");
  CHECK(scene.cameras[1].xmag == 4);
  CHECK(scene.cameras[1].ymag == 2);
}

TEST_CASE("punctual lights of all three types") {
  GltfText file = with_nodes(
      R"({"children":[1,2,3]},{"extensions":{"KHR_lights_punctual":{"light":0}},"translation":[1,0,0]},
         {"extensions":{"KHR_lights_punctual":{"light":1}}},{"extensions":{"KHR_lights_punctual":{"light":2}}})");
  file.more =
      R"(,"extensions":{"KHR_lights_punctual":{"lights":[{"type":"point","intensity":40,"range":9,"color":[1,0.5,0]},
    {"type":"spot","spot":{"innerConeAngle":0.1,"outerConeAngle":0.2}},{"type":"directional","name":"sun"}]}})";
  const scene::Scene scene = file.load();
  REQUIRE(scene.lights.size() == 3);
  CHECK(scene.lights[0].type == scene::LightType::point);
  CHECK(scene.lights[0].intensity == 40);
  CHECK(scene.lights[0].range == 9);
  CHECK(scene.lights[0].colour == glm::vec3(1, 0.5f, 0));
  CHECK(origin_of(scene.pose(0, {}).lights[0]) == glm::vec3(1, 0, 0));
  CHECK(scene.lights[1].type == scene::LightType::spot);
  CHECK(scene.lights[1].inner_cone == 0.1f);
  CHECK(scene.lights[1].outer_cone == 0.2f);
  CHECK(std::isinf(scene.lights[1].range));
  CHECK(scene.lights[2].type == scene::LightType::directional);
  CHECK(scene.lights[2].name == "sun");
}

TEST_CASE("a hundred thousand nested nodes are no trouble") {
  std::string nodes = R"({"mesh":0,"translation":[0,0,1]})";
  for (int i = 0; i < 100000; ++i) nodes += R"(,{"children":[)" + std::to_string(i) + R"(],"translation":[0,0,1]})";
  const scene::Scene scene = with_nodes(nodes, R"("scenes":[{"nodes":[100000]}])").load();
  CHECK(place_of(scene, 0).z == 100001);
}
