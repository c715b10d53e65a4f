// Damaged files, thousands of them: load() returns or refuses, nothing else.

#include <doctest/doctest.h>

#include <random>

#include "../unit/scene_file.h"
#include "crsh/error.h"
#include "scene/deform.h"
#include "scene/gltf/load.h"
#include "scene/playing.h"

using namespace crsh;
using test::Folder;
using test::GltfText;

namespace {

/// A small file that uses everything the loader reads.
GltfText everything() {
  GltfText file;
  const size_t mixed =
      file.view(test::bytes_of<float>({0, 0, 0, 0, 0, 1, 1, 0, 0, 0, 0, 1, 0, 1, 0, 0, 0, 1, 1, 1, 0, 0, 0, 1}),
                R"(,"byteStride":24)");
  file.accessor("VEC3", 5126, 4, R"(,"bufferView":)" + std::to_string(mixed));
  file.accessor("VEC3", 5126, 4, R"(,"byteOffset":12,"bufferView":)" + std::to_string(mixed));
  file.values<uint16_t>("VEC2", 5123, 4, {0, 0, 65535, 0, 0, 65535, 65535, 65535}, R"(,"normalized":true)");
  file.values<uint8_t>("VEC4", 5121, 4, std::vector<uint8_t>(16, 200), R"(,"normalized":true)");
  file.values<uint16_t>("SCALAR", 5123, 6, {0, 1, 2, 2, 1, 3});
  const size_t places = file.view(test::bytes_of<uint8_t>({1})), values = file.view(test::bytes_of<float>({2, 0, 0}));
  file.accessor("VEC3", 5126, 4,
                R"(,"bufferView":0,"sparse":{"count":1,"indices":{"bufferView":)" + std::to_string(places) +
                    R"(,"componentType":5121},"values":{"bufferView":)" + std::to_string(values) + "}}");
  file.values<float>("SCALAR", 5126, 2, {0, 1});
  file.values<float>("VEC4", 5126, 2, {0, 0, 0, 1, 0, 1, 0, 0});
  file.values<float>("MAT4", 5126, 2, {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1,  //
                                       1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1});
  file.values<uint8_t>("VEC4", 5121, 4, {0, 1, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0, 0, 0, 0, 0});
  file.values<uint8_t>("VEC4", 5121, 4, {128, 127, 0, 0, 255, 0, 0, 0, 255, 0, 0, 0, 9, 0, 0, 0},
                       R"(,"normalized":true)");
  file.values<float>("SCALAR", 5126, 4, {0, 1, 1, 0});
  file.primitives =
      R"({"attributes":{"POSITION":0,"NORMAL":1,"TEXCOORD_0":2,"COLOR_0":3,"JOINTS_0":9,"WEIGHTS_0":10},"indices":4,
"material":0,"targets":[{"POSITION":1},{"POSITION":5,"NORMAL":1}]},
{"attributes":{"POSITION":5},"mode":5})";
  file.nodes =
      R"({"children":[1,2,3]},{"mesh":0,"skin":0,"weights":[0.5,0]},{"camera":0,"rotation":[0,0,0,1]},{"mesh":0,
"extensions":{"KHR_node_visibility":{"visible":true},"KHR_lights_punctual":{"light":0}}})";
  file.more =
      R"(,"materials":[{"pbrMetallicRoughness":{"baseColorTexture":{"index":0},"baseColorFactor":[1,1,1,1]}}],
"textures":[{"source":0,"sampler":0}],
    "samplers":[{"wrapS":33071}],
"images":[{"uri":"data:image/png;base64,)"
      R"(iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAYAAAAfFcSJAAAADUlEQVR42mNk+M9QDwADhgGAWjR9awAAAABJRU5ErkJggg=="}],
    "cameras":[{"type":"perspective","perspective":{"yfov":1,"znear":0.1}}],"skins":[{"joints":[2,3],
"inverseBindMatrices":8}],
    "extensionsUsed":["KHR_lights_punctual"],"extensions":{"KHR_lights_punctual":{"lights":[{"type":"spot",
"spot":{}}]}},
    "animations":[{"channels":[{"sampler":0,"target":{"node":3,"path":"rotation"}},
{"sampler":1,"target":{"node":1,"path":"weights"}},{"sampler":2,"target":{"path":"pointer","extensions":
{"KHR_animation_pointer":{"pointer":"/materials/0/pbrMetallicRoughness/roughnessFactor"}}}}],
"samplers":[{"input":6,"output":7},{"input":6,"output":11},{"input":6,"output":6}]}])";
  return file;
}

/// True where the file loads. Anything but a UserError fails the test.
bool loads(const Folder& folder, const std::string& content) {
  try {
    const scene::Scene scene = scene::load(folder.write("scene", content));
    const scene::Pose pose = scene.pose(0.5, scene::playing(scene, "").animations);
    (void)scene.bounds(pose);
    for (uint32_t i = 0; i < pose.instances.size(); ++i) (void)scene::posed_sphere(scene, pose, i);
    return true;
  } catch (const UserError& error) {
    return false;
  }
}

/// One to four bytes changed: bits flipped, digits and punctuation put in, stretches removed.
std::string damaged(std::string content, std::mt19937& random) {
  static const std::string likely = "0123456789-.eE,:[]{}\"\\ ";
  for (uint32_t hits = 1 + random() % 4; hits > 0; --hits) {
    const size_t at = random() % content.size();
    switch (random() % 4) {
      case 0: content[at] = static_cast<char>(content[at] ^ 1 << random() % 8); break;
      case 1: content[at] = likely[random() % likely.size()]; break;
      case 2: content[at] = static_cast<char>(random()); break;
      default: content.erase(at, random() % 8); break;
    }
    if (content.empty()) return content;
  }
  return content;
}

}  // namespace

TEST_CASE("the file that is damaged below is whole") {
  const scene::Scene scene = everything().load();
  CHECK(scene.triangle_count() == 8);
  CHECK(scene.images.size() == 1);
  CHECK(scene.animations.at(0).channels.size() == 3);
  CHECK(scene.skins.back().joints.size() == 3);  // the second primitive has no joints
  CHECK(scene.meshes.at(0).target_count == 2);
  CHECK(scene.unsupported.empty());
}

TEST_CASE("truncated files return or are refused") {
  const Folder folder;
  for (const std::string& whole : {everything().glb(), everything().gltf()})
    for (size_t length = 0; length < whole.size(); length += 3) CHECK_FALSE(loads(folder, whole.substr(0, length)));
}

TEST_CASE("damaged files return or are refused") {
  const Folder folder;
  std::mt19937 random(20);
  int loaded = 0;
  const std::string glb = everything().glb(), gltf = everything().gltf();
  for (int round = 0; round < 3000; ++round) loaded += loads(folder, damaged(round % 2 ? glb : gltf, random));
  CHECK(loaded > 100);  // else the damage is too coarse to reach the loader's depths
  CHECK(loaded < 2900);
}
