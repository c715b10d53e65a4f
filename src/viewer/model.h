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
  InsidePtr inside;  ///< where it is wished for
};

struct Model {
  explicit Model(const Arguments& given);

  Arguments arguments;
  cli::RenderCommand command;  ///< effective options of what is shown; its view: only where `own_view` is false
  std::string path;            ///< of the scene that is asked for
  uint64_t load = 0;           ///< how often one was
  LoadedPtr loaded;
  scene::Bounds bounds;  ///< of the scene at time 0
  News news;

  OrbitCamera camera;
  bool own_view = false;      ///< `camera` places the eye, not the options
  uint32_t camera_index = 0;  ///< that Tab went to last
  double seconds = 0;
  bool playing = false;
  raster::ImageSize area;  ///< of the picture, pixels

  Side left, right;
  bool split = false;
  float split_place = 0.5f;
  AlgorithmOptions other;     ///< the right side's
  uint32_t inspect_kind = 0;  ///< of the rays whose order and nodes are shown
  bool show_nodes = false, nodes_of_all = false, show_bounds = false;
  uint32_t nodes_level = 1, box_depth = 4;

  bool exr_wanted = false;   ///< its layers are rendered, too
  uint64_t wish_number = 0;  ///< of what the worker was asked for last
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
  [[nodiscard]] std::optional<uint32_t> animation() const;

  void say(const std::string& text, bool error = false);
  void open(const std::string& new_path);
  /// A scene has come: its cameras, lights and bounds.
  void take(const LoadedPtr& scene);
  /// New pictures and what they took.
  void take_pictures(const News& latest);
  /// The camera is the person's from here on.
  void begin_own_view();
  void view_moved();
  void next_camera();
  void frame_all();
  void change_projection();
  /// What is shown is what is asked for, in full resolution. `rests`: or nothing more will come.
  [[nodiscard]] bool fine() const;
  [[nodiscard]] bool rests() const;
  /// Stops of the picture: as chosen, or that suit it.
  [[nodiscard]] double exposure() const;
  [[nodiscard]] bool moving() const;
  [[nodiscard]] Wish wish() const;
};

}  // namespace crsh::viewer
