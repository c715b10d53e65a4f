#pragma once
// The viewer: a window, a renderer's thread, and the loop between them.

#include <deque>
#include <filesystem>

#include "viewer/input.h"
#include "viewer/model.h"
#include "viewer/panels/panels.h"
#include "viewer/script.h"
#include "viewer/widgets.h"
#include "viewer/window.h"
#include "viewer/worker.h"

namespace crsh::viewer {

class Viewer {
 public:
  Viewer(gpu::Device& device, const Arguments& arguments);
  ~Viewer();

  /// Runs until the window is closed, or as long as --after and --script say. Throws UserError.
  void run();

 private:
  void frame();
  void take_news();
  void draw();
  void fit_window();
  void act(const std::vector<Action>& actions);
  void save_what_is_ready();
  void play();
  void watch();
  void update_textures();
  void paint(std::unique_ptr<gpu::Texture>& texture, const Side& side);
  [[nodiscard]] std::vector<gpu::ShownTexture> textures(const Layout& layout) const;
  [[nodiscard]] bool finishing() const;
  void count_frame();
  void finish();
  [[nodiscard]] double patience() const;

  gpu::Device& device_;
  Model model_;
  Window window_;
  Widgets widgets_;
  Input input_;
  std::optional<Script> script_;
  std::deque<std::string> saves_, screenshots_;  ///< paths of files that are still to be written
  std::unique_ptr<gpu::Texture> left_, right_;
  struct Painted {
    bool operator==(const Painted&) const = default;
    uint64_t left = 0, right = 0, left_node_frame = 0, right_node_frame = 0;
    Show left_show{}, right_show{};
    double exposure = 0;
    bool split = false;
  };
  Painted painted_;
  double heat_ = 1;
  uint64_t shown_error_ = 0, fine_frames_ = 0;
  bool finished_ = false, fitted_ = false;
  std::filesystem::file_time_type file_time_{};
  std::chrono::steady_clock::time_point last_frame_, last_look_;
  Worker worker_;  ///< the last member: its thread ends before the others go
};

}  // namespace crsh::viewer
