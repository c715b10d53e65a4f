#include "cli/info_text.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "cli/values.h"
#include "gpu/needs.h"
#include "output/stats_json.h"
#include "scene/approximated.h"
#include "scene/playing.h"

namespace crsh::cli {
namespace {

using Json = nlohmann::ordered_json;

/// Bounds at time 0 of the animations that play.
scene::Bounds bounds_of(const scene::Scene& scene) {
  return scene.bounds(scene.pose(0, scene::playing(scene, "").animations));
}

Json bounds_json(const scene::Scene& scene) {
  const scene::Bounds bounds = bounds_of(scene);
  if (bounds.empty()) return nullptr;
  const auto corner = [&](const glm::vec3& v) {
    const glm::dvec3 place = scene.in_file(v);
    return Json{place.x, place.y, place.z};
  };
  return {{"low", corner(bounds.low)}, {"high", corner(bounds.high)}};
}

std::string_view type_of(const scene::Light& light) {
  switch (light.type) {
    case scene::LightType::point: return "point";
    case scene::LightType::spot: return "spot";
    case scene::LightType::directional: break;
  }
  return "directional";
}

std::string_view type_of(const scene::Camera& camera) { return camera.orthographic ? "orthographic" : "perspective"; }

template <class Items, class Describe>
Json list_of(const Items& items, Describe describe) {
  Json list = Json::array();
  for (const auto& item : items) list.push_back(describe(item));
  return list;
}

/// "2: front (perspective), 1 (perspective)": the count, then each by name or index.
template <class Items, class Detail>
std::string counted(const Items& items, Detail detail) {
  std::vector<std::string> parts;
  for (size_t index = 0; index < items.size(); ++index) {
    const std::string& name = items[index].name;
    parts.push_back(fmt::format("{} ({})", name.empty() ? std::to_string(index) : name, detail(items[index])));
  }
  return parts.empty() ? "0" : fmt::format("{}: {}", parts.size(), fmt::join(parts, ", "));
}

std::string line(std::string_view title, const std::string& text) { return fmt::format("{:<15}{}\n", title, text); }

std::string scenes_text(const scene::Scene& scene) {
  return scene.scene_names.size() < 2 ? std::to_string(scene.scene_names.size())
                                      : fmt::format("{}: {}; this is {}", scene.scene_names.size(),
                                                    fmt::join(scene.scene_names, ", "), scene.name);
}

/// How many materials the file has: the last one of the list is the default, for "none".
size_t material_count(const scene::Scene& scene) { return scene.materials.empty() ? 0 : scene.materials.size() - 1; }

/// Far from the file's origin corners need more digits to differ.
std::string bounds_text(const scene::Scene& scene) {
  const scene::Bounds bounds = bounds_of(scene);
  if (bounds.empty()) return "nothing is drawn";
  const glm::vec3 size = bounds.high - bounds.low;
  const int digits = scene.origin == glm::dvec3(0) ? 4 : 10;
  const auto corner = [&](const glm::vec3& v) {
    const glm::dvec3 place = scene.origin + glm::dvec3(v);
    return fmt::format("{:.{}g},{:.{}g},{:.{}g}", place.x, digits, place.y, digits, place.z, digits);
  };
  return fmt::format("{:.4g} x {:.4g} x {:.4g} m, from {} to {}", size.x, size.y, size.z, corner(bounds.low),
                     corner(bounds.high));
}

std::string variants_text(const scene::Scene& scene) {
  return scene.variants.empty() ? "0" : fmt::format("{}: {}", scene.variants.size(), fmt::join(scene.variants, ", "));
}

std::string clauses_text(const std::vector<std::string>& clauses) {
  return clauses.empty() ? "nothing" : fmt::format("{}", fmt::join(clauses, "; "));
}

/// What the shaders need bound at once, and what the device can.
Json limits_json(const gpu::StageLimits& available) {
  Json json;
  for (const gpu::StageLimit& limit : gpu::stage_limits)
    json[limit.key] = {{"needed", gpu::max_needed().*limit.value}, {"available", available.*limit.value}};
  return json;
}

}  // namespace

namespace {

/// What a device may have and need not.
std::string extras_text(const gpu::DeviceInfo& device) {
  const auto has = [](bool present, const char* what) { return fmt::format("{} {}", present ? "has" : "no", what); };
  return fmt::format("{}, {}, {}", has(device.ray_queries, "ray queries"),
                     has(device.reconvergence, "maximal reconvergence"),
                     has(device.special_values, "promise of infinities"));
}

}  // namespace

std::string devices_text(const std::vector<gpu::DeviceInfo>& devices) {
  std::string text;
  for (const gpu::DeviceInfo& device : devices)
    text += fmt::format(
        "{}: {}\n   {}, driver {} {}, Vulkan {}, subgroups of {}\n   UUID {}\n   {}\n   needs {}\n   "
        "{}\n",
        device.index, device.name, device.type, device.driver, device.driver_version, device.api_version,
        device.subgroup_size, device.uuid, extras_text(device), gpu::needs_text(device.stage, gpu::max_needed()),
        device.unusable.empty() ? "usable" : "not usable: " + device.unusable);
  return text;
}

Json devices_json(const std::vector<gpu::DeviceInfo>& devices) {
  const Json list = list_of(devices, [](const gpu::DeviceInfo& device) {
    Json json = {{"index", device.index}};
    json.update(output::device_json(device));
    json["uuid"] = device.uuid;
    json["ray_queries"] = device.ray_queries;
    json["maximal_reconvergence"] = device.reconvergence;
    json["special_values"] = device.special_values;
    json["limits"] = limits_json(device.stage);
    json["usable"] = device.unusable.empty();
    json["reason"] = device.unusable.empty() ? Json() : Json(device.unusable);
    return json;
  });
  return {{"schema", "crsh-info/1"}, {"devices", list}};
}

std::string scene_text(const scene::Scene& scene) {
  const auto light = [](const scene::Light& item) { return fmt::format("{}, {:.4g}", type_of(item), item.intensity); };
  const auto animation = [](const scene::Animation& item) { return fmt::format("{:.4g} s", item.duration); };
  return line("scenes", scenes_text(scene)) +
         line("triangles", fmt::format("{} drawn, instances expanded", scene.triangle_count())) +
         line("meshes", std::to_string(scene.meshes.size())) +
         line("instances", std::to_string(scene.instances.size())) +
         line("materials", std::to_string(material_count(scene))) +
         line("textures", std::to_string(scene.textures.size())) + line("lights", counted(scene.lights, light)) +
         line("cameras", counted(scene.cameras, [](const scene::Camera& camera) { return type_of(camera); })) +
         line("animations", counted(scene.animations, animation)) + line("variants", variants_text(scene)) +
         line("bounds", bounds_text(scene)) + line("not supported", clauses_text(scene.unsupported)) +
         line("approximated", clauses_text(scene::approximated(scene)));
}

Json scene_json(const scene::Scene& scene) {
  const auto light = [](const scene::Light& item) {
    return Json{{"name", item.name}, {"type", type_of(item)}, {"intensity", json_of(item.intensity)}};
  };
  const auto camera = [](const scene::Camera& item) { return Json{{"name", item.name}, {"type", type_of(item)}}; };
  const auto animation = [](const scene::Animation& item) {
    return Json{{"name", item.name}, {"duration", json_of(item.duration)}};
  };
  return {{"schema", "crsh-info/1"},
          {"scene",
           {{"path", scene.path.string()},
            {"name", scene.name},
            {"scenes", scene.scene_names},
            {"triangles", scene.triangle_count()},
            {"meshes", scene.meshes.size()},
            {"instances", scene.instances.size()},
            {"materials", material_count(scene)},
            {"textures", scene.textures.size()},
            {"lights", list_of(scene.lights, light)},
            {"cameras", list_of(scene.cameras, camera)},
            {"animations", list_of(scene.animations, animation)},
            {"variants", scene.variants},
            {"bounds", bounds_json(scene)},
            {"unsupported", scene.unsupported},
            {"approximated", scene::approximated(scene)}}}};
}

}  // namespace crsh::cli
