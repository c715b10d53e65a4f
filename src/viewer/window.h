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

/// A key that was pressed, by GLFW's number; letters and digits by their character in the person's layout ('A', '1').
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

/// Keeps the GLFW library in use; it must outlive all windows.
class WindowSystem {
 public:
  /// Throws UserError where there is no display.
  WindowSystem();
  ~WindowSystem();
  WindowSystem(const WindowSystem&) = delete;
  WindowSystem& operator=(const WindowSystem&) = delete;

  /// The Vulkan extensions that an instance needs for its windows.
  [[nodiscard]] std::vector<std::string> extensions() const;
  /// Ends a wait for events; may be called from any thread.
  static void wake();
};

/// One window with Dear ImGui's context.
class Window {
 public:
  /// Opens a window; sizes are in screen coordinates.
  Window(gpu::Device& device, const std::string& title, int width, int height);
  ~Window();
  Window(const Window&) = delete;
  Window& operator=(const Window&) = delete;

  /// Waits for events, so many seconds at most, and handles them.
  void wait(double seconds);
  [[nodiscard]] bool closing() const;
  /// The keys pressed, and the files dropped, since the last call.
  [[nodiscard]] std::vector<KeyPress> take_keys();
  [[nodiscard]] std::vector<std::string> take_drops();
  /// Whether a key is held down.
  [[nodiscard]] bool is_down(int key) const;
  [[nodiscard]] bool shift() const;

  /// Begins a frame of ImGui's; `pointer`, if any, is used in place of the real one.
  void begin_frame(const ScriptedPointer* pointer);
  /// Shows the textures, and above them what ImGui has drawn. Returns false where the window shows nothing (minimised).
  bool end_frame(std::vector<gpu::ShownTexture> textures, gpu::Screenshot* screenshot);
  /// Waits until the last frame is drawn, after which textures may change.
  void settle() { swapchain_->wait(); }

  /// Pixels for a unit of screen coordinates, and the window's size in pixels.
  [[nodiscard]] glm::vec2 pixel_scale() const;
  [[nodiscard]] glm::ivec2 pixels() const;
  /// How much larger than usual text is to be.
  [[nodiscard]] float text_scale() const { return text_scale_; }

  void set_title(const std::string& title);
  void set_size(int width, int height);
  void minimise();
  void restore();
  [[nodiscard]] bool minimised() const;
  void copy(const std::string& text);
  // For scripts: as if a person had done it.
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
