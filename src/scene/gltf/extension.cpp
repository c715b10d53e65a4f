#include "scene/gltf/extension.h"

namespace crsh::scene {

std::optional<Extension> Extension::of(const tinygltf::ExtensionMap& all, const std::string& name,
                                       const std::string& where) {
  const auto found = all.find(name);
  if (found == all.end()) return {};
  return Extension(found->second, (where.empty() ? "" : where + ".") + "extensions." + name);
}

std::optional<float> Extension::number(const std::string& key) const {
  return has(key) ? std::optional(finite(value().Get(key).GetNumberAsDouble(), name_of(key))) : std::nullopt;
}

int Extension::index(const std::string& key) const { return has(key) ? value().Get(key).GetNumberAsInt() : -1; }

int Extension::index(const std::string& key, size_t i) const {
  return value().Get(key).Get(static_cast<int>(i)).GetNumberAsInt();
}

bool Extension::flag(const std::string& key, bool otherwise) const {
  return has(key) ? value().Get(key).Get<bool>() : otherwise;
}

size_t Extension::count(const std::string& key) const {
  return has(key) && value().Get(key).IsArray() ? value().Get(key).ArrayLen() : 0;
}

std::string Extension::text(const std::string& key) const {
  return has(key) ? value().Get(key).Get<std::string>() : std::string();
}

std::optional<Extension> Extension::object(const std::string& key) const {
  return has(key) ? std::optional(Extension(value().Get(key), name_of(key))) : std::nullopt;
}

Extension Extension::element(const std::string& key, int index) const {
  const tinygltf::Value& list = value().Get(key);
  const std::string where = place(name_of(key), index);
  if (!list.IsArray() || index < 0 || static_cast<size_t>(index) >= list.ArrayLen())
    throw Fault(where + " is referred to but is not in the file");
  return {list.Get(index), where};
}

}  // namespace crsh::scene
