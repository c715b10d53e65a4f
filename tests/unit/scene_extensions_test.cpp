// Which extensions a file may ask for, and what is said of the others.

#include <doctest/doctest.h>

#include "crsh/error.h"
#include "scene/gltf/known_extensions.h"
#include "scene_file.h"

using namespace crsh;
using test::Folder;
using test::GltfText;
using test::one_triangle;
using Lines = std::vector<std::string>;

namespace {

/// A triangle in a file with these lists of extensions.
GltfText asking_for(const std::string& used, const std::string& required = "") {
  GltfText file = one_triangle();
  file.more = R"(,"extensionsUsed":[)" + used + R"(],"extensionsRequired":[)" + required + "]";
  return file;
}

scene::Scene load_leniently(const GltfText& file) {
  const Folder folder;
  return scene::load(folder.write("scene.gltf", file.gltf()), scene::LoadOptions{.lenient = true});
}

}  // namespace

TEST_CASE("required extensions that are unknown or change geometry are all named in one line") {
  const GltfText file =
      asking_for("", R"("KHR_texture_basisu","EXT_none","CESIUM_RTC","KHR_materials_unlit","ZZ_none")");
  CHECK_THROWS_WITH_AS((void)file.load(),
                       doctest::Contains("needs the extensions CESIUM_RTC, EXT_none and ZZ_none, which"),
                       scene::ExtensionError);
  CHECK_THROWS_WITH((void)asking_for("", R"("EXT_none")").load(),
                    doctest::Contains("needs the extension EXT_none, which"));
}

TEST_CASE("a file is drawn leniently without them, with a line for each") {
  const scene::Scene scene = load_leniently(asking_for(R"("EXT_none")", R"("EXT_none","CESIUM_RTC")"));
  CHECK(scene.triangle_count() == 1);
  CHECK(scene.unsupported ==
        Lines{"extension CESIUM_RTC, which the file requires", "extension EXT_none, which the file requires"});
}

TEST_CASE("required extensions that are done, say nothing of pictures or only add are no reason to refuse") {
  for (const char* name : {"KHR_texture_transform", "KHR_materials_unlit", "KHR_draco_mesh_compression",
                           "EXT_meshopt_compression", "KHR_materials_variants", "KHR_node_visibility", "KHR_xmp",
                           "KHR_xmp_json_ld", "KHR_node_hoverability", "KHR_node_selectability"}) {
    CAPTURE(name);
    CHECK(asking_for("", '"' + std::string(name) + '"').load().unsupported.empty());
  }
  CHECK(asking_for("", R"("EXT_lights_image_based")").load().unsupported ==
        Lines{"extension EXT_lights_image_based, which the file requires"});
}

TEST_CASE("an extension that stands in the file without being listed is read, or said to be left out; extras are not") {
  GltfText file = one_triangle();
  file.nodes = R"({"mesh":0,"extensions":{"EXT_a":{},"KHR_lights_punctual":{"light":0}}})";
  file.more =
      R"(,"extensions":{"EXT_b":{"inner":[{"extensions":{"EXT_c":1}}]},
"KHR_lights_punctual":{"lights":[{"type":"point"}]}},
"extras":{"extensions":{"EXT_d":{}}})";
  const scene::Scene scene = file.load();
  CHECK(scene.lights.size() == 1);
  CHECK(scene.unsupported == Lines{"extension EXT_a", "extension EXT_b", "extension EXT_c"});
}

TEST_CASE("what an extension is to crsh stands in one table") {
  CHECK(scene::support_of("KHR_lights_punctual") == scene::Support::done);
  CHECK(scene::support_of("KHR_xmp") == scene::Support::harmless);
  CHECK_FALSE(scene::support_of("KHR_lights"));
}
