#pragma once
// A 2-D image to draw into and to read as a storage image.

#include <vulkan/vulkan.h>

#include <cstdint>
#include <string_view>

#include "gpu/device.h"

namespace crsh::gpu {

enum class Format { rgba32f, r32u, depth32f };

/// The format's name in Vulkan.
[[nodiscard]] VkFormat vulkan_format(Format format);

/// Move-only. Always in layout GENERAL. Colour formats can be attachments, storage images and transfer sources; depth
/// is an attachment only.
class Image {
 public:
  Image() = default;
  Image(Device& device, uint32_t width, uint32_t height, Format format, std::string_view name);
  ~Image();
  Image(Image&& other) noexcept { *this = std::move(other); }
  Image& operator=(Image&& other) noexcept;

  [[nodiscard]] uint32_t width() const { return width_; }
  [[nodiscard]] uint32_t height() const { return height_; }
  [[nodiscard]] Format format() const { return format_; }
  [[nodiscard]] VkImage handle() const { return image_; }
  [[nodiscard]] VkImageView view() const { return view_; }

 private:
  Device* device_ = nullptr;
  VkImage image_ = VK_NULL_HANDLE;
  VkImageView view_ = VK_NULL_HANDLE;
  VkDeviceMemory memory_ = VK_NULL_HANDLE;
  uint64_t counted_ = 0;
  uint32_t width_ = 0, height_ = 0;
  Format format_ = Format::rgba32f;
};

}  // namespace crsh::gpu
