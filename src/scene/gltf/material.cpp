#include "scene/gltf/material.h"

#include <algorithm>
#include <map>

#include "scene/gltf/image.h"

namespace crsh::scene {

namespace {

// Images of one file may take this many texels together; more are drawn without (2 GiB).
constexpr uint64_t most_texels = uint64_t{1} << 29u;

constexpr float brightest = 1e15f;  // cd/m2; keeps products finite

float unit(float value) { return std::clamp(value, 0.0f, 1.0f); }

glm::vec3 vec3_of(const Fields& fields, const char* key, const glm::vec3& otherwise) {
  const auto values = fields.numbers<3>(key);
  return values ? glm::vec3((*values)[0], (*values)[1], (*values)[2]) : otherwise;
}

Wrap wrap_of(const Fields& sampler, const char* key) {
  switch (sampler.whole(key, 10497)) {
    case 10497: return Wrap::repeat;
    case 33071: return Wrap::clamp;
    case 33648: return Wrap::mirror;
    default: throw Fault(sampler.name_of(key) + " is none of glTF's");
  }
}

/// Reads images and textures when a material first asks for them.
class TextureReader {
 public:
  TextureReader(Document& document, Scene& scene, Notes& notes) : document_(document), scene_(scene), notes_(notes) {}

  /// The texture that `fields[key]` describes, if it is there and can be drawn.
  TextureUse use(const Fields& fields, const char* key) {
    const std::optional<Fields> info = fields.object(key);
    if (!info) return {};
    if (info->extension("KHR_texture_transform")) notes_.add("extension KHR_texture_transform");
    TextureUse out{texture(info->needed_whole("index")),
                   static_cast<uint32_t>(std::min<uint64_t>(info->whole("texCoord", 0), 2))};
    if (out.texcoord > 1) {
      notes_.add("texture coordinates past TEXCOORD_1 (TEXCOORD_0 is used)");
      out.texcoord = 0;
    }
    return out;
  }

 private:
  std::optional<uint32_t> texture(uint64_t index) {
    const auto [found, fresh] = textures_.try_emplace(index);
    if (fresh) found->second = read_texture(document_.root().element("textures", index));
    return found->second;
  }

  std::optional<uint32_t> read_texture(const Fields& fields) {
    const std::optional<uint64_t> source = fields.whole("source");
    if (!source) {
      notes_.add("textures without a PNG or JPEG image (drawn without them)");
      return {};
    }
    const std::optional<uint32_t> own_image = image(*source);
    if (!own_image) return {};
    Texture out{*own_image};
    if (const std::optional<uint64_t> sampler = fields.whole("sampler"))
      set_sampler(out, document_.root().element("samplers", *sampler));
    scene_.textures.push_back(out);
    return static_cast<uint32_t>(scene_.textures.size() - 1);
  }

  static void set_sampler(Texture& texture, const Fields& sampler) {
    constexpr uint64_t nearest = 9728, linear = 9729;
    const uint64_t filter = sampler.whole("magFilter", linear);
    if (filter != nearest && filter != linear) throw Fault(sampler.name_of("magFilter") + " is none of glTF's");
    texture.nearest = filter == nearest;
    texture.wrap_s = wrap_of(sampler, "wrapS");
    texture.wrap_t = wrap_of(sampler, "wrapT");
  }

  std::optional<uint32_t> image(uint64_t index) {
    const auto [found, fresh] = images_.try_emplace(index);
    if (fresh) found->second = read_image(document_.root().element("images", index));
    return found->second;
  }

  /// A picture that is missing or broken does not keep the scene from being drawn.
  std::optional<uint32_t> read_image(const Fields& fields) {
    try {
      if (texels_ > most_texels) throw Fault("the others take 2 GiB already");
      Image picture = decoded(fields);
      texels_ += picture.rgba.size() / 4;
      scene_.images.push_back(std::move(picture));
      return static_cast<uint32_t>(scene_.images.size() - 1);
    } catch (const Fault& fault) {
      notes_.add("texture " + fields.where() + " (" + fault.what() + ": drawn without it)");
      return {};
    }
  }

