#pragma once
// A scene in memory, as loaded: meshes, instances, materials, lights, cameras and their animation.

#include <algorithm>
#include <array>
#include <cstdint>
#include <filesystem>
#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>
#include <limits>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "scene/material.h"
#include "scene/packed.h"

namespace crsh::scene {

/// Centre and radius in metres.
struct Sphere {
  glm::vec3 centre{0};
  float radius = 0;
};

struct Bounds {
  glm::vec3 low{std::numeric_limits<float>::infinity()};
  glm::vec3 high{-std::numeric_limits<float>::infinity()};
  [[nodiscard]] bool empty() const { return !(low.x <= high.x); }
  void include(const Bounds& other) {
    low = glm::min(low, other.low);
    high = glm::max(high, other.high);
  }
  void include(const glm::vec3& point) { include(Bounds{point, point}); }
  void include(const Sphere& sphere) { include(Bounds{sphere.centre - sphere.radius, sphere.centre + sphere.radius}); }
  /// Metres; 0 where empty.
  [[nodiscard]] float longest_edge() const {
    const glm::vec3 edges = empty() ? glm::vec3(0) : high - low;
    return std::max({edges.x, edges.y, edges.z});
  }
};

/// How many sets of texture coordinates a vertex has.
inline constexpr size_t uv_sets = 3;

/// A list for each vertex, one behind the other.
template <class T>
struct Rows {
  std::vector<uint32_t> first;  ///< where each vertex's list begins, and where the last one ends; empty: there are none
  std::vector<T> items;
  [[nodiscard]] bool empty() const { return items.empty(); }
  [[nodiscard]] std::span<const T> of(size_t vertex) const {
    if (first.empty()) return {};
    return std::span(items).subspan(first[vertex], first[vertex + 1] - first[vertex]);
  }
};

/// How much a joint of a skin moves a vertex; a vertex's weights sum to 1.
struct Influence {
  uint32_t joint = 0;  ///< a place in Skin::joints, or unskinned
  float weight = 0;
};
/// In place of a joint: the last one of the instance's skin, which is its own node (Skin::has_own_node).
inline constexpr uint32_t unskinned = 0xFFFFFFFFu;

/// What a morph target of weight 1 adds to a vertex.
struct Displacement {
  uint32_t target = 0;
  glm::vec3 position{0}, normal{0}, tangent{0};
};

/// All vertices that a joint moves, at rest.
struct JointBox {
  uint32_t joint = 0;
  Bounds box;
};

/// A glTF mesh, with all its triangle primitives in one. Each attribute has as many elements as `positions`, but those
/// that are empty because no material of the mesh needs them.
struct Mesh {
  std::string name;
  std::vector<glm::vec3> positions;
  std::vector<glm::vec3> normals;                  ///< unit; zero, for flat shading, where the file has none
  std::vector<glm::vec4> tangents;                 ///< unit; w: 1 or -1, the bitangent's sign; or empty
  std::array<std::vector<glm::vec2>, uv_sets> uv;  ///< or empty: zeros
  std::vector<PackedColour> colours;               ///< white where the file has none
  std::vector<glm::uvec3> triangles;
  std::vector<uint32_t> materials;  ///< a triangle: index into Scene::materials
  glm::dvec3 origin{0};             ///< what the file adds to `positions` (scene/origin.h)
  Sphere sphere;                    ///< smallest enclosing sphere of the corners (Gärtner 1999)
  /// Radii of spheres around sphere.centre that also hold every triangle's own smallest sphere, after a similarity and
  /// after any affine map (times its largest stretch). Culling uses these, because a hit lies in its triangle's
  /// smallest sphere by definition.
  float cover_similar = 0, cover_affine = 0;

