// Materials, textures, and what of them is left out.

#include <doctest/doctest.h>

#include <algorithm>

#include "crsh/error.h"
#include "scene_file.h"

using namespace crsh;
using test::Folder;
using test::GltfText;
using test::one_triangle;

namespace {

/// A PNG of 2 x 1 texels: red, half-transparent blue.
const char* const png =
    "data:image/"
    "png;base64,iVBORw0KGgoAAAANSUhEUgAAAAIAAAABCAYAAAD0In+KAAAADklEQVR4nGP4z8AAQg0AD3oDfnfpf5cAAAAASUVORK5CYII=";

GltfText with_material(const std::string& material, const std::string& more = "") {
  GltfText file = one_triangle();
  file.primitives = R"({"attributes":{"POSITION":0},"material":0})";
  file.more = R"(,"materials":[)" + material + "]" + more;
  return file;
}

const std::string textures =
    R"(,"textures":[{"source":0},{"source":0,"sampler":0}],"samplers":[{"wrapS":33071,"wrapT":33648,"magFilter":9728,
"minFilter":9987}],)";

std::vector<std::string> notes_of(const std::string& material, const std::string& more = "") {
  return with_material(material, more).load().unsupported;
}

}  // namespace

TEST_CASE("factors and their defaults") {
  const scene::Scene scene = with_material(R"({"name":"x","doubleSided":true,"emissiveFactor":[1,0.5,0],
    "pbrMetallicRoughness":{"baseColorFactor":[0.1,0.2,0.3,0.4],"metallicFactor":0.25,"roughnessFactor":0.75},
    "extensions":{"KHR_materials_emissive_strength":{"emissiveStrength":4},"KHR_materials_ior":{"ior":1.33},
      "KHR_materials_transmission":{"transmissionFactor":0.9},"KHR_materials_volume":{"thicknessFactor":0.2}}})")
                                 .load();
  const scene::Material& m = scene.materials.at(0);
  CHECK(m.name == "x");
  CHECK(m.double_sided);
  CHECK(m.base_colour == glm::vec4(0.1f, 0.2f, 0.3f, 0.4f));
  CHECK(m.emissive == glm::vec3(4, 2, 0));
  CHECK(m.metallic == 0.25f);
  CHECK(m.roughness == 0.75f);
  CHECK(m.ior == 1.33f);
  CHECK(m.transmission == 0.9f);
  CHECK(m.thickness == 0.2f);
  CHECK(scene.unsupported.empty());
  const scene::Material& standard = scene.materials.back();
  CHECK(standard.base_colour == glm::vec4(1));
  CHECK(standard.metallic == 1);
  CHECK_FALSE(standard.double_sided);
}

TEST_CASE("textures bring their image, sampler and coordinates; one image is decoded once") {
  const scene::Scene scene = with_material(R"({"emissiveTexture":{"index":0},"pbrMetallicRoughness":{
    "baseColorTexture":{"index":1,"texCoord":1},"metallicRoughnessTexture":{"index":1}}})",
                                           textures + R"("images":[{"uri":")" + png + R"("}])")
                                 .load();
  const scene::Material& m = scene.materials.at(0);
  REQUIRE(scene.images.size() == 1);
  CHECK(scene.images[0].width == 2);
  CHECK(scene.images[0].height == 1);
  CHECK(scene.images[0].rgba == std::vector<uint8_t>{255, 0, 0, 255, 0, 0, 255, 128});
  CHECK(scene.textures.size() == 2);
  CHECK(m.texture(scene::Slot::base_colour).texcoord == 1);
  const scene::Texture& base = scene.textures.at(m.texture(scene::Slot::base_colour).texture.value());
  CHECK(base.wrap_s == scene::Wrap::clamp);
  CHECK(base.wrap_t == scene::Wrap::mirror);
  CHECK(base.nearest);
  const scene::Texture& emissive = scene.textures.at(m.texture(scene::Slot::emissive).texture.value());
  CHECK(emissive.wrap_s == scene::Wrap::repeat);
  CHECK_FALSE(emissive.nearest);
  CHECK(m.texture(scene::Slot::metallic_roughness).texture == m.texture(scene::Slot::base_colour).texture);
  CHECK_FALSE(m.texture(scene::Slot::transmission).texture.has_value());
}

TEST_CASE("a texture whose image is missing or broken is left out with a note") {
  const std::string material = R"({"emissiveTexture":{"index":0}})";
  for (const std::string uri :
       {"none.png", "data:image/png;base64,AAAA", "https://example.com/a.png", "data:image/png;base64,!"}) {
    const scene::Scene scene = with_material(material, textures + R"("images":[{"uri":")" + uri + R"("}])").load();
    CHECK_FALSE(scene.materials.at(0).texture(scene::Slot::emissive).texture.has_value());
    REQUIRE(scene.unsupported.size() == 1);
    CHECK(scene.unsupported[0].find("drawn without it") != std::string::npos);
  }
}

TEST_CASE("images of materials that nothing wears are not read") {
  CHECK(notes_of(R"({},{"emissiveTexture":{"index":0},"normalTexture":{"index":0}})",
                 textures + R"("images":[{"uri":"none.png"}])")
            .empty());
}

TEST_CASE("what is asked for and not done is said once, in a clause") {
  using Notes = std::vector<std::string>;
  const std::string image = textures + R"("images":[{"uri":")" + std::string(png) + R"("}])";
  CHECK(notes_of(R"({"normalTexture":{"index":0},"occlusionTexture":{"index":0}})", image) ==
        Notes{"normal maps", "occlusion maps"});
  CHECK(notes_of(R"({"alphaMode":"MASK"})") == Notes{"alphaMode MASK (drawn opaque)"});
  CHECK(notes_of(R"({"alphaMode":"OPAQUE"})").empty());
  CHECK(notes_of(
            R"({"extensions":{"KHR_materials_volume":{"thicknessFactor":1,"attenuationDistance":2,
"attenuationColor":[1,0,0],
    "thicknessTexture":{"index":0}}}})",
            image) == Notes{"thickness textures", "attenuation in volumes"});
  CHECK(
      notes_of("{}", R"(,"extensionsUsed":["KHR_materials_unlit","KHR_materials_unlit","KHR_materials_ior","A\nB"])") ==
      Notes{"extension KHR_materials_unlit", "extension A B"});
}

TEST_CASE("an extension that is required and not done ends with its name") {
  GltfText file = one_triangle();
  file.more = R"(,"extensionsRequired":["KHR_draco_mesh_compression"])";
  CHECK_THROWS_WITH_AS((void)file.load(), doctest::Contains("needs the extension KHR_draco_mesh_compression"),
                       UserError);
  file.more = R"(,"extensionsRequired":["KHR_lights_punctual","KHR_mesh_quantization"])";
  CHECK(file.load().triangle_count() == 1);
}
