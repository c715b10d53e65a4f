#pragma once
// Everything that the window shows and people change.

#include <array>
#include <chrono>
#include <deque>
#include <string>
#include <vector>

#include "viewer/args.h"
#include "viewer/camera.h"
#include "viewer/job.h"
#include "viewer/show.h"

namespace crsh::viewer {

/// A line that is shown for a while.
struct Message {
  std::string text;
  bool error = false;
  std::chrono::steady_clock::time_point until;
};

/// One half of the split window, or the whole.
struct Side {
  Show show = Show::light;
  ShownPtr shown;
  NodeFramePtr node_frame;  ///< its ray nodes and boxes, where they are shown
};

struct Model {
  explicit Model(const Arguments& given);

  Arguments arguments;
  cli::RenderCommand command;  ///< options of what is shown; the view only where `own_view` is false
  std::string path;            ///< of the scene to be shown
  uint64_t load = 0;           ///< counts how often a scene was asked for
  LoadedPtr loaded;
  scene::Bounds bounds;  ///< of the scene at time 0
  News news;

  OrbitCamera camera;
  bool own_view = false;      ///< `camera` places the eye, not the options
  uint32_t camera_index = 0;  ///< of the file's camera that Tab chose last
  double seconds = 0;
  bool playing = false;
  raster::ImageSize area;  ///< of the picture, pixels

  Side left, right;
  bool split = false;
  float split_place = 0.5f;
  AlgorithmOptions other;  ///< the right side's
  uint32_t node_kind = 0;  ///< of the rays whose order and nodes are shown
  bool show_nodes = false, nodes_of_all = false, show_bounds = false;
  uint32_t nodes_level = 1, box_depth = 4;

  bool exr_wanted = false;   ///< an EXR is to be saved: its layers are rendered, too
  uint64_t wish_number = 0;  ///< of the last wish that the worker got
  bool wish_moves = false;

  bool panels = true, keys_help = false;
  std::vector<Message> messages;
  std::array<std::deque<float>, stage_count> stage_history;  ///< milliseconds a picture
  uint64_t history_serial = 0;
  std::chrono::steady_clock::time_point moved{};  ///< when the view changed last

  [[nodiscard]] const scene::Scene* scene() const { return loaded ? &loaded->scene : nullptr; }
  [[nodiscard]] float aspect() const { return area.height ? float(area.width) / float(area.height) : 1; }
  /// The algorithms differ, so that two pictures are needed.
  [[nodiscard]] bool two_pictures() const { return split && !(other == command.options.algorithm); }
  /// The algorithm's rays go through one, whose boxes can be shown.
  [[nodiscard]] bool has_object_hierarchy() const;
  /// Those of the scene that play.
  [[nodiscard]] const std::vector<uint32_t>& animations() const;
  /// Seconds until they have all ended.
  [[nodiscard]] float duration() const;

  void say(const std::string& text, bool error = false);
  void open(const std::string& new_path);
  /// Takes a scene that was loaded, with its cameras, lights and bounds.
  void take(const LoadedPtr& scene);
  /// Takes new pictures, and how long they took.
  void take_pictures(const News& latest);
  /// From here on `camera` places the eye, no longer the options.
  void begin_own_view();
  void view_moved();
  void next_camera();
  void frame_all();
  void change_projection();
  /// Whether what is shown is what was asked for, in full resolution. rests(): whether nothing more will come, either.
  [[nodiscard]] bool fine() const;
  [[nodiscard]] bool rests() const;
  /// The exposure in stops: the one chosen, or with "auto" the one that suits the picture.
  [[nodiscard]] double exposure() const;
  [[nodiscard]] bool moving() const;
  [[nodiscard]] Wish wish() const;

 private:
  /// What animations() found last, and for what.
  struct Playing {
    LoadedPtr loaded;
    std::string which;
    std::vector<uint32_t> animations;
  };
  mutable Playing playing_;
};

}  // namespace crsh::viewer