  // Of meshes that deform (scene/deform.h).
  Rows<Influence> influences;         ///< by the joints of a skin
  uint32_t joint_count = 0;           ///< a skin has so many joints at least
  std::vector<JointBox> joint_boxes;  ///< of every joint that has influence, by rising number
  Rows<Displacement> displacements;   ///< by morph targets
  uint32_t target_count = 0;
  std::vector<Bounds> target_boxes;  ///< all displacements of each target
  std::vector<float> weights;        ///< of the targets, where neither node nor animation has others
};

/// Joint j of a skin turns a mesh's vertices by the world matrix of its node times inverse_bind[j].
struct Skin {
  std::vector<uint32_t> joints;  ///< nodes
  std::vector<glm::mat4> inverse_bind;
  bool has_own_node = false;  ///< the last joint is the instance's node, for vertices that no joint moves
};

struct Transform {
  glm::dvec3 translation{0};
  glm::quat rotation{1, 0, 0, 0};
  glm::vec3 scale{1};
};

struct Node {
  std::string name;
  std::optional<uint32_t> parent;
  Transform transform;
  std::optional<glm::dmat4> matrix;  ///< used in place of `transform`
  std::vector<float> weights;        ///< of its mesh's morph targets; empty: the mesh's own
  bool visible = true;               ///< else nothing below it is drawn or shines (KHR_node_visibility)
  /// To the parent, as the node rests.
  [[nodiscard]] glm::dmat4 local() const;
};

struct Instance {
  uint32_t mesh = 0, node = 0;
  std::optional<uint32_t> skin = {};    ///< its joints then place the mesh, and not its node
  std::optional<glm::mat4> local = {};  ///< where it stands, seen from the node (EXT_mesh_gpu_instancing)
};

enum class LightType : uint32_t { point = 0, spot = 1, directional = 2 };

/// KHR_lights_punctual. Intensity: candela (point, spot) or lux (directional).
struct Light {
  std::string name;
  LightType type = LightType::point;
  glm::vec3 colour{1};
  float intensity = 1;
  float range = std::numeric_limits<float>::infinity();
  float inner_cone = 0, outer_cone = 0.7853981634f;  ///< radians
  uint32_t node = 0;
};

struct Camera {
  std::string name;
  bool orthographic = false;
  float yfov = 0.7853981634f;      ///< radians, vertical
  float xmag = 1, ymag = 1;        ///< orthographic half extents, metres
  std::optional<float> aspect;     ///< width / height
  float near_plane = 0.01f;        ///< metres
  std::optional<float> far_plane;  ///< metres; nothing farther away is seen
  uint32_t node = 0;
};

enum class Interpolation { step, linear, cubic_spline };

/// What an animation drives: a property (a row of scene/properties.h) of an element of one of the scene's lists.
enum class Driven { node, light, camera, material };
struct Target {
  Driven driven = Driven::node;
  uint32_t object = 0, property = 0;
  auto operator<=>(const Target&) const = default;
};

struct Channel {
  Target target;
  Interpolation interpolation = Interpolation::linear;
  uint32_t width = 3;         ///< numbers a value
  std::vector<float> times;   ///< seconds, rising
  std::vector<float> values;  ///< one value a time; for cubic_spline three: in-tangent, value, out-tangent
};

struct Animation {
  std::string name;
  std::vector<Channel> channels;
  float duration = 0;  ///< seconds
};

/// Where all drawn geometry is in a frame. What is built over it is up to date as long as this stays the same.
struct GeometryPose {
  /// Transforms to the drawn world; of a skinned one the identity, for its joints have its place.
  std::vector<glm::mat4> instances;
  std::vector<std::vector<glm::mat4>> joints;  ///< of each skin
  std::vector<std::vector<float>> weights;     ///< of each instance's morph targets
  std::vector<bool> hidden;                    ///< instances of which nothing is seen; empty: none
  bool operator==(const GeometryPose&) const = default;
};

/// What animations have changed besides, by index into the scene's lists.
struct Changes {
  std::map<uint32_t, Light> lights;
  std::map<uint32_t, Camera> cameras;
  std::map<uint32_t, Material> materials;
};

/// Element i of one of the scene's lists as it is changed.
template <class T>
[[nodiscard]] const T& changed_or(const std::map<uint32_t, T>& changed, const std::vector<T>& list, uint32_t i) {
  const auto found = changed.find(i);
  return found == changed.end() ? list[i] : found->second;
}

/// How the scene stands in a frame: in the order of the scene's lists.
struct Pose : GeometryPose {
  std::vector<glm::mat4> lights, cameras;  ///< transforms to the drawn world
  Changes changes;
};

struct Scene {
  std::filesystem::path path;
  std::string name;                                     ///< of the chosen glTF scene
  std::array<uint32_t, uv_sets> texcoords = {0, 1, 2};  ///< the N of the TEXCOORD_N that Mesh::uv are
  std::vector<Mesh> meshes;
  std::vector<Instance> instances;
  std::vector<Skin> skins;
  std::vector<Material> materials;  ///< the last one is glTF's default material
  std::vector<Texture> textures;
  std::vector<Image> images;
  std::vector<Node> nodes;
  std::vector<Light> lights;
  std::vector<Camera> cameras;
  std::vector<Animation> animations;
  std::vector<std::string> unsupported;  ///< what the file has that crsh does not do, a short clause each
  std::vector<std::string> scene_names;  ///< of all glTF scenes in the file
  std::vector<std::string> variants;     ///< names of all sets of materials in the file (KHR_materials_variants)
  /// Where the drawn world's (0, 0, 0) lies in the file's, metres. All that is drawn, and all that is in floats, is in
  /// the drawn world; what people give and get is in the file's (scene/origin.h). Mostly both are the same.
  glm::dvec3 origin{0};

  /// The file's `place` in the drawn world, and back: as the decimal number that people would write for it.
  [[nodiscard]] glm::vec3 drawn(const glm::dvec3& place) const { return glm::vec3(place - origin); }
  [[nodiscard]] glm::dvec3 in_file(const glm::vec3& place) const;
  /// A node's `world` transform in the file as one to the drawn world, for a mesh whose positions lack `lacking`.
  [[nodiscard]] glm::mat4 drawn(glm::dmat4 world, const glm::dvec3& lacking = glm::dvec3(0)) const;
  /// How many triangles are drawn, those of a mesh once for each instance.
  [[nodiscard]] uint64_t triangle_count() const;
  /// At `seconds` of these animations (scene/playing.h), the later ones over the earlier; without any, as the file has
  /// it.
  [[nodiscard]] Pose pose(double seconds, const std::vector<uint32_t>& animations) const;
  /// Bounds of all drawn geometry in this pose, deformed as it is, in the drawn world (empty for an empty scene).
  [[nodiscard]] Bounds bounds(const Pose& pose) const;
};

/// The object's sphere after `transform` (section 3.2.1): centre moved, radius times the largest stretch, rounded
/// outwards; `cover_similar` where the transform is a similarity, else `cover_affine`.
[[nodiscard]] Sphere transformed_sphere(const Mesh& mesh, const glm::mat4& transform);

}  // namespace crsh::scene
