#pragma once
// A picture that is shown in the window: eight bits a channel.

#include <vulkan/vulkan.h>

#include <cstdint>
#include <span>

#include "gpu/buffer.h"
#include "gpu/submission.h"

namespace crsh::gpu {

/// RGBA bytes, rows from the top, to be scaled to the window. Written by the window's thread only.
class Texture {
 public:
  Texture(Device& device, uint32_t width, uint32_t height);
  ~Texture();
  Texture(const Texture&) = delete;
  Texture& operator=(const Texture&) = delete;

  [[nodiscard]] uint32_t width() const { return width_; }
  [[nodiscard]] uint32_t height() const { return height_; }
  /// The image, in layout TRANSFER_SRC_OPTIMAL once it is written.
  [[nodiscard]] VkImage image() const { return image_; }

  /// Writes all pixels, and waits. No frame that shows the texture may be drawing.
  void write(std::span<const uint8_t> rgba);

 private:
  Texture(Device& device, uint32_t width, uint32_t height, int);

  Device& device_;
  uint32_t width_, height_;
  Submission submission_;
  Buffer staging_;
  VkImage image_ = VK_NULL_HANDLE;
  VkDeviceMemory memory_ = VK_NULL_HANDLE;
  uint64_t counted_ = 0;
};

}  // namespace crsh::gpu
