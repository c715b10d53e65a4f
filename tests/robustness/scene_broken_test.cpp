// Broken and hostile files end with one line that names the file, the reason and the mend.

#include <doctest/doctest.h>
#include <sys/stat.h>

#include <cmath>

#include "complaint.h"
#include "scene/gltf/document.h"
#include "scene/gltf/mesh.h"

using namespace crsh;
using test::complaint;
using test::Folder;
using test::GltfText;
using test::one_triangle;
using test::replaced;
using test::says;

namespace {

std::string triangle_with(const std::string& from, const std::string& to) {
  return complaint(replaced(one_triangle().gltf(), from, to));
}

}  // namespace

TEST_CASE("what is no glTF file") {
  const Folder folder;
  says(complaint(folder.path("none.glb")), "no such file");
  says(complaint(folder.path("")), "is a directory");
  says(complaint(folder.write("empty.glb", "")), "is empty");
  says(complaint(folder.write("text.gltf", "hello")), "JSON is broken at byte");
  says(complaint(folder.write("list.gltf", "[]")), "not an object");
  says(complaint(folder.write("object.gltf", "{}")), "'asset' is missing");
  says(complaint(folder.write("old.gltf", R"({"asset":{"version":"1.0"}})")), "glTF 1.0");
  says(complaint(folder.write("new.gltf", R"({"asset":{"version":"2.9","minVersion":"2.9"}})")), "glTF 2.9");
  says(complaint(folder.write("deep.gltf", std::string(1000000, '['))), "nests deeper than 64 levels at byte 65");
  says(complaint(folder.write("deep2.gltf", R"({"asset":{"version":"2.0"},"nodes":)" + std::string(300000, '[') +
                                                std::string(300000, ']') + "}")),
       "nests deeper than 64 levels");
  says(complaint(folder.write("nested.gltf", R"({"asset":{"version":"2.0"},"nodes":[[]]})")),
       "nodes[0] is not an object");
  says(complaint(folder.write("number.gltf", R"({"asset":{"version":"2.0"},"scene":1e999})")), "JSON is broken");
}

TEST_CASE("a pipe is not waited for") {
  const Folder folder;
  REQUIRE(mkfifo(folder.path("pipe.gltf").c_str(), 0600) == 0);
  says(complaint(folder.path("pipe.gltf")), "cannot be read as a file");
  GltfText file = one_triangle();
  says(complaint(folder.write("s.gltf", file.text(R"(,"uri":"pipe.gltf")"))), "'pipe.gltf', which it refers to");
}

TEST_CASE("every truncation of a GLB is refused, and so is every broken header") {
  const Folder folder;
  const std::string whole = one_triangle().glb();
  for (size_t length = 0; length < whole.size(); ++length)
    CHECK_FALSE(complaint(folder.write("cut.glb", whole.substr(0, length))).empty());
  std::string version = whole;
  version[4] = 1;
  says(complaint(folder.write("v1.glb", version)), "version 1");
  CHECK(complaint(folder.write("longer.glb", whole + "rest")).empty());
}

