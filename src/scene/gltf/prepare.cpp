#include "scene/gltf/prepare.h"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <set>
#include <string_view>
#include <utility>

#include "scene/gltf/checked.h"
#include "scene/gltf/fault.h"
#include "scene/gltf/shape_check.h"

namespace crsh::scene {

namespace {

using nlohmann::json;

/// Takes a list of the root out of it; empty where it has none.
json take_out(json& root, const char* name) {
  const auto found = root.find(name);
  if (found == root.end()) return json::array();
  json out = std::move(*found);
  root.erase(found);
  return out;
}

json& list_of(json& root, const char* name) {
  json& list = root[name];
  if (list.is_null()) list = json::array();
  return list;
}

std::optional<uint64_t> whole(const json& object, const char* key) {
  const auto found = object.find(key);
  return found == object.end() ? std::nullopt : std::optional(found->get<uint64_t>());
}

/// Moved out of the object: some are whole buffers.
std::string uri_of(json& object) {
  const auto found = object.find("uri");
  return found == object.end() ? std::string() : std::move(found->get_ref<std::string&>());
}

void take_sources(json& root, Prepared& out) {
  json buffers = take_out(root, "buffers"), images = take_out(root, "images");
  for (json& buffer : buffers) out.buffers.push_back({whole(buffer, "byteLength"), uri_of(buffer)});
  for (json& image : images) out.images.push_back({whole(image, "bufferView"), uri_of(image)});
}

CompressedView compressed_view(const json& extension) {
  return {.buffer = extension["buffer"].get<int64_t>(),
          .offset = whole(extension, "byteOffset").value_or(0),
          .length = extension["byteLength"].get<uint64_t>(),
          .stride = extension["byteStride"].get<uint64_t>(),
          .count = extension["count"].get<uint64_t>(),
          .mode = extension["mode"].get<std::string>(),
          .filter = extension.value("filter", std::string())};
}

/// What of the bufferViews tinygltf does not see.
void take_views(json& root, Prepared& out) {
  for (json& view : list_of(root, "bufferViews")) {
    const auto index = static_cast<int64_t>(out.strides.size());
    out.strides.push_back(whole(view, "byteStride").value_or(0));
    view.erase("byteStride");
    if (const auto extensions = view.find("extensions"); extensions != view.end())
      for (const auto& extension : *extensions) out.compressed.emplace(index, compressed_view(extension));
    view.erase("extensions");
  }
}

/// tinygltf refuses the file for one of an unknown type, whether it is used or not.
void check_accessors(json& root, BrokenParts& broken) {
  constexpr std::array<std::string_view, 7> types = {"SCALAR", "VEC2", "VEC3", "VEC4", "MAT2", "MAT3", "MAT4"};
  constexpr uint64_t first_code = 5120, last_code = 5130;
  int64_t i = 0;
  for (json& accessor : list_of(root, "accessors")) {
    const std::string where = place("accessors", i++);
    const auto& type = accessor["type"].get_ref<const std::string&>();
    const auto code = accessor["componentType"].get<uint64_t>();
    if (std::find(types.begin(), types.end(), type) == types.end())
      broken.emplace(where, where + ".type " + in_quotes(type, 20) + " is not known here");
    else if (code < first_code || code > last_code)
      broken.emplace(where, where + ".componentType " + std::to_string(code) + " is none of glTF's");
    else continue;
    accessor = json::parse(accessor_stand_in);
  }
}

void check_cameras(json& root, BrokenParts& broken) {
  int64_t i = 0;
  for (json& camera : list_of(root, "cameras")) {
    const std::string where = place("cameras", i++);
    const auto& type = camera["type"].get_ref<const std::string&>();
    if ((type == "perspective" || type == "orthographic") && camera.contains(type)) continue;
    broken.emplace(where, where + ".type is neither perspective nor orthographic");
    camera = json::parse(camera_stand_in);
  }
}

/// The accessors that primitives use as indices. Primitives whose indices are not in the file are broken.
std::set<uint64_t> index_accessors(json& root, BrokenParts& broken) {
  std::set<uint64_t> out;
  const uint64_t accessors = list_of(root, "accessors").size();
  int64_t m = 0;
  for (json& mesh : list_of(root, "meshes")) {
    const std::string where = place("meshes", m++) + ".primitives";
    int64_t p = 0;
    for (json& primitive : list_of(mesh, "primitives")) {
      const std::string at = place(where, p++);
      const auto indices = whole(primitive, "indices");
      if (indices && *indices < accessors) out.insert(*indices);
      if (!indices || *indices < accessors) continue;
      broken.emplace(at, place("accessors", static_cast<int64_t>(*indices)) + " is referred to but is not in the file");
      primitive.erase("indices");
    }
  }
  return out;
}

/// tinygltf wants all indices to have an accessor, and 2.7 wants each of these to have a bufferView.
void settle_indices(json& root, Prepared& out) {
  json &accessors = list_of(root, "accessors"), &views = list_of(root, "bufferViews");
  const uint64_t own_views = views.size();
  for (const uint64_t index : index_accessors(root, out.broken)) {
    json& accessor = accessors[index];
    const auto view = whole(accessor, "bufferView");
    if (view && *view < own_views) continue;
    accessor["bufferView"] = own_views;
    out.bare.push_back(index);
    if (view)
      out.broken.emplace(place("accessors", static_cast<int64_t>(index)),
                         place("bufferViews", static_cast<int64_t>(*view)) + " is referred to but is not in the file");
  }
  if (!out.bare.empty()) views.push_back({{"buffer", 0}, {"byteLength", 0}});
}

}  // namespace

Prepared prepare(json root) {
  Prepared out;
  bring_into_shape(root, root_shape, out.broken);
  take_sources(root, out);
  take_views(root, out);
  check_accessors(root, out.broken);
  check_cameras(root, out.broken);
  settle_indices(root, out);
  out.text = root.dump();
  return out;
}

}  // namespace crsh::scene
