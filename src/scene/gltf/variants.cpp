#include "scene/gltf/variants.h"

#include <algorithm>

#include "scene/gltf/extension.h"

namespace crsh::scene {

namespace {

constexpr const char* extension_name = "KHR_materials_variants";
constexpr size_t max_listed = 16;

std::string listed(const std::vector<std::string>& names) {
  std::string out;
  for (size_t i = 0; i < std::min(names.size(), max_listed); ++i)
    out += (i == 0 ? "" : ", ") + std::to_string(i) + " " + in_quotes(names[i], 40);
  return out;
}

bool names_variant(const Extension& mapping, uint32_t variant) {
  for (size_t i = 0; i < mapping.count("variants"); ++i)
    if (mapping.index("variants", i) == static_cast<int>(variant)) return true;
  return false;
}

}  // namespace

std::vector<std::string> variant_names(const Document& document) {
  std::vector<std::string> out;
  const std::optional<Extension> extension = Extension::of(document.model().extensions, extension_name, "");
  const size_t count = extension ? extension->count("variants") : 0;
  for (size_t i = 0; i < count; ++i) out.push_back(extension->element("variants", static_cast<int>(i)).text("name"));
  return out;
}

std::optional<uint32_t> chosen_variant(const std::vector<std::string>& names, const std::string& which) {
  if (which.empty()) return {};
  for (uint32_t i = 0; i < names.size(); ++i)
    if (names[i] == which) return i;
  for (uint32_t i = 0; i < names.size(); ++i)
    if (std::to_string(i) == which) return i;
  throw Fault("has no variant " + in_quotes(which, 40),
              names.empty() ? "name none, for it has none" : "choose one of " + listed(names));
}

int material_in(std::optional<uint32_t> variant, const tinygltf::Primitive& primitive, const std::string& where) {
  const auto extension = Extension::of(primitive.extensions, extension_name, where);
  if (!variant || !extension) return primitive.material;
  for (size_t i = 0; i < extension->count("mappings"); ++i) {
    const Extension mapping = extension->element("mappings", static_cast<int>(i));
    if (names_variant(mapping, *variant)) return mapping.index("material");
  }
  return primitive.material;
}

}  // namespace crsh::scene
