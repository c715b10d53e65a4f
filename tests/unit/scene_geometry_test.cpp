// Meshes: every container, index type, accessor form and triangle topology.

#include <doctest/doctest.h>

#include <algorithm>
#include <limits>

#include "scene/gltf/load.h"
#include "scene_file.h"

using namespace crsh;
using test::Folder;
using test::GltfText;
using test::one_triangle;
using test::unit_square;

namespace {

bool has_note(const scene::Scene& scene, const std::string& note) {
  return std::find(scene.unsupported.begin(), scene.unsupported.end(), note) != scene.unsupported.end();
}

/// A square of two triangles with indices of one type.
template <class T>
scene::Mesh indexed_square(int component) {
  GltfText file;
  file.positions(unit_square);
  file.values<T>("SCALAR", component, 6, {0, 1, 2, 2, 1, 3});
  file.primitives = R"({"attributes":{"POSITION":0},"indices":1})";
  return file.load().meshes.at(0);
}

std::vector<glm::vec3> corners(const scene::Mesh& mesh) {
  std::vector<glm::vec3> out;
  for (const glm::uvec3& t : mesh.triangles)
    for (int c = 0; c < 3; ++c) out.push_back(mesh.positions.at(t[c]));
  return out;
}

std::vector<glm::vec3> corners_of_mode(int mode) {
  GltfText file;
  file.positions({0, 0, 0, 1, 0, 0, 2, 0, 0, 3, 0, 0, 4, 0, 0});
  file.primitives = R"({"attributes":{"POSITION":0},"mode":)" + std::to_string(mode) + "}";
  return corners(file.load().meshes.at(0));
}

std::vector<glm::vec3> points_on_x(std::initializer_list<int> xs) {
  std::vector<glm::vec3> out;
  for (const int x : xs) out.emplace_back(x, 0, 0);
  return out;
}

/// The triangle's file with one more attribute.
GltfText with_attribute(const std::string& name, const std::string& type, int component, const std::string& data,
                        const std::string& options = "") {
  GltfText file = one_triangle();
  const size_t view = file.view(data);
  file.accessor(type, component, 3, R"(,"bufferView":)" + std::to_string(view) + options);
  file.primitives = R"({"attributes":{"POSITION":0,")" + name + R"(":1}})";
  return file;
}

}  // namespace

TEST_CASE("a triangle is the same from embedded data, a file beside it, and a GLB") {
  const Folder folder;
  GltfText file = one_triangle();
  folder.write("my data #1.bin", file.buffer + "more than is asked for");
  for (const std::string& path :
       {folder.write("a.gltf", file.gltf()).string(), folder.write("c.glb", file.glb()).string(),
        folder.write("b.gltf", file.text(R"(,"uri":"my%20data%20%231.bin")")).string(),
        folder.write("wrong extension.gltf", file.glb()).string()}) {
    INFO(path);
    const scene::Scene scene = scene::load(path);
    CHECK(scene.triangle_count() == 1);
    CHECK(scene.meshes.at(0).positions.at(1) == glm::vec3(1, 0, 0));
    CHECK(scene.meshes[0].normals.at(0) == glm::vec3(0));
    CHECK(scene.meshes[0].colours.at(2) == scene::white);
    CHECK(scene.meshes[0].materials.at(0) == 0);
    CHECK(scene.materials.size() == 1);
    CHECK(scene.unsupported.empty());
  }
}

TEST_CASE("a URI with plain spaces, a plus sign and a parent folder names its file, where that is allowed") {
  const Folder folder;
  GltfText file = one_triangle();
  std::filesystem::create_directories(folder.path("scenes"));
  folder.write("a + b.bin", file.buffer);
  const auto path = folder.write("scenes/s.gltf", file.text(R"(,"uri":"../a + b.bin")"));
  CHECK(scene::load(path, "", scene::Reach::anywhere).triangle_count() == 1);
  CHECK_THROWS_AS((void)scene::load(path), scene::OutsideError);
  folder.write("scenes/a + b.bin", file.buffer);
  CHECK(scene::load(folder.write("scenes/t.gltf", file.text(R"(,"uri":"below/../a + b.bin")"))).triangle_count() == 1);
}

