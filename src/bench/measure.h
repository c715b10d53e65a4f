#pragma once
// Renders the same pictures in several ways, in turn, so that whatever slows the machine down slows all of them.

#include <functional>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "crsh/options.h"
#include "crsh/statistics.h"
#include "gpu/device.h"
#include "scene/scene.h"

namespace crsh::bench {

/// One way to render a scene.
struct Variant {
  std::string label;                                               ///< "crsh", "crsh arity=4"
  nlohmann::ordered_json vary = nlohmann::ordered_json::object();  ///< what differs from the preset: {"arity": "4"}
  std::string rays;                                                ///< variants with the same text cast the same rays
  RenderOptions options;
  std::vector<double> seconds = {0};                               ///< of the scene's animation: the frames of a pass
  nlohmann::ordered_json when = nlohmann::ordered_json::object();  ///< the options that say so
  bool timed = true;                                               ///< else it is rendered once, for its counters
};

/// Whether every ray meets every triangle: so slow that it may be counted instead of traced.
[[nodiscard]] bool is_brute(const Variant& variant);
/// Whether rays go through a hierarchy over the triangles that is built here.
[[nodiscard]] bool has_object_hierarchy(const Variant& variant);

/// What a variant took. The counters are those of one pass: all passes have the same.
struct Result {
  Variant variant;               ///< with the effective options
  Statistics counters;           ///< of one pass; `frames` are the timed ones, without warm-up
  FrameTime first_frame;         ///< of all, in which an object hierarchy is built
  double seconds = 0;            ///< that the first pass took
  std::vector<uint32_t> places;  ///< of each timed frame in the sequence of all variants' timed frames
  std::string counted_from;      ///< not empty: not traced; the rays are those that this preset cast
  glm::mat4 world_to_camera{1}, world_to_ndc{1};
  uint32_t width = 0, height = 0;
  std::string picture_png;  ///< of the first frame, where pictures were asked for
  std::vector<float> heat;  ///< its tests a pixel, where pictures were asked for and rays were traced

  /// Timed ones.
  [[nodiscard]] uint64_t passes() const { return counters.frames.size() / variant.seconds.size(); }
};

struct Schedule {
  uint32_t warmup = 3, repeat = 58;      ///< passes a variant
  bool pictures = false;                 ///< one more frame each, with its picture and tests a pixel
  std::optional<float> exposure = 0.0f;  ///< of the picture, in stops; none: automatic
  double budget_seconds = 0;             ///< fewer passes where those would take longer; 0: none. Each has one at least
  std::function<void(const std::string&)> say = {};  ///< gets a line on what the budget left out
};

/// Without a budget, brute force is not traced where all its frames together have more tests than this.
inline constexpr uint64_t max_brute_force_tests = 3'000'000'000;

/// Called with 0..1 of all the work.
using Progress = std::function<void(double)>;

/// Results in the order of `variants`. Asserts that every repeat counts the same. Throws what rendering throws.
[[nodiscard]] std::vector<Result> measure(gpu::Device& device, const scene::Scene& scene,
                                          const std::vector<Variant>& variants, const Schedule& schedule,
                                          const Progress& progress);

}  // namespace crsh::bench
