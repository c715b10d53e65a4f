#pragma once
// What the window's thread and the renderer's thread tell each other: a wish from the one, news from the other.

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "crsh/options.h"
#include "crsh/picture.h"
#include "crsh/statistics.h"
#include "scene/scene.h"
#include "viewer/node_frame.h"

namespace crsh::viewer {

/// The picture that is wanted.
struct Wish {
  bool operator==(const Wish&) const = default;
  std::filesystem::path path;
  std::string which;           ///< of the file's scenes
  bool allow_outside = false;  ///< files that it names may lie outside its folder
  bool lenient = false;        ///< extensions that it requires may be missing here
  uint64_t load = 0;           ///< another number than the last: the file is to be loaded
  uint64_t scene = 0;          ///< number of the load that `options` are for
  RenderOptions options;       ///< size and layers included; one sample
  double seconds = 0;
  bool moving = false;                    ///< coarse and quick, else fine
  float budget_ms = 50;                   ///< of a coarse frame
  uint32_t max_samples = 1;               ///< of a fine picture
  std::optional<AlgorithmOptions> other;  ///< a second picture, by this algorithm
  std::optional<uint32_t> node_kind;      ///< besides, how rays of this kind are sorted and bundled at bounce 0
};

/// A picture, and what it was rendered with.
struct Shown {
  Picture picture;
  RenderOptions options;  ///< its `samples` are those that the picture has by now
  double seconds = 0;
  bool fine = false;        ///< has the wanted size
  Statistics statistics;    ///< of its last sample
  double milliseconds = 0;  ///< of its last sample, by the clock
  uint64_t scene = 0;       ///< number of its load
  uint64_t wish = 0;        ///< number of the wish that it fulfils
  uint64_t serial = 0;      ///< no two pictures have the same
};
using ShownPtr = std::shared_ptr<const Shown>;
using NodeFramePtr = std::shared_ptr<const NodeFrame>;

struct LoadedScene {
  uint64_t number = 0;
  scene::Scene scene;
};
using LoadedPtr = std::shared_ptr<const LoadedScene>;

/// What the renderer's thread tells.
struct News {
  LoadedPtr loaded;      ///< the scene; null: none is loaded yet
  ShownPtr left, right;  ///< of that scene; right: by the other algorithm
  NodeFramePtr left_node_frame, right_node_frame;
  std::string phase;          ///< "reading scene.glb"; empty: nothing that takes long
  double done = 0;            ///< of the phase, 0 to 1
  std::string error;          ///< a line; empty: none
  uint64_t error_number = 0;  ///< another one for each error
  uint64_t rests_at = 0;      ///< the wish that is fulfilled, all samples included, by its number; 0: none yet
  uint64_t device_bytes = 0;
};

}  // namespace crsh::viewer
