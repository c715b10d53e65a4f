// Which image stands for a texture, and that it makes no difference how many threads decode it.

#include <doctest/doctest.h>

#include <atomic>
#include <stdexcept>

#include "crsh/error.h"
#include "scene/gltf/decode_images.h"
#include "scene_file.h"
#include "support/image_files.h"

using namespace crsh;
using test::GltfText;
using test::one_triangle;
using Notes = std::vector<std::string>;

namespace {

std::span<const uint8_t> bytes_of(const std::string& file) {
  return {reinterpret_cast<const uint8_t*>(file.data()), file.size()};
}

/// A triangle whose material's base colour is texture 0. Of `textures` the JSON, of `images` the files.
GltfText textured(const std::string& textures, const Notes& images, const std::string& more = "") {
  GltfText file = one_triangle();
  file.primitives = R"({"attributes":{"POSITION":0},"material":0})";
  std::string list;
  for (const std::string& image : images)
    list += (list.empty() ? "" : ",") + std::string(R"({"mimeType":"image/png","bufferView":)") +
            std::to_string(file.view(image)) + "}";
  file.more = R"(,"materials":[{"pbrMetallicRoughness":{"baseColorTexture":{"index":0}}}],"textures":[)" + textures +
              R"(],"images":[)" + list + "]" + more;
  return file;
}

std::string with(const std::string& extension, const std::string& more = "") {
  return R"({"extensions":{")" + extension + R"(":{"source":0}})" + more + "}";
}

/// The width of the picture that is drawn, 0 where none is.
uint32_t width_drawn(const scene::Scene& scene) {
  const auto texture = scene.materials.at(0).texture(scene::Slot::base_colour).texture;
  return texture ? scene.images.at(scene.textures.at(*texture).image).width : 0;
}

const std::string ktx2 = std::string("\xABKTX 20\xBB\r\n\x1A\n\0\0\0\0", 16);
const std::string png = png_file(test::ramps(5, 4, 4)), webp = webp_file(test::ramps(6, 4, 4), true);
const std::string fallback = R"(,"source":1)";

}  // namespace

TEST_CASE("a texture's WebP and AVIF are drawn, required or not, with a fallback or without") {
  const std::string avif = test::avif_file(test::ramps(6, 4, 4));
  for (const auto& [extension, image] : {std::pair("EXT_texture_webp", webp), {"EXT_texture_avif", avif}}) {
    const std::string required =
        R"(,"extensionsRequired":[")" + std::string(extension) + R"("],"extensionsUsed":[")" + extension + R"("])";
    const scene::Scene alone = textured(with(extension), {image}, required).load();
    CHECK(width_drawn(alone) == 6);
    CHECK(alone.unsupported.empty());
    const scene::Scene both = textured(with(extension, fallback), {image, png}).load();
    CHECK(width_drawn(both) == 6);
    CHECK(both.images.size() == 1);
    CHECK(both.unsupported.empty());
  }
}

TEST_CASE("what a picture is says its content, not its extension or type") {
  CHECK(width_drawn(textured(R"({"source":0})", {webp}).load()) == 6);
  CHECK(width_drawn(textured(with("EXT_texture_webp"), {png}).load()) == 5);
}

TEST_CASE("beside Basis Universal the fallback is drawn; without one a line says so") {
  const std::string used = R"(,"extensionsUsed":["KHR_texture_basisu"])";
  const scene::Scene both = textured(with("KHR_texture_basisu", fallback), {ktx2, png}, used).load();
  CHECK(width_drawn(both) == 5);
  CHECK(both.unsupported.empty());
  const scene::Scene alone =
      textured(with("KHR_texture_basisu"), {ktx2}, used + R"(,"extensionsRequired":["KHR_texture_basisu"])").load();
  CHECK(width_drawn(alone) == 0);
  CHECK(alone.unsupported == Notes{"texture images[0] (is KTX2, which crsh does not read: drawn without it)"});
}

TEST_CASE("beside a broken picture the fallback is drawn, with a line") {
  const std::string broken = webp.substr(0, webp.size() / 2);
  const scene::Scene scene = textured(with("EXT_texture_webp", fallback), {broken, png}).load();
  CHECK(width_drawn(scene) == 5);
  CHECK(scene.images.size() == 1);
  CHECK(scene.unsupported == Notes{"texture images[0] (is cut short: images[1] is drawn)"});
  const scene::Scene none = textured(with("EXT_texture_webp", fallback), {broken, png.substr(0, 60)}).load();
  CHECK(width_drawn(none) == 0);
  CHECK(none.unsupported.size() == 2);
}

