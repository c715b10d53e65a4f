// Skins and morph targets as files have them, and what they make of a mesh.

#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>

#include "scene/deform.h"
#include "scene_file.h"

using namespace crsh;
using test::GltfText;

namespace {

using Positions = std::vector<glm::vec3>;

const std::vector<float> identity = {1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1};

/// One triangle whose corners three joints move, a corner each as `joints` and `weights` say: nodes 1 to 3, at y = 10,
/// 20 and 30. The mesh's own node is at x = 50.
GltfText skinned(const std::vector<uint8_t>& joints, const std::vector<float>& weights, size_t matrices = 3) {
  GltfText file = test::one_triangle();
  file.values("VEC4", 5121, 3, joints);
  file.values("VEC4", 5126, 3, weights);
  std::vector<float> inverse;
  for (size_t i = 0; i < matrices; ++i) inverse.insert(inverse.end(), identity.begin(), identity.end());
  file.values("MAT4", 5126, matrices, inverse);
  file.primitives = R"({"attributes":{"POSITION":0,"JOINTS_0":1,"WEIGHTS_0":2}})";
  file.nodes =
      R"({"mesh":0,"skin":0,"translation":[50,0,0]},{"translation":[0,10,0]},{"translation":[0,20,0]},
{"translation":[0,30,0]})";
  file.scenes = R"("scenes":[{"nodes":[0,1,2,3]}],"scene":0)";
  file.more = R"(,"skins":[{"joints":[1,2,3],"inverseBindMatrices":3}])";
  return file;
}

const std::vector<uint8_t> one_each = {0, 0, 0, 0, 1, 0, 0, 0, 2, 0, 0, 0};
const std::vector<float> whole = {1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0};

/// The first instance's positions in world space.
Positions drawn(const scene::Scene& scene, double seconds = 0, const std::vector<uint32_t>& animations = {}) {
  const scene::Pose pose = scene.pose(seconds, animations);
  Positions out = scene::posed_positions(scene, pose, 0);
  for (glm::vec3& p : out) p = glm::vec3(scene.origin) + glm::vec3(pose.instances.at(0) * glm::vec4(p, 1));
  return out;
}

const Positions at_rest = {{50, 0, 0}, {51, 0, 0}, {50, 1, 0}};

/// One triangle with two targets: the first moves corner 1 by x, the second corner 2 by z.
GltfText morphed(const std::string& mesh_weights, const std::string& node = R"({"mesh":0})") {
  GltfText file = test::one_triangle();
  file.values<float>("VEC3", 5126, 3, {0, 0, 0, 4, 0, 0, 0, 0, 0});
  file.accessor("VEC3", 5126, 3,
                R"(,"sparse":{"count":1,"indices":{"bufferView":)" +
                    std::to_string(file.view(test::bytes_of<uint8_t>({2}))) +
                    R"(,"componentType":5121},"values":{"bufferView":)" +
                    std::to_string(file.view(test::bytes_of<float>({0, 0, 8}))) + "}}");
  file.primitives =
      R"({"attributes":{"POSITION":0},"targets":[{"POSITION":1},{"POSITION":2}]}])" + mesh_weights + R"(,"extras":[0)";
  file.nodes = node;
  return file;
}

}  // namespace

TEST_CASE("joints place a skinned mesh, each its vertices, and its own node does not") {
  const scene::Scene scene = skinned(one_each, whole).load();
  CHECK(scene.unsupported.empty());
  CHECK(drawn(scene) == Positions{{0, 10, 0}, {1, 20, 0}, {0, 31, 0}});
  const scene::Bounds bounds = scene.bounds(scene.pose(0, {}));
  CHECK(bounds.low == glm::vec3(0, 10, 0));
  CHECK(bounds.high == glm::vec3(1, 31, 0));
}

