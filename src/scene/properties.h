#pragma once
// What animations can change: a table of properties for each of the scene's lists.

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <span>
#include <string_view>

#include "scene/scene.h"

namespace crsh::scene {

/// A property as KHR_animation_pointer names it, and how an animation's numbers become its value.
template <class Object>
struct Property {
  std::string_view pointer;  ///< behind the object's own path
  uint32_t width;            ///< numbers; 0: as many as the mesh has morph targets
  void (*set)(Object&, std::span<const float>);
};

/// The part of a node that animations change.
struct NodeState {
  Transform transform;
  std::vector<float> weights;
  bool visible = true;
};

using Numbers = std::span<const float>;

inline float at_most_one(float value) { return std::clamp(value, 0.0f, 1.0f); }
inline float positive(float value) { return std::max(value, std::numeric_limits<float>::min()); }
inline float brightness(float value) { return std::clamp(value, 0.0f, 1e15f); }
inline float cone_angle(float value) { return std::clamp(value, 0.0f, std::numbers::pi_v<float> / 2); }
inline void set_emissive(Material& m) { m.emissive = glm::min(m.emissive_factor * m.emissive_strength, 1e15f); }

/// Rows of node_properties.
inline constexpr uint32_t node_translation = 0, node_rotation = 1, node_scale = 2, node_weights = 3, node_visible = 4;
/// Rows of material_properties.
inline constexpr uint32_t material_metallic = 1, material_transmission = 6;

inline constexpr std::array node_properties = {
    Property<NodeState>{"translation", 3,
                        [](NodeState& n, Numbers v) {
                          n.transform.translation = {v[0], v[1], v[2]};
                        }},
    Property<NodeState>{"rotation", 4,
                        [](NodeState& n, Numbers v) { n.transform.rotation = glm::quat(v[3], v[0], v[1], v[2]); }},
    Property<NodeState>{"scale", 3,
                        [](NodeState& n, Numbers v) {
                          n.transform.scale = {v[0], v[1], v[2]};
                        }},
    Property<NodeState>{"weights", 0, [](NodeState& n, Numbers v) { n.weights.assign(v.begin(), v.end()); }},
    Property<NodeState>{"extensions/KHR_node_visibility/visible", 1,
                        [](NodeState& n, Numbers v) { n.visible = v[0] != 0; }},
};

inline constexpr std::array light_properties = {
    Property<Light>{"color", 3,
                    [](Light& l, Numbers v) {
                      l.colour = {brightness(v[0]), brightness(v[1]), brightness(v[2])};
                    }},
    Property<Light>{"intensity", 1, [](Light& l, Numbers v) { l.intensity = brightness(v[0]); }},
    Property<Light>{"range", 1, [](Light& l, Numbers v) { l.range = positive(v[0]); }},
    Property<Light>{"spot/innerConeAngle", 1, [](Light& l, Numbers v) { l.inner_cone = cone_angle(v[0]); }},
    Property<Light>{"spot/outerConeAngle", 1, [](Light& l, Numbers v) { l.outer_cone = cone_angle(v[0]); }},
};

inline constexpr std::array camera_properties = {
    Property<Camera>{"perspective/yfov", 1, [](Camera& c, Numbers v) { c.yfov = positive(v[0]); }},
    Property<Camera>{"perspective/znear", 1, [](Camera& c, Numbers v) { c.near_plane = positive(v[0]); }},
    Property<Camera>{"orthographic/ymag", 1, [](Camera& c, Numbers v) { c.ymag = positive(std::abs(v[0])); }},
    Property<Camera>{"orthographic/xmag", 1, [](Camera& c, Numbers v) { c.xmag = positive(std::abs(v[0])); }},
    Property<Camera>{"orthographic/znear", 1, [](Camera& c, Numbers v) { c.near_plane = v[0]; }},
};

inline constexpr std::array material_properties = {
    Property<Material>{
        "pbrMetallicRoughness/baseColorFactor", 4,
        [](Material& m, Numbers v) { m.base_colour = glm::clamp(glm::vec4(v[0], v[1], v[2], v[3]), 0.0f, 1.0f); }},
    Property<Material>{"pbrMetallicRoughness/metallicFactor", 1,
                       [](Material& m, Numbers v) { m.metallic = at_most_one(v[0]); }},
    Property<Material>{"pbrMetallicRoughness/roughnessFactor", 1,
                       [](Material& m, Numbers v) { m.roughness = at_most_one(v[0]); }},
    Property<Material>{"emissiveFactor", 3,
                       [](Material& m, Numbers v) {
                         m.emissive_factor = glm::max(glm::vec3(v[0], v[1], v[2]), 0.0f);
                         set_emissive(m);
                       }},
    Property<Material>{"extensions/KHR_materials_emissive_strength/emissiveStrength", 1,
                       [](Material& m, Numbers v) {
                         m.emissive_strength = std::max(v[0], 0.0f);
                         set_emissive(m);
                       }},
    Property<Material>{"extensions/KHR_materials_ior/ior", 1,
                       [](Material& m, Numbers v) { m.ior = v[0] == 0 ? 1e6f : std::max(v[0], 1.0f); }},
    Property<Material>{"extensions/KHR_materials_transmission/transmissionFactor", 1,
                       [](Material& m, Numbers v) { m.transmission = at_most_one(v[0]); }},
    Property<Material>{"extensions/KHR_materials_volume/thicknessFactor", 1,
                       [](Material& m, Numbers v) { m.thickness = std::max(v[0], 0.0f); }},
};

}  // namespace crsh::scene