TEST_CASE("a texture without an image, and one whose image is not in the file, are drawn without, with a line") {
  CHECK(textured("{}", {}).load().unsupported == Notes{"textures without an image (drawn without them)"});
  CHECK(textured(R"({"source":3})", {png}).load().unsupported ==
        Notes{"texture images[3] (images[3] is referred to but is not in the file: drawn without it)"});
}

TEST_CASE("of a JPEG that ends early the rest is grey, and a line says so") {
  const std::string jpeg = jpeg_file(test::ramps(64, 64, 3));
  const scene::Scene scene = textured(R"({"source":0})", {jpeg.substr(0, jpeg.size() / 2)}).load();
  CHECK(scene.unsupported == Notes{"texture images[0] (is cut short: drawn as far as it goes)"});
  const std::vector<uint8_t> whole = textured(R"({"source":0})", {jpeg}).load().images.at(0).rgba;
  const std::vector<uint8_t>& half = scene.images.at(0).rgba;
  CHECK(std::equal(half.begin(), half.begin() + 64 * 4 * 16, whole.begin()));
  CHECK(half[half.size() - 4] == half[half.size() - 3]);
}

TEST_CASE("pictures past 2 GiB are drawn without, in the order in which materials name them") {
  // Heads of 8192 x 8192 texels, each just long enough to be believed, and a small picture last.
  const std::string head =
      std::string("\x89PNG\r\n\x1A\n\0\0\0\rIHDR\0\0\x20\0\0\0\x20\0\x08\x06\0\0\0", 29) + std::string(8200, '\0');
  GltfText file = textured(R"({"source":0})", Notes(10, head));
  file.primitives = "";
  std::string materials, textures;
  for (int i = 0; i < 10; ++i) {
    const std::string n = std::to_string(9 - i), comma = i == 0 ? "" : ",";
    file.primitives += comma + R"({"attributes":{"POSITION":0},"material":)" + std::to_string(i) + "}";
    materials += comma + R"({"emissiveTexture":{"index":)" + std::to_string(i) + "}}";
    textures += comma + R"({"source":)" + n + "}";
  }
  const std::string images = file.more.substr(file.more.find(R"("images")"));
  file.more = R"(,"materials":[)" + materials + R"(],"textures":[)" + textures + "]," + images;
  const Notes notes = file.load().unsupported;
  REQUIRE(notes.size() == 10);
  CHECK(notes[0] == "texture images[9] (cannot be decoded: drawn without it)");
  CHECK(notes[7] == "texture images[2] (cannot be decoded: drawn without it)");
  CHECK(notes[8] == "texture images[1] (and those before it take more than 2 GiB: drawn without it)");
  CHECK(notes[9] == "texture images[0] (and those before it take more than 2 GiB: drawn without it)");
}

TEST_CASE("any number of threads decodes the same, in the same order") {
  std::vector<std::string> files;
  for (uint32_t i = 1; i < 40; ++i) {
    files.push_back(i % 3 == 0 ? jpeg_file(test::ramps(i, 7, 3)) : png_file(test::ramps(i, 41 - i, 4)));
    if (i % 7 == 0) files.back().resize(files.back().size() - 30);
  }
  std::vector<scene::EncodedImage> images;
  for (const std::string& file : files) images.push_back({bytes_of(file), scene::image_size(bytes_of(file))});
  const std::vector<scene::Decoding> one = scene::decode_images(images, 1);
  for (const unsigned threads : {2u, 5u, 64u}) {
    const std::vector<scene::Decoding> many = scene::decode_images(images, threads);
    REQUIRE(many.size() == files.size());
    for (size_t i = 0; i < many.size(); ++i) {
      CHECK(many[i].fault == one[i].fault);
      REQUIRE(many[i].picture.has_value() == one[i].picture.has_value());
      if (one[i].picture) CHECK(many[i].picture->image.rgba == one[i].picture->image.rgba);
      if (one[i].picture) CHECK(one[i].picture->image.width == images[i].size.width);
    }
  }
}

TEST_CASE("a parallel loop does each round once, and throws what the lowest threw") {
  for (const unsigned threads : {0u, 1u, 3u, 200u}) {
    std::vector<std::atomic<int>> done(100);
    scene::in_parallel(done.size(), threads, [&](size_t i) { ++done[i]; });
    for (const std::atomic<int>& count : done) CHECK(count == 1);
    CHECK_THROWS_WITH(scene::in_parallel(done.size(), threads,
                                         [](size_t i) {
                                           if (i % 10 == 7) throw std::runtime_error(std::to_string(i));
                                         }),
                      "7");
  }
  scene::in_parallel(0, 4, [](size_t) { FAIL("nothing to do"); });
}
