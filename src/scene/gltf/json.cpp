#include "scene/gltf/json.h"

#include <algorithm>
#include <cstdio>
#include <optional>
#include <string>
#include <utility>

#include "scene/gltf/fault.h"

namespace crsh::scene {

namespace {

using nlohmann::json;
constexpr size_t deepest = 64;
constexpr size_t max_values = size_t{1} << 24u;

/// From behind a string's first quote to behind its last.
std::span<const uint8_t> behind_string(std::span<const uint8_t> rest) {
  size_t i = 0;
  for (; i < rest.size() && rest[i] != '"'; ++i)
    if (rest[i] == '\\') ++i;
  return rest.subspan(std::min(i + 1, rest.size()));
}

/// Every value but the first follows a bracket or a comma.
void check_size(std::span<const uint8_t> text) {
  size_t depth = 0, values = 1;
  for (std::span<const uint8_t> rest = text; !rest.empty();) {
    const uint8_t c = rest[0];
    rest = c == '"' ? behind_string(rest.subspan(1)) : rest.subspan(1);
    const bool opens = c == '{' || c == '[', closes = c == '}' || c == ']';
    values += opens || c == ',';
    depth += opens;
    depth -= closes && depth > 0;
    if (depth > deepest)
      throw Fault("its JSON nests deeper than 64 levels at byte " + std::to_string(text.size() - rest.size()));
    if (values > max_values) throw Fault("its JSON has more than 16 million values", "split or simplify the scene");
  }
}

const json* find(const json& object, const char* key) {
  const auto found = object.find(key);
  return found == object.end() ? nullptr : &*found;
}

std::string text_of(const json& asset, const char* key) {
  const json* value = find(asset, key);
  if (value == nullptr) return {};
  if (!value->is_string()) throw Fault(std::string("asset.") + key + " is not a string");
  return value->get<std::string>();
}

/// "2.0" → 2, 0; anything else is refused.
std::pair<unsigned, unsigned> version_of(const std::string& text) {
  unsigned major = 0, minor = 0;
  char rest = 0;
  if (text.size() > 6 || std::sscanf(text.c_str(), "%u.%u%c", &major, &minor, &rest) != 2)
    throw Fault("its glTF version is " + in_quotes(text, 20), "convert it to glTF 2.0");
  return {major, minor};
}

}  // namespace

json parse_json(std::span<const uint8_t> text) {
  while (!text.empty() && text.back() == 0) text = text.first(text.size() - 1);  // some exporters pad with zeros
  check_size(text);
  json root;
  try {
    root = json::parse(text.begin(), text.end());
  } catch (const json::parse_error& error) {
    throw Fault("is no glTF: its JSON is broken at byte " + std::to_string(error.byte), "give a .gltf or .glb file");
  } catch (const json::exception&) {
    throw Fault("is no glTF: its JSON is broken", "give a .gltf or .glb file");
  }
  if (!root.is_object()) throw Fault("the JSON is not an object");
  return root;
}

void check_version(const json& root) {
  const json* asset = find(root, "asset");
  if (asset == nullptr) throw Fault("is no glTF: 'asset' is missing", "give a .gltf or .glb file");
  if (!asset->is_object()) throw Fault("asset is not an object");
  const std::string own = text_of(*asset, "version"), least = text_of(*asset, "minVersion");
  const auto version = version_of(own);
  if (version.first != 2 || (!least.empty() && version_of(least) > std::pair(2u, 0u)))
    throw Fault("needs glTF " + printable(least.empty() ? own : least, 20), "convert it to glTF 2.0");
}

}  // namespace crsh::scene
