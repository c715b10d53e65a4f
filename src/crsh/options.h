#pragma once
// Every option that changes what is rendered or how, with its default: the command line, the viewer and the
// statistics all speak of this struct.

#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "crsh/kinds.h"
#include "crsh/layers.h"

namespace crsh {

/// --light x,y,z[,candela[,past-backs]]
struct LightOption {
  bool operator==(const LightOption&) const = default;
  glm::dvec3 position{0};        ///< metres, in the file's coordinates
  std::optional<float> candela;  ///< none: π·d² ÷ number of such lights
  bool past_backs = false;       ///< backs of single-sided triangles, which the eye does not see, do not block it
};

/// --eye --target --up --fov --orthographic
struct ViewOption {
  bool operator==(const ViewOption&) const = default;
  std::optional<glm::dvec3> eye, target;  ///< metres, in the file's coordinates
  glm::vec3 up{0, 1, 0};
  std::optional<float> fov_degrees;          ///< vertical
  std::optional<float> orthographic_height;  ///< of the image, metres: rays are parallel
};

enum class RayOrder { scanline, tiles };
enum class NodeCut { fixed, cut };
enum class Fit { merged, all };
/// Equation 9: the distance along the cone's axis with its sign, or as the paper prints it, without.
enum class ConeTest { with_sign, as_printed };

inline constexpr std::string_view default_preset = "crsh-bvh";

/// The switches of which presets are made.
struct AlgorithmOptions {
  bool operator==(const AlgorithmOptions&) const = default;
  std::string preset = std::string(default_preset);
  /// What rays meet, and how: a row of src/trace/tracers.cpp. Switches matter to those that need sorted rays.
  std::string tracer = "mesh-nodes";
  PerKind<std::string> keys;  ///< a sort key for each kind of rays; empty: they are not sorted
  RayOrder ray_order = RayOrder::scanline;
  bool compression = true;
  NodeCut nodes = NodeCut::fixed;
  float cut_angle = 0.1f;  ///< radians: a cut node holds no ray farther from its first one's direction
  float cut_distance = 4;  ///< share of the scene's longest edge: nor one that begins farther from where that begins
  /// Where cut nodes would hold fewer, unsorted and on average, rays go one by one through the object hierarchy, where
  /// the tracer needs one.
  float least_rays = 2;
  uint32_t arity = 8;
  PerKind<uint32_t> levels{2};
  std::string bound = "sphere-cone";
  Fit fit = Fit::all;
  ConeTest cone_test = ConeTest::with_sign;  ///< of bounds with cones
  bool interval = true;
  bool mesh_culling = true;
  bool mixed_batches = true;  ///< ray kinds of a bounce are sorted and bundled together
};

/// An algorithm: values of all switches under a name.
struct Preset {
  std::string_view name;  ///< --algorithm
  std::string_view help;
  AlgorithmOptions (*options)();
  bool everywhere = true;  ///< on every device, with the same picture bit for bit; else it is near the others'
};
/// In the order in which tables show them.
[[nodiscard]] std::span<const Preset> preset_table();
/// Names of the presets that run everywhere.
[[nodiscard]] const std::vector<std::string>& preset_names();
/// The preset of this name. Throws UserError that lists all for any other.
[[nodiscard]] AlgorithmOptions preset(std::string_view name);
/// The key that --key best means for rays of this kind: the preset's own, or ray_kinds' where the preset does not sort.
[[nodiscard]] std::string best_key(std::string_view preset_name, size_t kind);
/// The preset that only devices with ray queries have, and whose picture is the same within a tolerance.
inline constexpr const char* ray_query_preset = "ray-query";

struct RenderOptions {
  bool operator==(const RenderOptions&) const = default;
  uint32_t width = 0, height = 512;  ///< width 0: from the camera's aspect
  uint32_t samples = 1, seed = 0, bounces = 4;
  std::optional<glm::vec3> background = glm::vec3(0);  ///< none: transparent
  std::string scene, camera, animation;                ///< index or name (or all); empty: the default
  ViewOption view;
  std::string variant;              ///< of the materials, by index or name; empty: the usual ones
  std::vector<std::string> hidden;  ///< instances that are left out, by index or name (scene/hide.h)
  std::vector<LightOption> lights;  ///< not empty: they replace the file's
  PerKind<bool> rays{[](uint32_t kind) { return ray_kinds[kind].adds_light; }};
  bool override_mirror = false;
  LayerSet layers = default_layers;  ///< of the picture, besides the beauty
  AlgorithmOptions algorithm = preset(default_preset);
  uint64_t submit_work = uint64_t(1) << 26;  ///< tests a submit
  std::optional<std::string> mutation;       ///< test-only: a fault to switch on (tests/README.md)
};

}  // namespace crsh
