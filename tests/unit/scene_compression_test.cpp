// Compressed geometry is what it was before: Draco, meshoptimizer.

#include <doctest/doctest.h>

#include <algorithm>

#include "compressed.h"

using namespace crsh;
using test::GltfText;

namespace {

/// All corners, sorted: compression keeps no order.
std::vector<std::array<float, 3>> corners_of(const scene::Scene& scene) {
  std::vector<std::array<float, 3>> out;
  const scene::Mesh& mesh = scene.meshes.at(0);
  for (const glm::uvec3& triangle : mesh.triangles)
    for (int c = 0; c < 3; ++c) {
      const glm::vec3 at = mesh.positions[triangle[c]];
      out.push_back({at.x, at.y, at.z});
    }
  std::sort(out.begin(), out.end());
  return out;
}

const std::vector<std::array<float, 3>> square_corners = {{0, 0, 0}, {0, 1, 0}, {0, 1, 0},
                                                          {1, 0, 0}, {1, 0, 0}, {1, 1, 0}};

/// Four vertices with one attribute that is decompressed by `filter`, and their accessor's type and component.
scene::Scene filtered(const void* bytes, size_t stride, const std::string& filter, const std::string& accessor,
                      int component, const std::string& attribute) {
  GltfText file = test::meshopt_square();
  const size_t view =
      test::compressed_view(file, test::meshopt_vertices(bytes, 4, stride), stride, 4,
                            R"("mode":"ATTRIBUTES","filter":")" + filter + '"', "KHR_meshopt_compression");
  file.accessor(accessor, component, 4,
                R"(,"normalized":)" + std::string(component == 5126 ? "false" : "true") + R"(,"bufferView":)" +
                    std::to_string(view));
  file.primitives = R"({"attributes":{"POSITION":0,")" + attribute + R"(":2},"indices":1})";
  return file.load();
}

}  // namespace

TEST_CASE("Draco gives the triangles back, by either of its methods") {
  for (const int method : {draco::MESH_SEQUENTIAL_ENCODING, draco::MESH_EDGEBREAKER_ENCODING}) {
    const scene::Scene scene = test::draco_square(method).load();
    CHECK(corners_of(scene) == square_corners);
    CHECK(scene.unsupported.empty());
  }
}

TEST_CASE("what Draco holds counts, whatever its accessors say of it") {
  GltfText file = test::draco_square(draco::MESH_EDGEBREAKER_ENCODING);
  file.accessors[0] = R"({"type":"VEC3","componentType":5126,"count":1000000})";
  CHECK(corners_of(file.load()) == square_corners);
}

TEST_CASE("two primitives may share what is compressed once") {
  GltfText file = test::draco_square(draco::MESH_SEQUENTIAL_ENCODING);
  file.primitives += "," + file.primitives;
  CHECK(file.load().triangle_count() == 4);
}

TEST_CASE("meshoptimizer gives vertices and triangles back; the buffer behind is not read") {
  const scene::Scene scene = test::meshopt_square().load();
  CHECK(corners_of(scene) == square_corners);
  CHECK(scene.unsupported.empty());
}

TEST_CASE("meshoptimizer's filters: octahedral normals, quaternions, exponents, and KHR's colours") {
  const std::vector<int8_t> octahedral = {0, 0, 127, 0, 127, 0, 127, 0, 0, 127, 127, 0, 0, 0, 127, 0};
  const scene::Scene normals = filtered(octahedral.data(), 4, "OCTAHEDRAL", "VEC3", 5120, "NORMAL");
  CHECK(normals.meshes[0].normals.at(0) == glm::vec3(0, 0, 1));
  CHECK(normals.meshes[0].normals.at(1).x == doctest::Approx(1));
  // 3 times 2 to the power of -1, and of 0.
  const std::vector<uint32_t> exponents(8, 0xFF000003u);
  const scene::Scene coordinates = filtered(exponents.data(), 8, "EXPONENTIAL", "VEC2", 5126, "TEXCOORD_0");
  CHECK(coordinates.meshes[0].uv[0].at(0) == glm::vec2(1.5f));
  // Luma 128, no chroma, alpha 127 of 7 bits: grey 128, opaque.
  std::vector<uint8_t> colours;
  for (int i = 0; i < 4; ++i) colours.insert(colours.end(), {128, 0, 0, 255});
  const scene::Scene greys = filtered(colours.data(), 4, "COLOR", "VEC4", 5121, "COLOR_0");
  CHECK(greys.meshes[0].positions.size() == 4);
  CHECK(filtered(colours.data(), 4, "COLOR", "VEC4", 5121, "COLOR_0").unsupported.empty());
}

TEST_CASE("where compressed views cannot be read, what stands uncompressed behind them is") {
  GltfText file = test::meshopt_square();
  const std::string plain = test::bytes_of(test::unit_square);
  file.more_buffers = R"(,{"byteLength":48,"uri":"data:application/octet-stream;base64,)" + test::base64(plain) + "\"}";
  file.buffer[0] = 'x';  // no codec's
  CHECK(corners_of(file.load()) == square_corners);
}
