#include "gpu/window/surface.h"

#include <array>

#include "crsh/error.h"

namespace crsh::gpu {

Surface::Surface(Device& device) : device_(device) {}

// Calls the private constructor first, so that the destructor runs where a later step throws.
Surface::Surface(Device& device, const std::function<VkResult(VkInstance, VkSurfaceKHR*)>& make) : Surface(device) {
  check(make(device.instance(), &surface_), "making the window's surface");
  require_support();
}

Surface::~Surface() { vkDestroySurfaceKHR(device_.instance(), surface_, nullptr); }

void Surface::require_support() const {
  VkBool32 supported = VK_FALSE;
  check(vkGetPhysicalDeviceSurfaceSupportKHR(device_.physical(), device_.queue_family(), surface_, &supported),
        "asking for the window's surface");
  if (!supported) throw UserError(device_.info().name + " cannot show windows here", Mend::other_device);
}

VkSurfaceCapabilitiesKHR Surface::capabilities() const {
  VkSurfaceCapabilitiesKHR capabilities{};
  check(vkGetPhysicalDeviceSurfaceCapabilitiesKHR(device_.physical(), surface_, &capabilities),
        "asking for the window's size");
  return capabilities;
}

VkSurfaceFormatKHR Surface::format() const {
  uint32_t count = 0;
  check(vkGetPhysicalDeviceSurfaceFormatsKHR(device_.physical(), surface_, &count, nullptr),
        "asking for the window's colours");
  std::vector<VkSurfaceFormatKHR> formats(count);
  check(vkGetPhysicalDeviceSurfaceFormatsKHR(device_.physical(), surface_, &count, formats.data()),
        "asking for the window's colours");
  constexpr std::array wanted = {VK_FORMAT_B8G8R8A8_UNORM, VK_FORMAT_R8G8B8A8_UNORM};
  for (const VkFormat format : wanted)
    for (const VkSurfaceFormatKHR& offered : formats)
      if (offered.format == format && offered.colorSpace == VK_COLOR_SPACE_SRGB_NONLINEAR_KHR) return offered;
  throw UserError(device_.info().name + " offers no window of eight bits a channel", Mend::other_device);
}

}  // namespace crsh::gpu
