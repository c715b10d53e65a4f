// What a node or a primitive says besides: many instances, out of sight, other materials.

#include <doctest/doctest.h>

#include "scene_file.h"

using namespace crsh;
using test::Folder;
using test::GltfText;
using test::one_triangle;

namespace {

GltfText with_variants() {
  GltfText file = one_triangle();
  file.primitives = R"({"attributes":{"POSITION":0},"material":0,"extensions":{"KHR_materials_variants":{"mappings":[
{"material":1,"variants":[0,2]},{"material":2,"variants":[1]}]}}})";
  file.more =
      R"(,"materials":[{},{},{}],"extensions":{"KHR_materials_variants":{"variants":[{"name":"red"},{"name":"0"},
{"name":"blue"},{"name":"plain"}]}})";
  return file;
}

uint32_t material_in(const std::string& variant) {
  const Folder folder;
  const auto path = folder.write("scene.gltf", with_variants().gltf());
  return scene::load(path, scene::LoadOptions{.variant = variant}).meshes.at(0).materials.at(0);
}

}  // namespace

TEST_CASE("a variant by name or index chooses the materials of primitives; names come first") {
  CHECK(material_in("") == 0);
  CHECK(material_in("red") == 1);
  CHECK(material_in("blue") == 1);
  CHECK(material_in("0") == 2);
  CHECK(material_in("2") == 1);
  CHECK(material_in("plain") == 0);
  CHECK_THROWS_WITH((void)material_in("green"), doctest::Contains("choose one of 0 'red', 1 '0', 2 'blue', 3 'plain'"));
  CHECK(with_variants().load().variants == std::vector<std::string>{"red", "0", "blue", "plain"});
}

TEST_CASE("each element of EXT_mesh_gpu_instancing is an instance, moved within its node") {
  GltfText file = one_triangle();
  file.values<float>("VEC3", 5126, 2, {1, 0, 0, 0, 2, 0});
  file.values<int8_t>("VEC4", 5120, 2, {0, 0, 0, 127, 0, 0, 127, 0}, R"(,"normalized":true)");
  file.values<float>("VEC3", 5126, 2, {1, 1, 1, 3, 3, 3});
  file.nodes = R"({"mesh":0,"translation":[10,0,0],"extensions":{"EXT_mesh_gpu_instancing":{"attributes":{
"TRANSLATION":1,"ROTATION":2,"SCALE":3,"_ID":0}}}})";
  const scene::Scene scene = file.load();
  const scene::Pose pose = scene.pose(0, {});
  REQUIRE(pose.instances.size() == 2);
  CHECK(glm::vec3(pose.instances[0][3]) == glm::vec3(11, 0, 0));
  CHECK(glm::vec3(pose.instances[1][3]) == glm::vec3(10, 2, 0));
  CHECK(pose.instances[1][0].x == doctest::Approx(-3));
  CHECK(scene.triangle_count() == 2);
}

TEST_CASE("what hangs below a node that is not visible is not drawn and gives no light; cameras see all the same") {
  GltfText file = one_triangle();
  file.nodes = R"({"children":[1,2],"extensions":{"KHR_node_visibility":{"visible":false}}},{"mesh":0,
"extensions":{"KHR_node_visibility":{"visible":true}}},{"camera":0,"extensions":{"KHR_lights_punctual":{"light":0}}},
{"mesh":0,"extensions":{"KHR_node_visibility":{}}})";
  file.scenes = R"("scenes":[{"nodes":[0,3]}])";
  file.more = R"(,"cameras":[{"type":"perspective","perspective":{"yfov":1,"znear":1,"zfar":7}}],
"extensions":{"KHR_lights_punctual":{"lights":[{"type":"point"}]}})";
  const scene::Scene scene = file.load();
  CHECK(scene.instances.size() == 1);
  CHECK(scene.pose(0, {}).changes.lights.at(0).intensity == 0);
  CHECK(scene.cameras.at(0).far_plane == 7.0f);
}
