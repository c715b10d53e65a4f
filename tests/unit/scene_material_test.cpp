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

TEST_CASE("every field of a material's extensions is read") {
  const scene::Scene scene = with_material(R"({"alphaMode":"MASK","alphaCutoff":0.25,
    "normalTexture":{"index":0,"scale":0.5},"occlusionTexture":{"index":0,"strength":0.75,"texCoord":2},
    "extensions":{"KHR_materials_unlit":{},
      "KHR_materials_specular":{"specularFactor":0.5,"specularColorFactor":[0.1,0.2,3]},
      "KHR_materials_clearcoat":{"clearcoatFactor":0.6,"clearcoatRoughnessFactor":0.1,
        "clearcoatNormalTexture":{"index":1,"scale":2}},
      "KHR_materials_sheen":{"sheenColorFactor":[1,0.5,0.25],"sheenRoughnessFactor":0.3},
      "KHR_materials_iridescence":{"iridescenceFactor":1,"iridescenceIor":1.8,"iridescenceThicknessMaximum":500},
      "KHR_materials_anisotropy":{"anisotropyStrength":0.9,"anisotropyRotation":1.5},
      "KHR_materials_volume":{"thicknessFactor":2,"attenuationDistance":3,"attenuationColor":[0.5,0.25,1]},
      "KHR_materials_dispersion":{"dispersion":0.1},
      "KHR_materials_diffuse_transmission":{"diffuseTransmissionFactor":0.4,
        "diffuseTransmissionColorFactor":[1,0,0]}}})",
                                           textures + R"("images":[{"uri":")" + png + R"("}])")
                                 .load();
  const scene::Material& m = scene.materials.at(0);
  CHECK(m.alpha_mode == scene::AlphaMode::mask);
  CHECK(m.alpha_cutoff == 0.25f);
  CHECK(m.normal_scale == 0.5f);
  CHECK(m.occlusion_strength == 0.75f);
  CHECK(m.texture(scene::Slot::occlusion).texcoord == 2);
  CHECK(m.unlit);
  CHECK(m.specular == scene::Specular{0.5f, {0.1f, 0.2f, 3}});
  CHECK(m.clearcoat == scene::Clearcoat{0.6f, 0.1f, 2});
  CHECK(m.texture(scene::Slot::clearcoat_normal).texture.has_value());
  CHECK(m.sheen == scene::Sheen{{1, 0.5f, 0.25f}, 0.3f});
  CHECK(m.iridescence == scene::Iridescence{1, 1.8f, 100, 500});
  CHECK(m.anisotropy == scene::Anisotropy{0.9f, 1.5f});
  CHECK(m.attenuation == scene::Attenuation{{0.5f, 0.25f, 1}, 3});
  CHECK(m.dispersion == 0.1f);
  CHECK(m.diffuse_transmission == scene::DiffuseTransmission{0.4f, {1, 0, 0}});
  CHECK(scene::has_lobes(m));
  CHECK(scene::needs_tangents(m));
  CHECK_FALSE(scene::has_lobes(scene.materials.back()));
}

TEST_CASE("specular and glossiness stand in place of metal and roughness") {
  const scene::Scene scene = with_material(R"({"pbrMetallicRoughness":{"baseColorFactor":[1,0,0,1],"metallicFactor":1},
    "extensions":{"KHR_materials_pbrSpecularGlossiness":{"diffuseFactor":[0,0.5,1,0.5],"specularFactor":[0.1,0.2,0.3],
      "glossinessFactor":0.75}}})")
                                 .load();
  const scene::Material& m = scene.materials.at(0);
  CHECK(m.base_colour == glm::vec4(0, 0.5f, 1, 0.5f));
  CHECK(m.metallic == 0);
  CHECK(m.roughness == 0.25f);
  REQUIRE(m.specular_glossiness);
  CHECK(*m.specular_glossiness == scene::SpecularGlossiness{{0.1f, 0.2f, 0.3f}, 0.75f});
}

TEST_CASE("texture transforms and filters are read, and a transform may choose the coordinates") {
  const scene::Scene scene =
      with_material(
          R"({"emissiveTexture":{"index":0,"texCoord":1,"extensions":{"KHR_texture_transform":
      {"offset":[0.5,-1],"rotation":0.25,"scale":[2,3],"texCoord":4}}},
      "normalTexture":{"index":1,"texCoord":9}})",
          R"(,"textures":[{"source":0,"sampler":0},{"source":0}],"samplers":[{"minFilter":9984}],)"
          R"("images":[{"uri":")" +
              std::string(png) + R"("}])")
          .load();
  const scene::TextureUse& use = scene.materials.at(0).texture(scene::Slot::emissive);
  CHECK(use.transform == scene::TextureTransform{{0.5f, -1}, {2, 3}, 0.25f});
  CHECK(scene.texcoords.at(use.texcoord) == 4);
  CHECK(scene.texcoords.at(scene.materials.at(0).texture(scene::Slot::normal).texcoord) == 9);
  const scene::Texture& texture = scene.textures.at(*use.texture);
  CHECK(texture.mips == scene::Mips::nearest);
  CHECK(texture.nearest_in_level);
  CHECK(scene.textures.at(1).mips == scene::Mips::linear);
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
  CHECK(notes_of(R"({"normalTexture":{"index":0},"occlusionTexture":{"index":0}})", image).empty());
  CHECK(notes_of(R"({"alphaMode":"MASK"})").empty());
  CHECK(notes_of("{}", R"(,"extensionsUsed":["EXT_none","EXT_none","KHR_materials_ior","A\nB"])") ==
        Notes{"extension A B", "extension EXT_none"});
}
