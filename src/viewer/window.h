#pragma once
// The window and what people do to it.

#include <cstdint>
#include <functional>
#include <glm/glm.hpp>
#include <memory>
#include <string>
#include <vector>

#include "gpu/device.h"
#include "gpu/window/imgui_backend.h"
#include "gpu/window/surface.h"
#include "gpu/window/swapchain.h"

struct GLFWwindow;

namespace crsh::viewer {

/// A key that went down, by GLFW's number (of the layout's character for letters and digits: 'A', '1').
struct KeyPress {
  int key = 0;
  bool shift = false, control = false;
};

/// The pointer as a script has it, in place of the real one.
struct ScriptedPointer {
  glm::vec2 place{0};  ///< as ImGui has it, from the upper left corner
  bool down[3] = {false, false, false};
  float wheel = 0;
  bool shift = false;
};

/// GLFW's library, from the first to the last window.
class WindowSystem {
 public:
  /// Throws UserError where there is no display.
  WindowSystem();
  ~WindowSystem();
  WindowSystem(const WindowSystem&) = delete;
  WindowSystem& operator=(const WindowSystem&) = delete;

  /// What its windows ask of a Vulkan instance.
  [[nodiscard]] std::vector<std::string> extensions() const;
  /// From any thread: ends a wait for events.
  static void wake();
};

/// One window with Dear ImGui's context.
class Window {
 public:
  /// Sizes in screen coordinates.
  Window(gpu::Device& device, const std::string& title, int width, int height);
  ~Window();
  Window(const Window&) = delete;
  Window& operator=(const Window&) = delete;

  /// Waits for events, so many seconds at most, and takes what happened.
  void wait(double seconds);
  [[nodiscard]] bool closing() const;
  /// Keys and files since the last call.
  [[nodiscard]] std::vector<KeyPress> take_keys();
  [[nodiscard]] std::vector<std::string> take_drops();
  /// Whether a key is held down.
  [[nodiscard]] bool is_down(int key) const;
  [[nodiscard]] bool shift() const;

  /// Begins a frame of ImGui's; `pointer`, if any, stands for the real one.
  void begin_frame(const ScriptedPointer* pointer);
  /// Shows textures, and above them what ImGui::Render() left. False: nothing is to be seen (minimised).
  bool end_frame(std::vector<gpu::ShownTexture> textures, gpu::Screenshot* screenshot);
  /// The last frame is drawn: textures may change.
  void settle() { swapchain_->wait(); }

  /// Pixels a unit of screen coordinates; and of the window.
  [[nodiscard]] glm::vec2 pixel_scale() const;
  [[nodiscard]] glm::ivec2 pixels() const;
  /// How much larger than usual text is.
  [[nodiscard]] float text_scale() const { return text_scale_; }

  void set_title(const std::string& title);
  void set_size(int width, int height);
  void minimise();
  void restore();
  [[nodiscard]] bool minimised() const;
  void copy(const std::string& text);
  // As if it had happened.
  void press(const KeyPress& key) { keys_.push_back(key); }
  void hold(int key) { held_ = key; }
  void drop(const std::string& path) { drops_.push_back(path); }

 private:
  struct CloseWindow {
    void operator()(GLFWwindow* window) const;
  };
  struct ImguiContext {
    explicit ImguiContext(GLFWwindow* window, float scale);
    ~ImguiContext();
  };
  void listen();

  gpu::Device& device_;
  std::unique_ptr<GLFWwindow, CloseWindow> window_;
  std::vector<KeyPress> keys_;
  std::vector<std::string> drops_;
  float text_scale_ = 1;
  bool scripted_shift_ = false;
  int held_ = 0;  ///< a key that a script holds down
  std::unique_ptr<gpu::Surface> surface_;
  std::unique_ptr<gpu::Swapchain> swapchain_;
  std::unique_ptr<ImguiContext> imgui_;
  std::unique_ptr<gpu::ImguiBackend> backend_;
};

}  // namespace crsh::viewer
