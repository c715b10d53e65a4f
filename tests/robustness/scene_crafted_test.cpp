// Files crafted against glTF readers: each loads, or ends with a line that names what is wrong; none crashes or hangs.

#include <doctest/doctest.h>

#include <ctime>

#include "complaint.h"

using namespace crsh;
using test::complaint;
using test::Folder;
using test::GltfText;
using test::one_triangle;
using test::replaced;
using test::says;

namespace {

std::string nested(const std::string& open, const std::string& close, size_t depth) {
  std::string out;
  for (size_t i = 0; i < depth; ++i) out += open;
  out += "1";
  for (size_t i = 0; i < depth; ++i) out += close;
  return out;
}

std::string triangle_with(const std::string& from, const std::string& to) {
  return complaint(replaced(one_triangle().gltf(), from, to));
}

/// The triangle's file with a textured material, whose image is `image`.
GltfText textured(const std::string& image) {
  GltfText file = one_triangle();
  file.primitives = R"({"attributes":{"POSITION":0},"material":0})";
  file.more = R"(,"materials":[{"emissiveTexture":{"index":0}}],"textures":[{"source":0}],"images":[)" + image + "]";
  return file;
}

/// The processor's: others may keep the machine busy.
double seconds_to_load(const std::string& content) {
  const Folder folder;
  const auto path = folder.write("scene.gltf", content);
  const std::clock_t start = std::clock();
  CHECK(scene::load(path).triangle_count() > 0);
  return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

}  // namespace

TEST_CASE("extras nested 200,000 deep are refused where they open, and the level allowed last is not") {
  for (const auto& [open, close] : {std::pair("[", "]"), {R"({"a":)", "}"}}) {
    GltfText file = one_triangle();
    file.more = R"(,"extras":)" + nested(open, close, 200000);
    says(complaint(file), "nests deeper than 64 levels at byte ");
    file.more = R"(,"extras":)" + nested(open, close, 64);
    says(complaint(file), "nests deeper than 64 levels");
    file.more = R"(,"extras":)" + nested(open, close, 63);
    CHECK(complaint(file).empty());
  }
}

TEST_CASE("brackets in strings do not nest") {
  GltfText file = one_triangle();
  file.more = R"(,"extras":")" + std::string(1000, '[') + R"(\"[\\","extensionsUsed":[])";
  CHECK(complaint(file).empty());
}

TEST_CASE("more values than any scene has are refused before they are stored") {
  GltfText file = one_triangle();
  file.more = R"(,"extras":[0)";
  for (size_t i = 0; i < (size_t{1} << 24u); ++i) file.more += ",0";
  file.more += "]";
  says(complaint(file), "more than 16 million values");
}

TEST_CASE("lists that take too much memory are refused, however short they are in the file") {
  GltfText file = one_triangle();
  file.more = R"(,"materials":[{})";
  for (int i = 0; i < 3000000; ++i) file.more += ",{}";
  file.more += "]";
  says(complaint(file), "is too large to be drawn");
}

TEST_CASE("an image's view that reaches outside its buffer, or names none, leaves the image out") {
  for (const char* view :
       {R"({"buffer":0,"byteOffset":1000000,"byteLength":8})", R"({"buffer":0,"byteOffset":0,"byteLength":1000000})",
        R"({"buffer":0,"byteOffset":1099511627776,"byteLength":1099511627776})"}) {
    GltfText file = textured(R"({"bufferView":1,"mimeType":"image/png"})");
    file.views.emplace_back(view);
    const scene::Scene scene = file.load();
    CHECK(scene.images.empty());
    says(scene.unsupported.at(0), "images[0] (bufferViews[1] reaches past the end of its buffer");
  }
  says(textured(R"({"bufferView":9})").load().unsupported.at(0), "bufferViews[9] is referred to");
  GltfText file = textured(R"({"bufferView":1})");
  file.views.emplace_back(R"({"buffer":7,"byteLength":1})");
  says(file.load().unsupported.at(0), "buffers[7] is referred to");
}