  Image decoded(const Fields& fields) {
    if (const std::optional<uint64_t> view = fields.whole("bufferView")) return decode_image(document_.view(*view));
    const std::string& uri = fields.text("uri");
    if (uri.empty()) throw Fault("has no data");
    const Bytes bytes = read_uri(uri, document_.folder());
    try {
      return decode_image(bytes);
    } catch (const Fault& fault) {
      throw Fault(uri_name(uri) + " " + fault.what());
    }
  }

  Document& document_;
  Scene& scene_;
  Notes& notes_;
  std::map<uint64_t, std::optional<uint32_t>> textures_, images_;
  uint64_t texels_ = 0;
};

class MaterialReader {
 public:
  MaterialReader(TextureReader& textures, Notes& notes) : textures_(textures), notes_(notes) {}

  Material read(const Fields& fields) {
    Material out;
    out.name = fields.text("name");
    out.double_sided = fields.flag("doubleSided", false);
    out.emissive = glm::max(vec3_of(fields, "emissiveFactor", glm::vec3(0)), 0.0f);
    out.emissive_texture = textures_.use(fields, "emissiveTexture");
    if (const auto pbr = fields.object("pbrMetallicRoughness")) read_metallic_roughness(out, *pbr);
    read_extensions(out, fields);
    note_what_is_left_out(fields);
    return out;
  }

 private:
  void read_metallic_roughness(Material& out, const Fields& pbr) {
    if (const auto c = pbr.numbers<4>("baseColorFactor")) out.base_colour = {(*c)[0], (*c)[1], (*c)[2], (*c)[3]};
    out.base_colour = glm::clamp(out.base_colour, 0.0f, 1.0f);
    out.metallic = unit(pbr.number("metallicFactor", 1));
    out.roughness = unit(pbr.number("roughnessFactor", 1));
    out.base_colour_texture = textures_.use(pbr, "baseColorTexture");
    out.metallic_roughness_texture = textures_.use(pbr, "metallicRoughnessTexture");
  }

  void read_extensions(Material& out, const Fields& fields) {
    if (const auto strength = fields.extension("KHR_materials_emissive_strength"))
      out.emissive = glm::min(out.emissive * std::max(strength->number("emissiveStrength", 1), 0.0f), brightest);
    if (const auto ior = fields.extension("KHR_materials_ior")) out.ior = refraction_of(*ior);
    if (const auto transmission = fields.extension("KHR_materials_transmission")) {
      out.transmission = unit(transmission->number("transmissionFactor", 0));
      out.transmission_texture = textures_.use(*transmission, "transmissionTexture");
    }
    if (const auto volume = fields.extension("KHR_materials_volume")) {
      out.thickness = std::max(volume->number("thicknessFactor", 0), 0.0f);
      if (volume->has("thicknessTexture")) notes_.add("thickness textures");
      if (volume->has("attenuationDistance") || volume->has("attenuationColor")) notes_.add("attenuation in volumes");
    }
  }

  /// 0 stands for an infinite index: all light is reflected (KHR_materials_ior, "Interaction with other extensions").
  static float refraction_of(const Fields& extension) {
    constexpr float infinite = 1e6f;
    const float ior = extension.number("ior", 1.5f);
    return ior == 0 ? infinite : std::max(ior, 1.0f);
  }

  void note_what_is_left_out(const Fields& fields) {
    if (fields.has("normalTexture")) notes_.add("normal maps");
    if (fields.has("occlusionTexture")) notes_.add("occlusion maps");
    const std::string& alpha = fields.text("alphaMode");
    if (alpha == "MASK" || alpha == "BLEND") notes_.add("alphaMode " + alpha + " (drawn opaque)");
  }

  TextureReader& textures_;
  Notes& notes_;
};

}  // namespace

void read_materials(Document& document, const std::set<uint32_t>& used, Scene& scene, Notes& notes) {
  const Fields root = document.root();
  scene.materials.resize(root.size("materials") + 1);
  TextureReader textures(document, scene, notes);
  MaterialReader reader(textures, notes);
  for (const uint32_t index : used)
    if (index < root.size("materials")) scene.materials[index] = reader.read(root.element("materials", index));
}

}  // namespace crsh::scene
