#pragma once
// A window's surface, to which images are presented.

#include <vulkan/vulkan.h>

#include <functional>
#include <vector>

#include "gpu/device.h"

namespace crsh::gpu {

/// Owns the VkSurfaceKHR that the window system made for the instance of `device`.
class Surface {
 public:
  /// Calls `make(instance, surface)`, which the window system provides. Throws UserError where the device cannot show
  /// windows.
  Surface(Device& device, const std::function<VkResult(VkInstance, VkSurfaceKHR*)>& make);
  ~Surface();
  Surface(const Surface&) = delete;
  Surface& operator=(const Surface&) = delete;

  [[nodiscard]] VkSurfaceKHR handle() const { return surface_; }
  [[nodiscard]] VkSurfaceCapabilitiesKHR capabilities() const;
  /// A format of eight bits a channel, in which written values count as sRGB.
  [[nodiscard]] VkSurfaceFormatKHR format() const;

 private:
  Surface(Device& device);
  void require_support() const;

  Device& device_;
  VkSurfaceKHR surface_ = VK_NULL_HANDLE;
};

}  // namespace crsh::gpu
