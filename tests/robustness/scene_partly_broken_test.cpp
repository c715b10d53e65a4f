// Where one part of a file is broken the rest is drawn, with a line that names the part.

#include <doctest/doctest.h>

#include "complaint.h"

using namespace crsh;
using test::complaint;
using test::GltfText;
using test::one_triangle;
using test::says;

namespace {

/// A whole triangle, and `more` in the lists of primitives and accessors.
scene::Scene beside_a_triangle(const std::string& primitive, const std::string& accessor) {
  GltfText file = one_triangle();
  file.primitives += "," + primitive;
  file.accessors.push_back(accessor);
  return file.load();
}

GltfText indexed(const std::vector<uint8_t>& indices, int mode) {
  GltfText file;
  file.positions(test::unit_square);
  file.values<uint8_t>("SCALAR", 5121, indices.size(), indices);
  file.primitives = R"({"attributes":{"POSITION":0},"indices":1,"mode":)" + std::to_string(mode) + "}";
  return file;
}

}  // namespace

TEST_CASE("a primitive that cannot be read is left out, and the others are drawn") {
  for (const char* accessor :
       {R"({"type":"VEC9","componentType":5126,"count":3})", R"({"type":"VEC3","componentType":9,"count":3})",
        R"({"type":"VEC3","componentType":5126,"count":-3})",
        R"({"type":"VEC3","componentType":5126,"count":99,"bufferView":0})",
        R"({"type":"VEC2","componentType":5126,"count":3,"bufferView":0})"}) {
    const scene::Scene scene = beside_a_triangle(R"({"attributes":{"POSITION":1}})", accessor);
    CHECK(scene.triangle_count() == 1);
    says(scene.unsupported.at(0), "meshes[0].primitives[1] (");
  }
  const std::string whole = R"({"type":"SCALAR","componentType":5121,"count":3})";
  says(beside_a_triangle(R"({"attributes":{"POSITION":0},"indices":7})", whole).unsupported.at(0),
       "meshes[0].primitives[1] (accessors[7] is referred to");
}

TEST_CASE("triangles with a broken corner are left out, and the others of the primitive are drawn") {
  const scene::Scene scene = indexed({0, 1, 2, 2, 1, 9, 2, 1, 3}, 4).load();
  CHECK(scene.triangle_count() == 2);
  CHECK(scene.unsupported ==
        std::vector<std::string>{"1 triangles of meshes[0].primitives[0] (meshes[0].primitives[0] has an index past "
                                 "the end of its vertices)"});
  says(complaint(indexed({0, 1, 9}, 4)), "has an index past the end of its vertices");
}

TEST_CASE("a primitive restart value ends a strip, a fan or a triangle, as graphics devices do it") {
  CHECK(indexed({0, 1, 2, 255, 2, 1, 3}, 5).load().triangle_count() == 2);
  CHECK(indexed({0, 1, 2, 3, 255, 2, 1, 3}, 6).load().triangle_count() == 3);
  CHECK(indexed({0, 1, 255, 0, 1, 2}, 4).load().triangle_count() == 1);
}

TEST_CASE("a broken camera or light is left out with a line, and the scene is drawn") {
  GltfText file = one_triangle();
  file.nodes = R"({"mesh":0},{"camera":0},{"camera":1},{"camera":2},{"camera":3},{"camera":9},
{"extensions":{"KHR_lights_punctual":{"light":0}}},{"extensions":{"KHR_lights_punctual":{"light":1}}},
{"extensions":{"KHR_lights_punctual":{"light":5}}})";
  file.scenes = R"("scenes":[{"nodes":[0,1,2,3,4,5,6,7,8]}])";
  file.more = R"(,"cameras":[{"type":"fisheye"},{"type":"perspective","perspective":{"yfov":1}},
{"type":"perspective","perspective":{"yfov":1,"znear":0}},{"type":"perspective","perspective":{"yfov":1,"znear":1}}],
"extensions":{"KHR_lights_punctual":{"lights":[{"type":"point","range":-1},{"type":"point"}]}})";
  const scene::Scene scene = file.load();
  CHECK(scene.cameras.size() == 1);
  CHECK(scene.lights.size() == 1);
  CHECK(scene.triangle_count() == 1);
  REQUIRE(scene.unsupported.size() == 6);
  says(scene.unsupported[0], "cameras[0] (type is neither perspective nor orthographic)");
  says(scene.unsupported[2], "cameras[2] (perspective.znear is not positive)");
}