TEST_CASE("indices of 8, 16 and 32 bits give the same triangles") {
  for (const scene::Mesh& mesh :
       {indexed_square<uint8_t>(5121), indexed_square<uint16_t>(5123), indexed_square<uint32_t>(5125)}) {
    CHECK(mesh.triangles.size() == 2);
    CHECK(mesh.positions.size() == 4);
    CHECK(corners(mesh).at(5) == glm::vec3(1, 1, 0));
  }
}

TEST_CASE("lists, strips and fans are taken apart as the specification draws them") {
  CHECK(corners_of_mode(4) == points_on_x({0, 1, 2}));
  CHECK(corners_of_mode(5) == points_on_x({0, 1, 2, 1, 3, 2, 2, 3, 4}));
  CHECK(corners_of_mode(6) == points_on_x({1, 2, 0, 2, 3, 0, 3, 4, 0}));
}

TEST_CASE("points and lines are left out, said so, and make no instance") {
  GltfText file = one_triangle();
  file.primitives = R"({"attributes":{"POSITION":0},"mode":0},{"attributes":{"POSITION":0},"mode":3})";
  const scene::Scene scene = file.load();
  CHECK(scene.instances.empty());
  CHECK(scene.bounds(scene.pose(0, {})).empty());
  CHECK(has_note(scene, "points and lines"));
  CHECK(scene.unsupported.size() == 1);
}

TEST_CASE("primitives merge into one mesh, share vertices, keep materials, drop what no triangle uses") {
  GltfText file;
  file.positions({9, 9, 9, 0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0});
  file.values<uint16_t>("SCALAR", 5123, 3, {1, 2, 3});
  file.values<uint16_t>("SCALAR", 5123, 3, {3, 2, 4});
  file.primitives =
      R"({"attributes":{"POSITION":0},"indices":1,"material":1},{"attributes":{"POSITION":0},"indices":2})";
  file.more = R"(,"materials":[{"name":"a"},{"name":"b"}])";
  const scene::Scene scene = file.load();
  const scene::Mesh& mesh = scene.meshes.at(0);
  CHECK(mesh.name == "m");
  CHECK(mesh.positions.size() == 4);
  CHECK(mesh.materials == std::vector<uint32_t>{1, 2});
  CHECK(scene.materials.size() == 3);
  CHECK(mesh.sphere.radius < 0.8f);
}

TEST_CASE("interleaved vertices are read by their stride") {
  GltfText file;
  const size_t view =
      file.view(test::bytes_of<float>({0, 0, 0, 0, 0, 2, 1, 0, 0, 0, 0, 2, 0, 1, 0, 0, 0, 2}), R"(,"byteStride":24)");
  file.accessor("VEC3", 5126, 3, R"(,"bufferView":)" + std::to_string(view));
  file.accessor("VEC3", 5126, 3, R"(,"byteOffset":12,"bufferView":)" + std::to_string(view));
  file.primitives = R"({"attributes":{"POSITION":0,"NORMAL":1}})";
  const scene::Mesh mesh = file.load().meshes.at(0);
  CHECK(mesh.positions == std::vector<glm::vec3>{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}});
  CHECK(mesh.normals == std::vector<glm::vec3>(3, {0, 0, 1}));
}

TEST_CASE("sparse accessors substitute, over data and over nothing") {
  for (const bool dense : {true, false}) {
    GltfText file;
    file.view(test::bytes_of<float>({0, 0, 0, 1, 0, 0, 0, 1, 0}));
    file.view(test::bytes_of<uint8_t>({1, 2}));
    file.view(test::bytes_of<float>({5, 0, 0, 0, 7, 0}));
    file.accessor(
        "VEC3", 5126, 3,
        std::string(dense ? R"(,"bufferView":0)" : "") +
            R"(,"sparse":{"count":2,"indices":{"bufferView":1,"componentType":5121},"values":{"bufferView":2}})");
    file.primitives = R"({"attributes":{"POSITION":0}})";
    CHECK(file.load().meshes.at(0).positions == std::vector<glm::vec3>{{0, 0, 0}, {5, 0, 0}, {0, 7, 0}});
  }
}

TEST_CASE("sparse indices of triangles work without data below them") {
  GltfText file;
  file.positions(unit_square);
  file.view(test::bytes_of<uint16_t>({1, 2}));
  file.view(test::bytes_of<uint8_t>({1, 3}));
  file.accessor("SCALAR", 5121, 3,
                R"(,"sparse":{"count":2,"indices":{"bufferView":1,"componentType":5123},"values":{"bufferView":2}})");
  file.primitives = R"({"attributes":{"POSITION":0},"indices":1})";
  CHECK(corners(file.load().meshes.at(0)) == std::vector<glm::vec3>{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}});
}

