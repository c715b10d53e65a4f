#include "scene/gltf/textures.h"

#include <algorithm>
#include <utility>

#include "scene/gltf/checked.h"
#include "scene/gltf/image.h"

namespace crsh::scene {

namespace {

// Images of one file may take this many texels together; more are drawn without (2 GiB).
constexpr uint64_t max_texels = uint64_t{1} << 29u;

Wrap wrap_of(int code, const std::string& name) {
  switch (code) {
    case TINYGLTF_TEXTURE_WRAP_REPEAT: return Wrap::repeat;
    case TINYGLTF_TEXTURE_WRAP_CLAMP_TO_EDGE: return Wrap::clamp;
    case TINYGLTF_TEXTURE_WRAP_MIRRORED_REPEAT: return Wrap::mirror;
    default: throw Fault(name + " is none of glTF's");
  }
}

void set_sampler(Texture& texture, const tinygltf::Sampler& sampler, const std::string& where) {
  constexpr int none = -1;
  const int filter = sampler.magFilter;
  if (filter != TINYGLTF_TEXTURE_FILTER_NEAREST && filter != TINYGLTF_TEXTURE_FILTER_LINEAR && filter != none)
    throw Fault(where + ".magFilter is none of glTF's");
  texture.nearest = filter == TINYGLTF_TEXTURE_FILTER_NEAREST;
  texture.wrap_s = wrap_of(sampler.wrapS, where + ".wrapS");
  texture.wrap_t = wrap_of(sampler.wrapT, where + ".wrapT");
}

}  // namespace

TextureUse TextureReader::use(const tinygltf::TextureInfo& info) {
  if (info.index < 0) return {};
  return use(info.index, info.texCoord, info.extensions.contains("KHR_texture_transform"));
}

TextureUse TextureReader::use(const Extension& extension, const std::string& key) {
  const std::optional<Extension> info = extension.object(key);
  if (!info) return {};
  const std::optional<Extension> more = info->object("extensions");
  return use(info->index("index"), std::max(info->index("texCoord"), 0), more && more->has("KHR_texture_transform"));
}

TextureUse TextureReader::use(int index, int texcoord, bool transformed) {
  if (transformed) notes_.add("extension KHR_texture_transform");
  TextureUse out{texture(index), static_cast<uint32_t>(texcoord)};
  if (out.texcoord > 1) {
    notes_.add("texture coordinates past TEXCOORD_1 (TEXCOORD_0 is used)");
    out.texcoord = 0;
  }
  return out;
}

std::optional<uint32_t> TextureReader::texture(int index) {
  const auto [found, fresh] = textures_.try_emplace(index);
  if (fresh) found->second = read_texture(index);
  return found->second;
}

std::optional<uint32_t> TextureReader::read_texture(int index) {
  const tinygltf::Texture& from = at(document_.model().textures, index, "textures");
  if (from.source < 0) {
    notes_.add("textures without a PNG or JPEG image (drawn without them)");
    return {};
  }
  const std::optional<uint32_t> own_image = image(from.source);
  if (!own_image) return {};
  Texture out{*own_image};
  if (from.sampler >= 0)
    set_sampler(out, at(document_.model().samplers, from.sampler, "samplers"), place("samplers", from.sampler));
  scene_.textures.push_back(out);
  return static_cast<uint32_t>(scene_.textures.size() - 1);
}

std::optional<uint32_t> TextureReader::image(int index) {
  const auto [found, fresh] = images_.try_emplace(index);
  if (fresh) found->second = read_image(index);
  return found->second;
}

/// A picture that is missing or broken does not keep the scene from being drawn.
std::optional<uint32_t> TextureReader::read_image(int index) {
  const ImageSource& source = document_.image(index);
  try {
    if (texels_ > max_texels) throw Fault("the others take 2 GiB already");
    Image picture = decoded(source);
    texels_ += picture.rgba.size() / 4;
    scene_.images.push_back(std::move(picture));
    return static_cast<uint32_t>(scene_.images.size() - 1);
  } catch (const Fault& fault) {
    notes_.add("texture " + place("images", index) + " (" + fault.what() + ": drawn without it)");
    return {};
  }
}

Image TextureReader::decoded(const ImageSource& source) {
  if (source.view) return decode_image(document_.view(static_cast<int64_t>(*source.view)));
  if (source.uri.empty()) throw Fault("has no data");
  const Bytes bytes = document_.read(source.uri);
  try {
    return decode_image(bytes);
  } catch (const Fault& fault) {
    throw Fault(uri_name(source.uri) + " " + fault.what());
  }
}

}  // namespace crsh::scene