TEST_CASE("a BIN chunk that is longer or shorter than its file says") {
  const Folder folder;
  const std::string whole = one_triangle().glb();
  const size_t chunk = whole.size() - 36 - 8;  // its length, its type, then three positions
  for (const int more : {8, 4, 1000, -8}) {
    std::string broken = whole;
    broken[chunk] = static_cast<char>(36 + more);
    broken[chunk + 1] = static_cast<char>((36 + more) >> 8);
    says(complaint(folder.write("bin.glb", broken)), "is cut short");
  }
  CHECK(complaint(folder.write("whole.glb", whole)).empty());
}

TEST_CASE("empty buffers") {
  const Folder folder;
  GltfText file = one_triangle();
  folder.write("empty.bin", "");
  says(complaint(folder.write("a.gltf", file.text(R"(,"uri":"empty.bin")"))), "buffers[0] is cut short: 0 of 36 bytes");
  says(complaint(file.text(R"(,"uri":"data:application/octet-stream;base64,")")), "cut short: 0 of 36 bytes");
  says(triangle_with(R"("buffers":[{"byteLength":36)", R"("buffers":[{"byteLength":0)"), "bufferViews[0] reaches past");
  const std::string json = test::glb_chunk(0x4E4F534A, file.text(""), ' ') + test::glb_chunk(0x004E4942, "", '\0');
  says(complaint(folder.write(
           "b.glb", test::bytes_of<uint32_t>({0x46546C67, 2, static_cast<uint32_t>(12 + json.size())}) + json)),
       "buffers[0] is cut short: 0 of 36 bytes");
}

TEST_CASE("60,000 nodes load in well under a second, nested, too") {
  std::string flat = R"({"mesh":0})", deep = R"({"children":[1]})", children = "1";
  for (int i = 1; i < 60000; ++i) {
    flat += R"(,{"name":"n","translation":[1,2,3.5],"rotation":[0,0,0,1.0]})";
    deep += i < 59999 ? R"(,{"children":[)" + std::to_string(i + 1) + "]}" : R"(,{"mesh":0})";
    if (i > 1) children += "," + std::to_string(i);
  }
  GltfText file = one_triangle();
  file.nodes = deep;
  CHECK(seconds_to_load(file.gltf()) < 5);  // with the sanitisers; a fifth of a second without
  file.nodes = R"({"children":[)" + children + "]}" + flat.substr(flat.find(','));
  file.nodes.replace(file.nodes.rfind('{'), std::string::npos, R"({"mesh":0})");
  CHECK(seconds_to_load(file.gltf()) < 5);
}

TEST_CASE("indices that tinygltf would cut down to 32 bits are refused by name") {
  for (const char* number : {"4294967296", "4294967295", "2147483648", "1e30", "0.5", "-1", "null", "[]"}) {
    CAPTURE(number);
    says(triangle_with(R"("mesh":0)", R"("mesh":)" + std::string(number)),
         "nodes[0].mesh is not a whole number in range");
    says(triangle_with(R"("nodes":[0])", R"("nodes":[)" + std::string(number) + "]"),
         "scenes[0].nodes is not a whole number in range");
    says(triangle_with(R"("POSITION":0)", R"("POSITION":)" + std::string(number)),
         "meshes[0].primitives[0].attributes.POSITION is not a whole number in range");
  }
}

TEST_CASE("whole numbers written as floats are whole") {
  std::string text = one_triangle().gltf();
  for (const auto& [from, to] : {std::pair(R"("mesh":0)", R"("mesh":0.0)"),
                                 {R"("nodes":[0])", R"("nodes":[0.0])"},
                                 {R"("scene":0)", R"("scene":0e0)"},
                                 {R"("componentType":5126)", R"("componentType":5126.0)"},
                                 {R"("count":3)", R"("count":3.0)"},
                                 {R"("POSITION":0)", R"("POSITION":-0.0)"},
                                 {R"("byteLength":36})", R"("byteLength":3.6e1})"}})
    text = replaced(text, from, to);
  CHECK(complaint(text).empty());
}

