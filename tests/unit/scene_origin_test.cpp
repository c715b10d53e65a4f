// Scenes far from the file's origin are drawn around an origin of their own, exactly.

#include "scene/origin.h"

#include <doctest/doctest.h>

#include "scene_file.h"

using namespace crsh;
using test::GltfText;

namespace {

scene::Bounds box(glm::vec3 low, glm::vec3 high) { return {low, high}; }

/// One triangle with legs of a metre, under these nodes.
scene::Scene under(const std::string& nodes, glm::vec3 at = glm::vec3(0)) {
  GltfText file;
  file.positions({at.x, at.y, at.z, at.x + 1, at.y, at.z, at.x, at.y + 1, at.z});
  file.primitives = R"({"attributes":{"POSITION":0}})";
  file.nodes = nodes;
  file.scenes = R"("scenes":[{"nodes":[0]}])";
  return file.load();
}

/// The triangle's corners in the drawn world.
std::vector<glm::vec3> corners(const scene::Scene& scene) {
  const glm::mat4 matrix = scene.pose(0, {}).instances.at(0);
  std::vector<glm::vec3> corners;
  for (const glm::vec3& position : scene.meshes[0].positions)
    corners.emplace_back(glm::vec3(matrix * glm::vec4(position, 1)));
  return corners;
}

const std::vector<glm::vec3> at_origin = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};

}  // namespace

TEST_CASE("what is within four of its sizes of the origin stays, what is farther gets a round number near it") {
  CHECK(scene::origin_for(box({3, 0, -4.5f}, {4, 1, -3.5f})) == glm::dvec3(0));
  CHECK(scene::origin_for(box({-3, 0, 9999998}, {3, 1, 10000002})) == glm::dvec3(0, 0, 10000000));
  CHECK(scene::origin_for(box({7785, 0, -7791}, {7791, 1, -7785})) == glm::dvec3(7788, 0, -7788));
  CHECK(scene::origin_for(box({5, 5, 5}, {5, 5, 5})) == glm::dvec3(5));
}

TEST_CASE("a scene moved by nodes, by its mesh or by both has the same corners as at the origin") {
  const std::string bare = R"({"mesh":0})", moved = R"({"mesh":0,"translation":[65536,0,-131072]})";
  for (const scene::Scene& scene : {under(bare), under(moved), under(bare, {65536, 0, -131072}),
                                    under(moved, {-65536, 0, 131072}), under(moved, {65536, 256, 131072})})
    CHECK(corners(scene) == at_origin);
  CHECK(under(moved).origin == glm::dvec3(65536, 0, -131072));
  CHECK(under(bare, {65536, 0, -131072}).meshes[0].positions == at_origin);
  CHECK(under(moved, {-65536, 0, 131072}).origin == glm::dvec3(0));
}

TEST_CASE("what nodes move far off and back keeps the file's digits, more than floats have") {
  const scene::Scene scene =
      under(R"({"translation":[100000.1,0,0],"children":[1]},{"mesh":0,"translation":[-100000.05,0,0]})");
  CHECK(corners(scene)[0].x == doctest::Approx(0.05).epsilon(1e-6));
  const scene::Scene far = under(R"({"mesh":0,"translation":[5000000.1,0,0]})");
  CHECK(far.origin.x + double(corners(far)[0].x) == doctest::Approx(5000000.1).epsilon(1e-14));
}

TEST_CASE("near the origin nodes have no more digits than floats") {
  const scene::Scene scene = under(R"({"mesh":0,"translation":[0.1,0,0]})");
  CHECK(scene.nodes[0].transform.translation.x == double(0.1f));
}

TEST_CASE("a place given in the file's coordinates and written again is the same to the last bit") {
  scene::Scene scene;
  CHECK(scene.in_file(glm::vec3(0.1f, -2, 3)) == glm::dvec3(0.1, -2, 3));
  scene.origin = {100000, 0, -8192};
  const glm::dvec3 place = scene.in_file(glm::vec3(0.1f, -2, 3));
  CHECK(place == glm::dvec3(100000.1, -2, -8189));
  CHECK(scene.in_file(scene.drawn(place)) == place);
}
