#pragma once
// The Vulkan instance, its debug messages, and what its devices say of themselves.

#include <vulkan/vulkan.h>

#include <array>
#include <atomic>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "gpu/device.h"

namespace crsh::gpu {

/// Owns the VkInstance; with validation also the layer and the messenger that prints and counts its messages.
class Instance {
 public:
  /// `window_extensions`: what the window system asks for. `say` gets validation messages; none: standard error does.
  explicit Instance(bool validation, const std::vector<std::string>& window_extensions = {},
                    std::function<void(const std::string&)> say = {});
  ~Instance();
  Instance(const Instance&) = delete;
  Instance& operator=(const Instance&) = delete;

  [[nodiscard]] VkInstance handle() const { return instance_; }
  [[nodiscard]] uint64_t messages() const { return messages_; }
  /// The Vulkan version that the validation layer was made for; 0 without validation.
  [[nodiscard]] uint32_t layer_version() const { return layer_version_; }
  /// Counts a validation message, and says it. From any thread.
  void hear(const std::string& message);
  /// In the loader's order. Throws UserError (exit 77) where there is none.
  [[nodiscard]] std::vector<VkPhysicalDevice> devices() const;

 private:
  VkInstance instance_ = VK_NULL_HANDLE;
  uint32_t layer_version_ = 0;
  VkDebugUtilsMessengerEXT messenger_ = VK_NULL_HANDLE;
  std::function<void(const std::string&)> say_;
  std::atomic<uint64_t> messages_ = 0;
};

/// The extensions that ray queries need.
inline constexpr std::array<const char*, 3> ray_query_extensions = {VK_KHR_DEFERRED_HOST_OPERATIONS_EXTENSION_NAME,
                                                                    VK_KHR_ACCELERATION_STRUCTURE_EXTENSION_NAME,
                                                                    VK_KHR_RAY_QUERY_EXTENSION_NAME};

/// What the device says of itself, with the reason why it cannot be used, if any.
[[nodiscard]] DeviceInfo describe_device(VkPhysicalDevice physical, uint32_t index);
[[nodiscard]] bool has_extension(VkPhysicalDevice physical, const char* name);
[[nodiscard]] Limits device_limits(VkPhysicalDevice physical);
/// The first family with graphics and compute, or UINT32_MAX.
[[nodiscard]] uint32_t find_queue_family(VkPhysicalDevice physical);
/// The index of the device that `selector` means. Throws UserError where none matches or the match is unusable.
[[nodiscard]] uint32_t select_device(const std::vector<DeviceInfo>& devices, const std::string& selector);

}  // namespace crsh::gpu
