#include "scene/gltf/textures.h"

#include <algorithm>

#include "scene/gltf/checked.h"

namespace crsh::scene {

namespace {

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

/// The images that stand for a texture, the best first: `source` is what is left to those who cannot read the
/// extension's.
std::vector<int> sources_of(const tinygltf::Texture& texture, const std::string& where) {
  std::vector<int> out;
  for (const char* name : {"KHR_texture_basisu", "EXT_texture_webp", "EXT_texture_avif"})
    if (const auto extension = Extension::of(texture.extensions, name, where))
      if (const int source = extension->index("source"); source >= 0) out.push_back(source);
  if (texture.source >= 0) out.push_back(texture.source);
  return out;
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

/// Where among Mesh::uv the set TEXCOORD_`set` is (texcoords_used).
uint32_t TextureReader::slot_of(uint32_t set) {
  const auto found = std::find(scene_.texcoords.begin(), scene_.texcoords.end(), set);
  if (found != scene_.texcoords.end()) return uint32_t(found - scene_.texcoords.begin());
  notes_.add("texture coordinates past the third set that is used (the first is used instead)");
  return 0;
}

std::optional<uint32_t> TextureReader::texture(int index) {
  if (!reading_) return want(index);
  const auto [found, fresh] = textures_.try_emplace(index);
  if (fresh) found->second = read_texture(index);
  return found->second;
}

/// None yet. Only the images that will be drawn are decoded: a fallback is if its better turns out to be broken.
std::nullopt_t TextureReader::want(int index) {
  const tinygltf::Texture& from = at(document_.model().textures, index, "textures");
  const std::vector<int> sources = sources_of(from, place("textures", index));
  for (const int source : sources)
    if (images_.want(source)) break;
  return std::nullopt;
}

std::optional<uint32_t> TextureReader::read_texture(int index) {
  const tinygltf::Texture& from = at(document_.model().textures, index, "textures");
  const std::vector<int> sources = sources_of(from, place("textures", index));
  if (sources.empty()) {
    notes_.add("textures without an image (drawn without them)");
    return {};
  }
  const std::optional<uint32_t> own_image = image(sources);
  if (!own_image) return {};
  Texture out{*own_image};
  if (from.sampler >= 0)
    set_sampler(out, at(document_.model().samplers, from.sampler, "samplers"), place("samplers", from.sampler));
  scene_.textures.push_back(out);
  return static_cast<uint32_t>(scene_.textures.size() - 1);
}

/// The first that can be drawn. Pictures that are missing or broken do not keep the scene from being drawn.
std::optional<uint32_t> TextureReader::image(const std::vector<int>& sources) {
  for (size_t i = 0; i < sources.size(); ++i) {
    const std::optional<uint32_t> found = images_.read(sources[i], scene_.images);
    if (!found) continue;
    note_sources(sources, i);
    return found;
  }
  note_sources(sources, sources.size());
  return {};
}

/// What is wrong with the sources up to the one that is drawn. That a format is not read is no fault of a file that
/// brings another.
void TextureReader::note_sources(const std::vector<int>& sources, size_t drawn) {
  for (size_t i = 0; i < sources.size() && i <= drawn; ++i) {
    const ImageReader::Verdict& verdict = images_.verdict(sources[i]);
    if (verdict.reason.empty() || (verdict.unread_format && drawn < sources.size())) continue;
    const std::string instead = i == drawn               ? "drawn as far as it goes"
                                : drawn < sources.size() ? place("images", sources[drawn]) + " is drawn"
                                                         : "drawn without it";
    notes_.add("texture " + place("images", sources[i]) + " (" + verdict.reason + ": " + instead + ")");
  }
}

}  // namespace crsh::scene