TEST_CASE("weights are made to sum to 1; where none counts the first joint has all") {
  const std::vector<float> odd = {3, 1, 0, 0, -5, NAN, 0, 0, 0.5f, 0, 0, 0};
  CHECK(drawn(skinned({0, 1, 0, 0, 1, 2, 0, 0, 2, 0, 0, 0}, odd).load()) ==
        Positions{{0, 12.5f, 0}, {1, 20, 0}, {0, 31, 0}});
}

TEST_CASE("any number of sets of influences counts") {
  GltfText file = skinned(one_each, whole);
  for (int set = 1; set < 12; ++set) {
    file.values("VEC4", 5121, 3, one_each);
    file.values("VEC4", 5126, 3, std::vector<float>(12, set == 11 ? 0.25f : 0.0f));
  }
  file.primitives = R"({"attributes":{"POSITION":0,"JOINTS_0":1,"WEIGHTS_0":2)";
  for (int set = 1; set < 12; ++set)
    file.primitives += ",\"JOINTS_" + std::to_string(set) + "\":" + std::to_string(2 + 2 * set) + ",\"WEIGHTS_" +
                       std::to_string(set) + "\":" + std::to_string(3 + 2 * set);
  file.primitives += "}}";
  CHECK(drawn(file.load()).at(2) == glm::vec3(0, (30 * 1.25f + 10 * 0.75f) / 2 + 1, 0));
}

TEST_CASE("a mesh whose skin is broken is drawn at rest, where its node is, with a line") {
  GltfText too_far = skinned({0, 0, 0, 0, 1, 0, 0, 0, 3, 0, 0, 0}, whole), few = skinned(one_each, whole, 2),
           nowhere = skinned(one_each, whole), outside = skinned(one_each, whole),
           short_weights = skinned(one_each, {});
  nowhere.more = R"(,"skins":[{"joints":[1,2,77]}])";
  outside.scenes = R"("scenes":[{"nodes":[0,1,2]}],"scene":0)";
  for (const GltfText* file : {&too_far, &few, &nowhere, &outside, &short_weights}) {
    const scene::Scene scene = file->load();
    CHECK(drawn(scene) == at_rest);
    CHECK(scene.unsupported.size() == 1);
  }
}

TEST_CASE("vertices that no joint moves stay with the mesh's node") {
  GltfText file = skinned(one_each, whole);
  file.positions({0, 0, 5, 1, 0, 5, 0, 1, 5});
  file.primitives += R"(,{"attributes":{"POSITION":4}})";
  const Positions all = drawn(file.load());
  REQUIRE(all.size() == 6);
  CHECK(std::ranges::count(all, glm::vec3(50, 0, 5)) == 1);
  CHECK(std::ranges::count(all, glm::vec3(1, 20, 0)) == 1);
}

TEST_CASE("a skin turns triangles inside out where most joints mirror") {
  GltfText file = skinned(one_each, whole);
  file.nodes = R"({"mesh":0,"skin":0},{"scale":[-1,1,1]},{"scale":[-1,1,1]},{})";
  const scene::Scene scene = file.load();
  CHECK(scene::is_mirrored(scene, scene.pose(0, {}), 0));
  const scene::Scene plain = skinned(one_each, whole).load();
  CHECK_FALSE(scene::is_mirrored(plain, plain.pose(0, {}), 0));
}