TEST_CASE("data that is missing, short, elsewhere or not base64") {
  const GltfText file = one_triangle();
  says(complaint(file.text(R"(,"uri":"none.bin")")), "'none.bin', which it refers to: no such file");
  says(complaint(file.text(R"(,"uri":"https://example.com/a.bin")")), "is not a local file");
  says(complaint(file.text(R"(,"uri":"data:application/octet-stream;base64,AAAA")")), "cut short: 3 of 36 bytes");
  says(complaint(file.text(R"(,"uri":"data:application/octet-stream;base64,A$AA")")), "not base64");
  says(complaint(file.text(R"(,"uri":"data:nothing")")), "no comma");
  says(complaint(file.text(R"(,"uri":".")")), "is a directory");
  says(complaint(file.text("")), "has no data");
  says(complaint(file.text(R"(,"uri":"a\nb.bin")")), "'a b.bin'");
}

TEST_CASE("accessors and views that reach past their end, also where the product overflows") {
  says(triangle_with(R"("count":3)", R"("count":4)"), "accessors[0] reaches past the end");
  says(triangle_with(R"("count":3)", R"("count":1099511627776)"), "accessors[0] reaches past the end");
  says(triangle_with(R"("count":3)", R"("count":18446744073709551615)"), "count is not a whole number");
  says(triangle_with(R"("count":3)", R"("count":-3)"), "count is not a whole number");
  says(triangle_with(R"("count":3)", R"("count":3,"byteOffset":4)"), "accessors[0] reaches past the end");
  says(triangle_with(R"("count":3)", R"("count":3,"byteOffset":1000000000000)"), "accessors[0] starts past the end");
  says(triangle_with(R"("byteOffset":0,"byteLength":36)", R"("byteOffset":1,"byteLength":36)"),
       "bufferViews[0] reaches past the end");
  says(triangle_with(R"("byteLength":36})", R"("byteLength":36,"byteStride":4})"), "does not fit the byteStride");
  says(triangle_with(R"("buffer":0)", R"("buffer":7)"), "buffers[7] is referred to but is not in the file");
  says(triangle_with(R"("bufferView":0)", R"("bufferView":1)"), "bufferViews[1] is referred to");
  says(complaint(
           replaced(replaced(one_triangle().gltf(), R"(,"bufferView":0)", ""), R"("count":3)", R"("count":99999999)")),
       "but no data");
  says(triangle_with("5126", "5130"), "componentType 5130");
  says(triangle_with("VEC3", "VEC2"), "wrong type");
  says(triangle_with("VEC3", "VEC9"), "'VEC9' is not known");
}

TEST_CASE("positions that are not finite, and transforms that leave the floats") {
  for (const float bad : {std::nanf(""), INFINITY, -INFINITY, 1e30f}) {
    GltfText file;
    file.positions({0, 0, 0, 1, bad, 0, 0, 1, 0});
    file.primitives = R"({"attributes":{"POSITION":0}})";
    says(complaint(file), "not finite");
  }
  GltfText file = one_triangle();
  file.nodes = R"({"children":[1],"scale":[1e20,1,1]},{"mesh":0,"scale":[1e20,1,1]})";
  says(complaint(file), "beyond what can be drawn");
  file.nodes = R"({"mesh":0,"scale":[1e300,1,1]})";
  says(complaint(file), "not a finite number");
}

TEST_CASE("indices past their vertices, of the wrong type, and sparse ones past their end") {
  GltfText file = one_triangle();
  file.values<uint16_t>("SCALAR", 5123, 3, {0, 1, 3});
  file.values<float>("SCALAR", 5126, 3, {0, 1, 2});
  file.primitives = R"({"attributes":{"POSITION":0},"indices":1})";
  says(complaint(file), "meshes[0].primitives[0] has an index past the end");
  file.primitives = R"({"attributes":{"POSITION":0},"indices":2})";
  says(complaint(file), "unsigned whole numbers");
  file.primitives = R"({"attributes":{"POSITION":3}})";
  file.accessor("VEC3", 5126, 3,
                R"(,"sparse":{"count":1,"indices":{"bufferView":1,"componentType":5123,"byteOffset":4},
"values":{"bufferView":0}})");
  says(complaint(file), "names an element that accessors[3] does not have");
  file.accessors.back() = replaced(file.accessors.back(), R"("sparse":{"count":1)", R"("sparse":{"count":9)");
  says(complaint(file), "more elements");
}

TEST_CASE("nodes in circles, with two parents, or not there") {
  GltfText file = one_triangle();
  file.nodes = R"({"children":[1]},{"children":[0]})";
  says(complaint(file), "reached twice");
  file.nodes = R"({"children":[0]})";
  says(complaint(file), "reached twice");
  file.nodes = R"({"children":[1,2]},{"children":[2]},{})";
  says(complaint(file), "reached twice");
  file.nodes = R"({"children":[5]})";
  says(complaint(file), "nodes[5] is referred to");
}

TEST_CASE("references to what is not in the file, and values of the wrong kind") {
  says(triangle_with(R"("mesh":0)", R"("mesh":1)"), "meshes[1] is referred to");
  says(triangle_with(R"("mesh":0)", R"("mesh":"zero")"), "nodes[0].mesh is not a whole number");
  says(triangle_with(R"("POSITION":0})", R"("POSITION":0},"material":0)"), "material is not in the file");
  says(triangle_with(R"("POSITION":0})", R"("POSITION":0},"mode":9)"), "mode is none of glTF's");
  says(triangle_with(R"({"attributes":{"POSITION":0}})", ""), "primitives is missing");
  says(triangle_with(R"("scene":0)", R"("scene":3)"), "'scene' names a scene");
  says(triangle_with(R"("mesh":0)", R"("mesh":0,"matrix":[1,2,3])"), "matrix has 3 numbers instead of 16");
}

TEST_CASE("a small file cannot ask for work without end") {
  GltfText file;
  file.positions(std::vector<float>(3000, 0.0f));
  file.values("SCALAR", 5121, 3000, std::vector<uint8_t>(3000));
  for (int i = 0; i < 400; ++i)
    file.primitives += std::string(i ? "," : "") + R"({"attributes":{"POSITION":0},"indices":1})";
  const Folder folder;
  const auto path = folder.write("scene.gltf", file.gltf());
  std::vector<std::string> clauses;
  scene::Notes notes(clauses);
  scene::Document enough(path, scene::Reach::folder, 10000000), little(path, scene::Reach::folder, 1000000);
  CHECK(scene::read_mesh(enough, 0, 0, notes).triangles.size() == 400000);
  CHECK_THROWS_WITH_AS((void)scene::read_mesh(little, 0, 0, notes), doctest::Contains("too large"), scene::Fault);
}

TEST_CASE("animations that do not fit together") {
  GltfText file = one_triangle();
  file.values<float>("SCALAR", 5126, 2, {1, 0});
  file.values<float>("SCALAR", 5126, 2, {0, 1});
  file.values<float>("VEC3", 5126, 1, {0, 0, 0});
  const auto animation = [&](const std::string& sampler, const std::string& path) {
    file.more = R"(,"animations":[{"channels":[{"sampler":0,"target":{"node":0,"path":")" + path +
                R"("}}],"samplers":[)" + sampler + "]}]";
    return complaint(file);
  };
  says(animation(R"({"input":1,"output":3})", "translation"), "times that fall");
  says(animation(R"({"input":2,"output":3})", "translation"), "as many values");
  says(animation(R"({"input":2,"output":3})", "rotation"), "wrong type");
  says(animation(R"({"input":2,"output":3,"interpolation":"MAGIC"})", "scale"), "'MAGIC'");
  says(animation(R"({"input":2})", "scale"), "output is missing");
  says(animation("", "scale"), "samplers[0] is referred to");
}

TEST_CASE("a picture that claims to be huge is left out, not unpacked") {
  // The head of a PNG of 16000 x 16000 texels, and of one of 100000 x 100000.
  for (const std::string& size :
       {std::string("\0\0\x3E\x80\0\0\x3E\x80", 8), std::string("\0\1\x86\xA0\0\1\x86\xA0", 8)}) {
    GltfText file = one_triangle();
    file.view(std::string("\x89PNG\r\n\x1A\n\0\0\0\rIHDR", 16) + size + std::string("\x08\x06\0\0\0\0\0\0\0", 9));
    file.primitives = R"({"attributes":{"POSITION":0},"material":0})";
    file.more =
        R"(,"materials":[{"emissiveTexture":{"index":0}}],"textures":[{"source":0}],"images":[{"bufferView":1,
"mimeType":"image/png"}])";
    const scene::Scene scene = file.load();
    CHECK(scene.images.empty());
    CHECK(scene.unsupported.size() == 1);
  }
}
