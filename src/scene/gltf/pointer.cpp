#include "scene/gltf/pointer.h"

#include <charconv>

#include "scene/gltf/checked.h"
#include "scene/properties.h"

namespace crsh::scene {
namespace {

/// A pointer taken apart: a list of the file, an index into it, and the property's own path.
struct Pointer {
  std::string_view list;
  int64_t index = 0;
  std::string_view property;
};

constexpr std::string_view lights = "extensions/KHR_lights_punctual/lights";

/// "/nodes/3/translation": nodes, 3, translation.
std::optional<Pointer> taken_apart(std::string_view text) {
  for (const std::string_view list :
       {std::string_view("nodes"), std::string_view("cameras"), std::string_view("materials"), lights}) {
    if (!text.starts_with("/") || !text.substr(1).starts_with(list)) continue;
    std::string_view rest = text.substr(1 + list.size());
    if (!rest.starts_with("/")) continue;
    Pointer out{list, 0, {}};
    const auto [end, error] = std::from_chars(rest.data() + 1, rest.data() + rest.size(), out.index);
    if (error != std::errc() || end == rest.data() + rest.size() || *end != '/' || out.index < 0) return {};
    out.property = rest.substr(static_cast<size_t>(end - rest.data()) + 1);
    return out;
  }
  return {};
}

/// The scene's elements that the file's element `index` has become.
std::vector<uint32_t> elements(const FilePlaces& places, int64_t index) {
  std::vector<uint32_t> out;
  for (auto [at, end] = places.equal_range(index); at != end; ++at) out.push_back(at->second);
  return out;
}

/// The scene's node; none where it is out of sight, or where its matrix fixes what is driven.
std::vector<uint32_t> node_elements(const Places& places, const Scene& scene, int64_t index, uint32_t property) {
  const std::optional<uint32_t> node = at(places.nodes.node_of, index, "nodes");
  const bool moves = property == node_translation || property == node_rotation || property == node_scale;
  if (!node || (moves && scene.nodes[*node].matrix)) return {};
  return {*node};
}

template <class Table>
std::optional<uint32_t> row_of(const Table& table, std::string_view property) {
  for (uint32_t row = 0; row < table.size(); ++row)
    if (table[row].pointer == property) return row;
  return {};
}

Aim aim(Driven driven, uint32_t property, uint32_t width, const std::vector<uint32_t>& objects) {
  Aim out{{}, width};
  for (const uint32_t object : objects) out.targets.push_back({driven, object, property});
  return out;
}

template <class Table>
std::optional<Aim> aim_in(const Table& table, Driven driven, std::string_view property,
                          const std::vector<uint32_t>& objects) {
  const std::optional<uint32_t> row = row_of(table, property);
  return row ? std::optional(aim(driven, *row, table[*row].width, objects)) : std::nullopt;
}

std::optional<Aim> aim_at_node(const Places& places, const Scene& scene, int64_t node, std::string_view property) {
  const std::optional<uint32_t> row = row_of(node_properties, property);
  if (!row) return {};
  return aim(Driven::node, *row, node_properties[*row].width, node_elements(places, scene, node, *row));
}

}  // namespace

std::optional<Aim> aim_of_path(const Places& places, const Scene& scene, int64_t node, const std::string& path) {
  if (path != "translation" && path != "rotation" && path != "scale" && path != "weights") return {};
  if (node < 0) return Aim{};
  return aim_at_node(places, scene, node, path);
}

std::optional<Aim> aim_of_pointer(const Places& places, const Scene& scene, const std::string& pointer) {
  const std::optional<Pointer> parts = taken_apart(pointer);
  if (!parts) return {};
  const auto& [list, index, property] = *parts;
  if (list == "nodes") return aim_at_node(places, scene, index, property);
  if (list == "cameras") return aim_in(camera_properties, Driven::camera, property, elements(places.cameras, index));
  if (list == lights) return aim_in(light_properties, Driven::light, property, elements(places.lights, index));
  (void)at(scene.materials, index, "materials");
  return aim_in(material_properties, Driven::material, property, {static_cast<uint32_t>(index)});
}

}  // namespace crsh::scene
