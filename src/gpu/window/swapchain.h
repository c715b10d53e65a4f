#pragma once
// The images of a window, drawn and presented one after the other.

#include <vulkan/vulkan.h>

#include <cstdint>
#include <functional>
#include <vector>

#include "gpu/buffer.h"
#include "gpu/submission.h"
#include "gpu/window/surface.h"
#include "gpu/window/texture.h"

namespace crsh::gpu {

/// What the window showed: RGB bytes, rows from the top.
struct Screenshot {
  uint32_t width = 0, height = 0;
  std::vector<uint8_t> rgb;
};

/// A rectangle of pixels; `right` and `bottom` lie outside.
struct Area {
  int32_t left = 0, top = 0, right = 0, bottom = 0;
};

/// A part of a texture, and the part of the window to which it is scaled, both in pixels.
struct ShownTexture {
  const Texture* texture = nullptr;
  Area from, to;
};

/// All that a frame of the window shows: textures on dark grey, and above them what `record` draws within the
/// swapchain's render pass.
struct WindowFrame {
  uint32_t width = 0, height = 0;  ///< of the window, pixels
  std::vector<ShownTexture> textures;
  std::function<void(VkCommandBuffer)> record;
};

/// Draws one frame at a time.
class Swapchain {
 public:
  Swapchain(Device& device, const Surface& surface);
  ~Swapchain();
  Swapchain(const Swapchain&) = delete;
  Swapchain& operator=(const Swapchain&) = delete;

  [[nodiscard]] VkRenderPass render_pass() const { return render_pass_; }
  [[nodiscard]] VkExtent2D size() const { return size_; }

  /// Draws and presents the next image. Makes new images where the window's size has changed. Returns false, and draws
  /// nothing, where the window has no pixels (minimised) or changes meanwhile. `screenshot`, if any, gets the image.
  bool draw(const WindowFrame& window, Screenshot* screenshot = nullptr);
  /// Waits until the last frame is drawn; then its textures and buffers may be freed.
  void wait();

 private:
  struct Frame {
    VkImage image = VK_NULL_HANDLE;
    VkImageView view = VK_NULL_HANDLE;
    VkFramebuffer framebuffer = VK_NULL_HANDLE;
    VkSemaphore drawn =
        VK_NULL_HANDLE;  ///< each image has one: presenting may take until after the next frame is drawn
  };

  void make_render_pass();
  [[nodiscard]] bool resize(uint32_t width, uint32_t height);
  void make_frames();
  void drop_frames();
  [[nodiscard]] bool acquire(uint32_t& index);
  void record_all(const Frame& frame, const WindowFrame& window, const Buffer* copy);
  void show(const Frame& frame, const ShownTexture& shown) const;
  void draw_above(const Frame& frame, const WindowFrame& window) const;
  void copy_out(const Frame& frame, const Buffer& pixels) const;
  void present(uint32_t index);
  void read_back(const Buffer& pixels, Screenshot& screenshot) const;

  Device& device_;
  const Surface& surface_;
  Submission submission_;
  VkSurfaceFormatKHR format_{};
  VkExtent2D size_{};
  bool stale_ = true, can_copy_ = false;
  VkSwapchainKHR swapchain_ = VK_NULL_HANDLE;
  VkRenderPass render_pass_ = VK_NULL_HANDLE;
  VkSemaphore acquired_ = VK_NULL_HANDLE;
  std::vector<Frame> frames_;
};

}  // namespace crsh::gpu
