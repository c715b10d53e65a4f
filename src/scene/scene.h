#pragma once
// A scene in memory, as loaded: meshes, instances, materials, lights, cameras and their animation.

#include <algorithm>
#include <array>
#include <cstdint>
#include <filesystem>
#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>
#include <limits>
#include <optional>
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
  /// Metres; 0 where empty.
  [[nodiscard]] float longest_edge() const {
    const glm::vec3 edges = empty() ? glm::vec3(0) : high - low;
    return std::max({edges.x, edges.y, edges.z});
  }
};

/// How many sets of texture coordinates a vertex has.
inline constexpr size_t uv_sets = 3;

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
  Sphere sphere;                    ///< smallest enclosing sphere of the corners (Gärtner 1999)
  /// Radii of spheres around sphere.centre that also hold every triangle's own smallest sphere, after a similarity and
  /// after any affine map (times its largest stretch). Culling uses these, because a hit lies in its triangle's
  /// smallest sphere by definition.
  float cover_similar = 0, cover_affine = 0;
};

struct Transform {
  glm::vec3 translation{0};
  glm::quat rotation{1, 0, 0, 0};
  glm::vec3 scale{1};
};

struct Node {
  std::string name;
  std::optional<uint32_t> parent;
  Transform transform;
  std::optional<glm::mat4> matrix;  ///< used in place of `transform`
};

struct Instance {
  uint32_t mesh = 0, node = 0;
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
  float yfov = 0.7853981634f;   ///< radians, vertical
  float xmag = 1, ymag = 1;     ///< orthographic half extents, metres
  std::optional<float> aspect;  ///< width / height
  float near_plane = 0.01f;     ///< metres
  uint32_t node = 0;
};

enum class Interpolation { step, linear, cubic_spline };
enum class Path { translation, rotation, scale };

struct Channel {
  uint32_t node = 0;
  Path path = Path::translation;
  Interpolation interpolation = Interpolation::linear;
  std::vector<float> times;       ///< seconds, rising
  std::vector<glm::vec4> values;  ///< one for each time; for cubic_spline three: in-tangent, value, out-tangent
};

struct Animation {
  std::string name;
  std::vector<Channel> channels;
  float duration = 0;  ///< seconds
};

/// How the scene stands in a frame: world transforms of instances, lights and cameras, in the order of the scene's
/// lists.
struct Pose {
  std::vector<glm::mat4> instances, lights, cameras;
};

struct Scene {
  std::filesystem::path path;
  std::string name;                                     ///< of the chosen glTF scene
  std::array<uint32_t, uv_sets> texcoords = {0, 1, 2};  ///< the N of the TEXCOORD_N that Mesh::uv are
  std::vector<Mesh> meshes;
  std::vector<Instance> instances;
  std::vector<Material> materials;  ///< the last one is glTF's default material
  std::vector<Texture> textures;
  std::vector<Image> images;
  std::vector<Node> nodes;
  std::vector<Light> lights;
  std::vector<Camera> cameras;
  std::vector<Animation> animations;
  std::vector<std::string> unsupported;  ///< what the file has that crsh does not do, a short clause each
  std::vector<std::string> scene_names;  ///< of all glTF scenes in the file

  /// How many triangles are drawn, those of a mesh once for each instance.
  [[nodiscard]] uint64_t triangle_count() const;
  /// The animation with this index or name; for an empty text the first, if any. Throws UserError that lists them.
  [[nodiscard]] std::optional<uint32_t> find_animation(const std::string& which) const;
  /// World transforms at `seconds` of an animation; without one, those of the nodes as the file has them.
  [[nodiscard]] Pose pose(double seconds, std::optional<uint32_t> animation) const;
  /// World bounds of all drawn geometry in this pose (empty for an empty scene).
  [[nodiscard]] Bounds bounds(const Pose& pose) const;
};

/// The object's sphere after `transform` (section 3.2.1): centre moved, radius times the largest stretch, rounded
/// outwards; `cover_similar` where the transform is a similarity, else `cover_affine`.
[[nodiscard]] Sphere transformed_sphere(const Mesh& mesh, const glm::mat4& transform);

}  // namespace crsh::scene
