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

/// Where the file leaves it open, textures have mip levels, as in other viewers.
void set_minification(Texture& texture, int code, const std::string& name) {
  switch (code) {
    case -1: return;
    case TINYGLTF_TEXTURE_FILTER_NEAREST:
    case TINYGLTF_TEXTURE_FILTER_LINEAR: texture.mips = Mips::none; break;
    case TINYGLTF_TEXTURE_FILTER_NEAREST_MIPMAP_NEAREST:
    case TINYGLTF_TEXTURE_FILTER_LINEAR_MIPMAP_NEAREST: texture.mips = Mips::nearest; break;
    case TINYGLTF_TEXTURE_FILTER_NEAREST_MIPMAP_LINEAR:
    case TINYGLTF_TEXTURE_FILTER_LINEAR_MIPMAP_LINEAR: texture.mips = Mips::linear; break;
    default: throw Fault(name + " is none of glTF's");
  }
  texture.nearest_in_level = code == TINYGLTF_TEXTURE_FILTER_NEAREST ||
                             code == TINYGLTF_TEXTURE_FILTER_NEAREST_MIPMAP_NEAREST ||
                             code == TINYGLTF_TEXTURE_FILTER_NEAREST_MIPMAP_LINEAR;
}

TextureTransform transform_of(const Extension& from) {
  TextureTransform out;
  if (const auto offset = from.numbers<2>("offset")) out.offset = {(*offset)[0], (*offset)[1]};
  if (const auto scale = from.numbers<2>("scale")) out.scale = {(*scale)[0], (*scale)[1]};
  out.rotation = from.number("rotation", 0);
  return out;
}

void set_sampler(Texture& texture, const tinygltf::Sampler& sampler, const std::string& where) {
  constexpr int none = -1;
  const int filter = sampler.magFilter;
  if (filter != TINYGLTF_TEXTURE_FILTER_NEAREST && filter != TINYGLTF_TEXTURE_FILTER_LINEAR && filter != none)
    throw Fault(where + ".magFilter is none of glTF's");
  texture.nearest = filter == TINYGLTF_TEXTURE_FILTER_NEAREST;
  set_minification(texture, sampler.minFilter, where + ".minFilter");
  texture.wrap_s = wrap_of(sampler.wrapS, where + ".wrapS");
  texture.wrap_t = wrap_of(sampler.wrapT, where + ".wrapT");
}

}  // namespace

TextureUse TextureReader::use(const Extension& extension, const std::string& key) {
  const std::optional<Extension> info = extension.object(key);
  if (!info) return {};
  const std::optional<Extension> more = info->object("extensions");
  return use(info->index("index"), info->index("texCoord"),
             more ? more->object("KHR_texture_transform") : std::nullopt);
}

TextureUse TextureReader::use(int index, int texcoord, const std::optional<Extension>& transform) {
  TextureUse out{texture(index)};
  if (transform) {
    out.transform = transform_of(*transform);
    if (transform->has("texCoord")) texcoord = transform->index("texCoord");
  }
  out.texcoord = slot_of(uint32_t(std::max(texcoord, 0)));
  return out;
}

/// Sets of coordinates are numbered in the order in which materials ask for them, but for the first two.
uint32_t TextureReader::slot_of(uint32_t set) {
  const auto found = std::find(scene_.texcoords.begin(), scene_.texcoords.end(), set);
  if (found != scene_.texcoords.end()) return uint32_t(found - scene_.texcoords.begin());
  notes_.add("texture coordinates past the third set that is used (the first is used instead)");
  return 0;
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
  if (source.view) return decode_image(document_.view(static_cast<int64_t>(*source.view))).image;
  if (source.uri.empty()) throw Fault("has no data");
  const Bytes bytes = document_.read(source.uri);
  try {
    return decode_image(bytes).image;
  } catch (const Fault& fault) {
    throw Fault(uri_name(source.uri) + " " + fault.what());
  }
}

}  // namespace crsh::scene