TEST_CASE("colours of every type become halves, and dark ones are kept") {
  const auto first = [](const GltfText& file) {
    return scene::unpacked_colour(GltfText(file).load().meshes.at(0).colours.at(0));
  };
  const auto near = [](glm::vec4 a, glm::vec4 b) { return glm::all(glm::lessThanEqual(glm::abs(a - b), b / 1000.0f)); };
  const std::string floats = test::bytes_of<float>({1, 0.5f, 0, 1, 0.5f, 0, 1, 0.5f, 0});
  CHECK(near(first(with_attribute("COLOR_0", "VEC3", 5126, floats)), {1, 0.5f, 0, 1}));
  const std::string bytes = test::bytes_of<uint8_t>({255, 128, 0, 64, 1, 2, 3, 4, 5, 6, 7, 8});
  CHECK(near(first(with_attribute("COLOR_0", "VEC4", 5121, bytes, R"(,"normalized":true)")),
             {1, 128 / 255.0f, 0, 64 / 255.0f}));
  const std::string shorts = test::bytes_of<uint16_t>({65535, 32768, 33, 16448, 0, 0, 0, 0, 0, 0, 0, 0});
  CHECK(near(first(with_attribute("COLOR_0", "VEC4", 5123, shorts, R"(,"normalized":true)")),
             {1, 32768 / 65535.0f, 33 / 65535.0f, 16448 / 65535.0f}));
}

TEST_CASE("normalised and plain integers are decoded as the specification says") {
  const std::string uvs = test::bytes_of<uint8_t>({0, 255, 51, 0, 0, 0});
  CHECK(with_attribute("TEXCOORD_1", "VEC2", 5121, uvs, R"(,"normalized":true)").load().meshes.at(0).uv[1] ==
        std::vector<glm::vec2>{{0, 1}, {0.2f, 0}, {0, 0}});
  const std::string normals = test::bytes_of<int8_t>({0, 0, 127, 0, 0, -128, 0, 0, 0});
  CHECK(with_attribute("NORMAL", "VEC3", 5120, normals, R"(,"normalized":true)").load().meshes.at(0).normals ==
        std::vector<glm::vec3>{{0, 0, 1}, {0, 0, -1}, {0, 0, 0}});
  GltfText file;
  file.values<int16_t>("VEC3", 5122, 3, {0, 0, 0, 300, 0, 0, 0, -2, 0});
  file.primitives = R"({"attributes":{"POSITION":0}})";
  CHECK(file.load().meshes.at(0).positions.at(1) == glm::vec3(300, 0, 0));
}

TEST_CASE("normals that are zero or not finite mean flat shading") {
  const float infinite = std::numeric_limits<float>::infinity();
  const std::string data = test::bytes_of<float>({0, 0, 0, infinite, 0, 0, 0, 3, 0});
  CHECK(with_attribute("NORMAL", "VEC3", 5126, data).load().meshes.at(0).normals ==
        std::vector<glm::vec3>{{0, 0, 0}, {0, 0, 0}, {0, 1, 0}});
}

TEST_CASE("a million triangles load within seconds") {
  const uint32_t side = 708;
  std::vector<float> positions;
  std::vector<uint32_t> indices;
  for (uint32_t y = 0; y <= side; ++y)
    for (uint32_t x = 0; x <= side; ++x) positions.insert(positions.end(), {float(x), float(y), float(x * y % 7)});
  for (uint32_t y = 0; y < side; ++y)
    for (uint32_t x = 0; x < side; ++x) {
      const uint32_t a = y * (side + 1) + x, b = a + side + 1;
      indices.insert(indices.end(), {a, a + 1, b, b, a + 1, b + 1});
    }
  GltfText file;
  file.positions(positions);
  file.values("SCALAR", 5125, indices.size(), indices);
  file.primitives = R"({"attributes":{"POSITION":0},"indices":1})";
  const Folder folder;
  const scene::Scene scene = scene::load(folder.write("big.glb", file.glb()));
  CHECK(scene.triangle_count() == uint64_t{2} * side * side);
}