TEST_CASE("morph targets move a mesh by the mesh's weights, a node's go before them") {
  CHECK(drawn(morphed("").load()) == Positions{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
  CHECK(drawn(morphed(R"(,"weights":[0.5,1])").load()) == Positions{{0, 0, 0}, {3, 0, 0}, {0, 1, 8}});
  CHECK(drawn(morphed(R"(,"weights":[0.5,1])", R"({"mesh":0,"weights":[0,-1]})").load()) ==
        Positions{{0, 0, 0}, {1, 0, 0}, {0, 1, -8}});
}

TEST_CASE("animated weights go before all others, and a spline has three of each key") {
  GltfText file = morphed(R"(,"weights":[7,7])");
  file.values<float>("SCALAR", 5126, 2, {0, 2});
  file.values<float>("SCALAR", 5126, 4, {0, 0, 1, 0.5f});
  file.values<float>("SCALAR", 5126, 12, {0, 0, 0, 0, 0, 0, 0, 0, 1, 0.5f, 0, 0});
  file.more = R"(,"animations":[{"channels":[{"sampler":0,"target":{"node":0,"path":"weights"}}],
"samplers":[{"input":3,"output":4}]},{"channels":[{"sampler":0,"target":{"node":0,"path":"weights"}}],
"samplers":[{"input":3,"output":5,"interpolation":"CUBICSPLINE"}]}])";
  const scene::Scene scene = file.load();
  CHECK(scene.unsupported.empty());
  for (const uint32_t animation : {0u, 1u}) {
    CHECK(drawn(scene, 1, {animation}) == Positions{{0, 0, 0}, {3, 0, 0}, {0, 1, 2}});
    CHECK(drawn(scene, 2, {animation}) == Positions{{0, 0, 0}, {5, 0, 0}, {0, 1, 4}});
  }
}

TEST_CASE("only what a target moves is kept") {
  const scene::Scene scene = morphed("").load();
  CHECK(scene.meshes.at(0).displacements.items.size() == 2);
  CHECK(scene.meshes.at(0).displacements.of(0).empty());
  CHECK(scene.meshes.at(0).displacements.of(2).size() == 1);
}

TEST_CASE("quantised targets and joints are read as any other") {
  GltfText file = skinned(one_each, whole);
  const size_t view =
      file.view(test::bytes_of<int8_t>({0, 0, 0, 0, 0, 127, 0, 0, 0, 0, -127, 0}), R"(,"byteStride":4)");
  file.accessor("VEC3", 5120, 3, R"(,"normalized":true,"bufferView":)" + std::to_string(view));
  file.primitives = R"({"attributes":{"POSITION":0,"JOINTS_0":1,"WEIGHTS_0":2},"targets":[{"POSITION":4}]}])"
                    R"(,"weights":[2],"extras":[0)";
  CHECK(drawn(file.load()) == Positions{{0, 10, 0}, {1, 22, 0}, {0, 31, -2}});
}

TEST_CASE("the quick bounds of what deforms hold every vertex") {
  GltfText file = skinned({0, 1, 2, 0, 1, 2, 0, 0, 2, 0, 1, 0}, {1, 2, 3, 0, 1, 1, 0, 0, 3, 1, 1, 0});
  file.nodes = R"({"mesh":0,"skin":0},{"scale":[3,-1,2],"translation":[1,2,3]},{"rotation":[0.6,0,0.8,0]},
{"translation":[-5,0,9]})";
  const scene::Scene scene = file.load();
  const scene::Pose pose = scene.pose(0, {});
  const scene::Bounds bounds = scene::posed_bounds(scene, pose, 0);
  for (const glm::vec3& place : drawn(scene)) {
    const glm::vec3 p = place - glm::vec3(scene.origin);
    CHECK(glm::all(glm::lessThanEqual(bounds.low, p)));
    CHECK(glm::all(glm::lessThanEqual(p, bounds.high)));
    const scene::Sphere sphere = scene::posed_sphere(scene, pose, 0);
    CHECK(glm::distance(p, sphere.centre) <= sphere.radius);
  }
}

TEST_CASE("a small file that asks for influences without end is refused") {
  GltfText file = test::one_triangle();
  const size_t many = size_t{1} << 22u;
  file.accessor("VEC3", 5126, many, "");
  file.accessor("VEC4", 5121, many, "");
  file.accessor("VEC4", 5126, many, "");
  file.primitives = R"({"attributes":{"POSITION":1)";
  for (int set = 0; set < 20; ++set)
    file.primitives += ",\"JOINTS_" + std::to_string(set) + "\":2,\"WEIGHTS_" + std::to_string(set) + "\":3";
  file.primitives += R"(},"indices":4})";
  file.values<uint8_t>("SCALAR", 5121, 3, {0, 1, 2});
  CHECK_THROWS_WITH((void)file.load(), doctest::Contains("too large"));
}
