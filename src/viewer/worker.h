#pragma once
// The renderer's thread. It fulfils the last wish: coarsely while the camera moves, then in full size, sample by
// sample.

#include <atomic>
#include <condition_variable>
#include <functional>
#include <mutex>
#include <stdexcept>
#include <thread>

#include "crsh/renderer.h"
#include "gpu/device.h"
#include "viewer/job.h"
#include "viewer/pace.h"
#include "viewer/shader_folder.h"

namespace crsh::viewer {

class Worker {
 public:
  /// `wake` is called from the worker's thread whenever there is news.
  Worker(gpu::Device& device, std::function<void()> wake);
  ~Worker();
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;

  /// Returns the wish's number at once. What is being rendered for the wish before is given up, unless that was for a
  /// moving camera.
  uint64_t want(const Wish& wish);
  [[nodiscard]] News news() const;

 private:
  /// Leaves a frame that nobody wants any more.
  struct Cancelled : std::runtime_error {
    Cancelled() : std::runtime_error("the frame was cancelled") {}
  };

  void run();
  [[nodiscard]] bool take_wish();
  void fulfil();
  void load();
  void make_renderer();
  void render(bool right);
  void refine();
  void render_node_frames();
  void look_at_shaders();
  void publish(bool right, Picture picture, RenderOptions options, bool fine, double milliseconds);
  void say(const std::string& phase, double done);
  void fail(const std::string& message);
  void say_error(const std::string& message);
  [[nodiscard]] bool outdated() const;
  [[nodiscard]] bool more_to_do() const;
  [[nodiscard]] bool fulfilled() const;

  gpu::Device& device_;
  std::function<void()> wake_;

  mutable std::mutex mutex_;
  std::condition_variable changed_;
  Wish wanted_;
  News news_;
  std::atomic<uint64_t> version_ = 0;  ///< of wanted_
  std::atomic<bool> quit_ = false;

  // Used by the worker's thread only.
  Wish wish_;
  uint64_t taken_ = 0;  ///< version of wish_
  uint64_t loaded_number_ = 0, serial_ = 0;
  LoadedPtr loaded_;
  std::vector<std::string> hidden_;
  std::unique_ptr<Renderer> renderer_;
  Pace pace_;
  uint32_t samples_ = 0;  ///< that the fine picture has; 0: it is not begun
  bool right_done_ = false, has_node_frames_ = false, given_up_ = false;

  std::optional<ShaderFolder> shaders_;  ///< CRSH_SHADER_DIR
  std::chrono::steady_clock::time_point shaders_seen_{};

  std::thread thread_;
};

}  // namespace crsh::viewer
