#pragma once
// The options of `crsh render`, as tables.

#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <string>
#include <vector>

#include "cli/command.h"
#include "crsh/options.h"
#include "gpu/device.h"
#include "output/exr.h"
#include "output/path_pattern.h"

namespace crsh::cli {

/// --frames A..B
struct FrameRange {
  uint32_t first = 0, last = 0;
};

/// A picture to make: its number, for {frame}, and its place in time.
struct FrameTask {
  uint32_t number = 0;
  double seconds = 0;
};

enum class ProgressChoice { automatic, json, none };

/// Everything that the command line of `crsh render` says.
struct RenderCommand {
  std::string scene;
  RenderOptions options;
  gpu::DeviceRequest device;
  std::vector<output::PathPattern> outputs;
  std::string stats;                     ///< path, "-" or empty
  std::string dump_rays, replay_rays;    ///< paths or empty
  output::Ids ids = output::Ids::real;   ///< how an EXR has numbers of objects and materials
  std::optional<float> exposure = 0.0f;  ///< stops; none: automatic
  std::optional<float> seconds;          ///< --time
  std::optional<FrameRange> frames;
  float frames_per_second = 24;
  ProgressChoice progress = ProgressChoice::automatic;
  bool quiet = false, verbose = false;
  bool allow_outside = false;  ///< files that the scene names may lie outside its folder
  bool lenient = false;        ///< extensions that the scene requires may be missing here
};

/// All tables, bound to `command`. Rows are set in this order.
[[nodiscard]] std::vector<OptionGroup> render_options(RenderCommand& command);
/// Size, samples, background and such; scene, camera and lights. Both belong to render_options.
[[nodiscard]] OptionGroup picture_options(RenderOptions& options);
[[nodiscard]] OptionGroup scene_options(RenderCommand& command);
/// The preset and its switches. Belongs to render_options.
[[nodiscard]] OptionGroup algorithm_options(AlgorithmOptions& algorithm);
/// --layers, and a line a layer for the help.
[[nodiscard]] Option layers_option(LayerSet& layers);
[[nodiscard]] std::string layers_help();
/// What --algorithm may name, for the help.
[[nodiscard]] std::string presets_help();
/// What --layers may name.
[[nodiscard]] std::vector<std::string> layer_words();

/// Attributes of an EXR: the options that change pixels, with the frame's own time.
[[nodiscard]] output::Attributes attributes_of(RenderCommand& command, double seconds);

/// The pictures that the command asks for, in order of time.
[[nodiscard]] std::vector<FrameTask> frame_tasks(const RenderCommand& command);

}  // namespace crsh::cli
