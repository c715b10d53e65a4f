#pragma once
// Vulkan devices: what there is, and which one to open. No Vulkan header is needed.

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace crsh {

namespace gpu {
class Device;
}

/// What one stage of a pipeline binds, or may bind.
struct StageLimits {
  bool operator==(const StageLimits&) const = default;
  uint32_t storage_buffers = 0;     ///< maxPerStageDescriptorStorageBuffers
  uint32_t storage_images = 0;      ///< maxPerStageDescriptorStorageImages
  uint32_t sampled_images = 0;      ///< maxPerStageDescriptorSampledImages: texel buffers count as these
  uint32_t colour_attachments = 0;  ///< maxColorAttachments and maxFragmentOutputAttachments
  uint32_t fragment_outputs = 0;    ///< maxFragmentCombinedOutputResources: storage buffers, images and attachments
};

/// What a device says of itself; `index` is its place in `list_devices()`.
struct DeviceInfo {
  uint32_t index = 0;
  std::string name, driver, driver_version, api_version;
  std::string type;  ///< "discrete", "integrated", "virtual", "cpu" or "other"
  std::string uuid;  ///< 32 hex digits with dashes
  uint32_t subgroup_size = 0;
  bool software = false;        ///< the device is a CPU
  bool shuffles = false;        ///< compute shaders may pass values between lanes
  bool ray_queries = false;     ///< it has acceleration structures and ray queries of its own
  bool reconvergence = false;   ///< lanes that part come together again where the program says so: it promises that
  bool special_values = false;  ///< it promises that signed zeros, infinities and NaNs are kept by arithmetic
  StageLimits stage;            ///< what one stage may bind
  std::string unusable;         ///< why it cannot be used; empty when it can
};

struct DeviceRequest {
  std::string selector;        ///< index, part of the name, or UUID; empty: a real GPU before a software device
  uint64_t memory_budget = 0;  ///< bytes that all buffers and images together may take; 0: no bound
  bool validation = false;     ///< validation and synchronisation validation layers, any message is counted
  std::function<void(const std::string&)> on_validation;  ///< gets each message; none: standard error
  bool no_ray_queries = false;  ///< makes as if the device had none, to test what other devices do
  bool no_shuffles = false;     ///< lanes never read lists together by shuffles, to test what other devices do
  /// of the instance, as the window system asks for them; empty: no window
  std::vector<std::string> window_extensions;
  uint64_t max_texels = 0;      ///< as if texel buffers held no more (tests); 0: what the device says
  uint64_t first_capacity = 0;  ///< growing buffers start with so many bytes (tests); 0: what is asked for
};

/// An open device, closed when the last pointer to it goes. One thread at a time may use a device and the renderers on
/// it; another thread opens a device of its own, of the same hardware if it likes.
using DevicePtr = std::shared_ptr<gpu::Device>;

/// Throws UserError: there is no Vulkan device, none is called so, or the one that is cannot be used.
[[nodiscard]] DevicePtr open_device(const DeviceRequest& request = {});
[[nodiscard]] const DeviceInfo& info_of(const DevicePtr& device);
/// All devices, usable or not. Throws UserError (exit 77) where there is no Vulkan loader or no device at all.
[[nodiscard]] std::vector<DeviceInfo> list_devices();

}  // namespace crsh
