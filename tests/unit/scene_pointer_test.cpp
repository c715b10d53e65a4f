// KHR_animation_pointer and KHR_node_visibility: what of a scene animations change besides places.

#include <doctest/doctest.h>

#include "scene/device/device_materials.h"
#include "scene/device/world_lights.h"
#include "scene_file.h"

using namespace crsh;
using test::GltfText;

namespace {

/// A file with a camera, two lights' nodes of one light, and a glass material, in which `pointer` goes from `from` to
/// `to` within two seconds.
GltfText pointed(const std::string& pointer, const std::vector<float>& from, const std::vector<float>& to,
                 const std::string& interpolation = "LINEAR") {
  GltfText file = test::one_triangle();
  file.primitives = R"({"attributes":{"POSITION":0},"material":0})";
  file.nodes =
      R"({"mesh":0,"camera":0,"children":[1],"extensions":{"KHR_lights_punctual":{"light":0}}},
{"mesh":0,"translation":[1,0,0],"extensions":{"KHR_lights_punctual":{"light":0}}})";
  file.values<float>("SCALAR", 5126, 2, {0, 2});
  std::vector<float> values = from;
  values.insert(values.end(), to.begin(), to.end());
  const std::string types[] = {"SCALAR", "VEC2", "VEC3", "VEC4"};
  file.values(types[from.size() - 1], 5126, 2, values);
  file.more =
      R"(,"cameras":[{"type":"perspective","perspective":{"yfov":1,"znear":0.1}}],"materials":[{"name":"glass",
"emissiveFactor":[1,1,1],"extensions":{"KHR_materials_emissive_strength":{"emissiveStrength":4}}}],
"extensions":{"KHR_lights_punctual":{"lights":[{"type":"spot","intensity":5,"spot":{}}]}},
"animations":[{"channels":[{"sampler":0,"target":{"path":"pointer","extensions":{"KHR_animation_pointer":
{"pointer":")" +
      pointer + R"("}}}}],"samplers":[{"input":1,"output":2,"interpolation":")" + interpolation + R"("}]}])";
  return file;
}

scene::Material material_at(const scene::Scene& scene, double seconds) {
  const scene::Pose pose = scene.pose(seconds, {0});
  return scene::changed_or(pose.changes.materials, scene.materials, 0);
}

}  // namespace

TEST_CASE("a pointer moves a node as a path does") {
  const scene::Scene moved = pointed("/nodes/1/translation", {1, 0, 0}, {1, 8, 0}).load(),
                     turned = pointed("/nodes/1/rotation", {0, 0, 0, 1}, {0, 0, 1, 0}).load();
  CHECK(glm::vec3(moved.pose(1, {0}).instances.at(1)[3]) == glm::vec3(1, 4, 0));
  CHECK(glm::distance(glm::vec3(turned.pose(1, {0}).instances.at(1)[0]), glm::vec3(0, 1, 0)) < 1e-6f);
}

TEST_CASE("pointers change cameras, and lights wherever they are used") {
  const scene::Scene camera = pointed("/cameras/0/perspective/yfov", {0.5f}, {1.5f}).load();
  const scene::Pose zoomed = camera.pose(1, {0});
  CHECK(scene::changed_or(zoomed.changes.cameras, camera.cameras, 0).yfov == 1);
  const scene::Scene light = pointed("/extensions/KHR_lights_punctual/lights/0/intensity", {0}, {20}).load();
  CHECK(light.animations.at(0).channels.size() == 2);
  const auto lights = scene::world_lights(light, light.pose(1, {0}), {}, {});
  CHECK(lights.at(0).colour.x == 10);
  CHECK(lights.at(1).colour.x == 10);
  CHECK(scene::world_lights(light, light.pose(1, {}), {}, {}).at(0).colour.x == 5);
}

TEST_CASE("pointers change factors of materials") {
  const std::string pbr = "/materials/0/pbrMetallicRoughness/";
  CHECK(material_at(pointed(pbr + "baseColorFactor", {0, 0, 0, 1}, {1, 0, 0.5f, 1}).load(), 1).base_colour ==
        glm::vec4(0.5f, 0, 0.25f, 1));
  CHECK(material_at(pointed(pbr + "metallicFactor", {0}, {1}).load(), 1).metallic == 0.5f);
  CHECK(material_at(pointed(pbr + "roughnessFactor", {0}, {3}).load(), 2).roughness == 1);
  CHECK(material_at(pointed("/materials/0/emissiveFactor", {0, 0, 0}, {1, 1, 0}).load(), 1).emissive ==
        glm::vec3(2, 2, 0));
  CHECK(material_at(
            pointed("/materials/0/extensions/KHR_materials_emissive_strength/emissiveStrength", {0}, {6}).load(), 1)
            .emissive == glm::vec3(3));
  CHECK(material_at(pointed("/materials/0/extensions/KHR_materials_ior/ior", {1}, {2}).load(), 1).ior == 1.5f);
}

TEST_CASE("a material that an animation makes transparent lets light through from the start") {
  const scene::Scene scene =
      pointed("/materials/0/extensions/KHR_materials_transmission/transmissionFactor", {0}, {1}).load();
  CHECK((scene::flagged_material(scene, 0) & shared::triangle_transmissive) != 0);
  CHECK(material_at(scene, 1).transmission == 0.5f);
}

TEST_CASE("what is not visible is not drawn and does not shine, with all below it") {
  const scene::Scene scene = pointed("/nodes/0/extensions/KHR_node_visibility/visible", {1}, {0}, "STEP").load();
  const scene::Pose before = scene.pose(1, {0}), after = scene.pose(2, {0});
  CHECK(before.hidden.empty());
  CHECK(after.hidden == std::vector<bool>{true, true});
  CHECK_FALSE(scene.bounds(before).empty());
  CHECK(scene.bounds(after).empty());
  CHECK(scene::world_lights(scene, after, {}, {}).at(1).colour.x == 0);
}

TEST_CASE("what is never visible is left out whole") {
  GltfText file = test::one_triangle();
  file.nodes = R"({"children":[1],"extensions":{"KHR_node_visibility":{"visible":false}}},{"mesh":0},{"mesh":0})";
  file.scenes = R"("scenes":[{"nodes":[0,2]}])";
  const scene::Scene scene = file.load();
  CHECK(scene.instances.size() == 1);
  CHECK(scene.unsupported.empty());
}

TEST_CASE("a pointer to what is not done is a line, and one past the end of a list is refused by name") {
  CHECK(pointed("/materials/0/extensions/KHR_materials_odd/oddness", {0}, {1}).load().unsupported ==
        std::vector<std::string>{"animation of '/materials/0/extensions/KHR_materials_odd/oddness'"});
  for (const char* odd : {"", "/", "/nodes", "/nodes/", "/nodes/x/translation", "/nodes/0", "/materials/-1/ior"})
    CHECK(pointed(odd, {0}, {1}).load().unsupported.size() == 1);
  CHECK_THROWS_WITH((void)pointed("/nodes/7/scale", {0, 0, 0}, {1, 1, 1}).load(), doctest::Contains("nodes[7]"));
}