TEST_CASE("numbers in extensions are not cut down to 32 bits") {
  GltfText file = one_triangle();
  file.nodes = R"({"mesh":0,"extensions":{"KHR_lights_punctual":{"light":0}}})";
  file.more = R"(,"extensions":{"KHR_lights_punctual":{"lights":[{"type":"point","intensity":5000000000}]}})";
  CHECK(file.load().lights.at(0).intensity == 5e9f);
}

TEST_CASE("fields of the wrong kind are named") {
  const auto with = [](const std::string& more) {
    GltfText file = one_triangle();
    file.more = more;
    return complaint(file);
  };
  says(with(R"(,"materials":[{"emissiveFactor":[1,1,1,1]}])"),
       "materials[0].emissiveFactor has 4 numbers instead of 3");
  says(with(R"(,"materials":[{"emissiveFactor":[1,1,"x"]}])"), "materials[0].emissiveFactor is not a finite number");
  says(with(R"(,"materials":[{"doubleSided":1}])"), "materials[0].doubleSided is neither true nor false");
  says(with(R"(,"materials":[{"name":1}])"), "materials[0].name is not a string");
  says(with(R"(,"materials":{})"), "materials is not an array");
  says(with(R"(,"extensionsUsed":[1])"), "extensionsUsed holds something that is not a string");
  says(with(R"(,"extensionsRequired":["A\u0007B"])"), "needs the extension A B");
}

TEST_CASE("what crsh does not read does not matter, whatever it holds") {
  GltfText file = one_triangle();
  file.nodes = R"({"mesh":0,"mask":"none","extensions":{"EXT_x":[1],"MSFT_lod":{},"KHR_audio":{}},"extras":[[]]})";
  file.more = R"(,"materials":[{"lineTexture":{"scale":null},"extensions":{"KHR_materials_none":7}}],"audio":null)";
  CHECK(complaint(file).empty());
}

TEST_CASE("a stride that is no multiple of four, and one of more than 252 bytes") {
  GltfText file;
  const size_t view = file.view(test::bytes_of<float>(std::vector<float>(200, 0.0f)), R"(,"byteStride":260)");
  file.accessor("VEC3", 5126, 3, R"(,"bufferView":)" + std::to_string(view));
  const size_t bytes = file.view(std::string("\0\0\1\0\2\0", 6), R"(,"byteStride":2)");
  file.accessor("SCALAR", 5123, 3, R"(,"bufferView":)" + std::to_string(bytes));
  file.primitives = R"({"attributes":{"POSITION":0},"indices":1})";
  CHECK(file.load().triangle_count() == 1);
}

TEST_CASE("indices without a bufferView stand for zeros, also where a sparse part replaces some") {
  GltfText file = one_triangle();
  const size_t places = file.view(std::string("\1\2", 2)), values = file.view(std::string("\1\2", 2));
  const std::string sparse = R"(,"sparse":{"count":2,"indices":{"componentType":5121,"bufferView":)" +
                             std::to_string(places) + R"(},"values":{"bufferView":)" + std::to_string(values) + "}}";
  file.accessor("SCALAR", 5121, 3, sparse);
  file.accessor("SCALAR", 5121, 3, "");
  file.primitives = R"({"attributes":{"POSITION":0},"indices":1},{"attributes":{"POSITION":0},"indices":2})";
  const scene::Scene scene = file.load();
  CHECK(scene.meshes.at(0).triangles.at(0) == glm::uvec3(0, 1, 2));
  CHECK(scene.meshes[0].triangles.at(1) == glm::uvec3(0, 0, 0));
}

TEST_CASE("a primitive's indices that name no accessor, and an accessor of them that names no bufferView") {
  GltfText file = one_triangle();
  file.primitives = R"({"attributes":{"POSITION":0},"indices":5})";
  says(complaint(file), "accessors[5] is referred to but is not in the file");
  file.accessor("SCALAR", 5121, 3, R"(,"bufferView":8)");
  file.primitives = R"({"attributes":{"POSITION":0},"indices":1})";
  says(complaint(file), "bufferViews[8] is referred to but is not in the file");
}
