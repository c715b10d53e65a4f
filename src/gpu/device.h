#pragma once
// One Vulkan 1.3 device with one graphics and compute queue, and what of its memory is in use.

#include <vulkan/vulkan.h>

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "crsh/device.h"
#include "gpu/promises.h"
#include "gpu/tuning.h"

namespace crsh::gpu {

class Instance;
class Program;
class Transfer;
struct Kernel;

using crsh::DeviceInfo;
using crsh::DeviceRequest;
using crsh::StageLimits;

using StageValue = uint32_t StageLimits::*;

/// All of StageLimits, in words.
struct StageLimit {
  const char* name;
  const char* key;  ///< in JSON
  StageValue value;
};
inline constexpr StageLimit stage_limits[] = {
    {"storage buffers", "storage_buffers", &StageLimits::storage_buffers},
    {"storage images", "storage_images", &StageLimits::storage_images},
    {"texel buffers", "texel_buffers", &StageLimits::sampled_images},
    {"colour attachments", "colour_attachments", &StageLimits::colour_attachments},
    {"fragment resources", "fragment_resources", &StageLimits::fragment_outputs},
};

/// Limits that buffers, bindings and dispatches respect. Bytes unless said otherwise.
struct Limits {
  uint64_t max_binding = 0;        ///< maxStorageBufferRange
  uint64_t max_allocation = 0;     ///< maxMemoryAllocationSize
  uint64_t max_texels = 0;         ///< maxTexelBufferElements: texels, of any size
  uint32_t binding_alignment = 1;  ///< minStorageBufferOffsetAlignment
  uint32_t max_groups = 65535;     ///< workgroups an axis of a dispatch
  uint32_t max_image_size = 0;     ///< pixels an axis of a 2-D image or framebuffer
  double nanoseconds_per_tick = 1;
};

/// Thrown where an allocation does not fit the budget or the device; `frame` splits or reports it.
struct OutOfMemory : std::runtime_error {
  OutOfMemory(std::string name_, uint64_t needed_, uint64_t available_)
      : std::runtime_error("out of device memory (" + name_ + ")"),
        name(std::move(name_)),
        needed(needed_),
        available(available_) {}

  std::string name;        ///< of the buffer or image
  uint64_t needed = 0;     ///< bytes of device memory in all, this allocation included
  uint64_t available = 0;  ///< the budget, or 0 where the device itself refused
};

/// All devices, usable or not. Throws UserError (exit 77) where there is no Vulkan loader or no device at all.
[[nodiscard]] std::vector<DeviceInfo> list_devices();

/// Owns instance, device, queue, pipelines by name, and the sum of allocated bytes. Neither copied nor moved.
class Device {
 public:
  explicit Device(const DeviceRequest& request);
  ~Device();
  Device(const Device&) = delete;
  Device& operator=(const Device&) = delete;

  [[nodiscard]] const DeviceInfo& info() const { return info_; }
  [[nodiscard]] const Limits& limits() const { return limits_; }
  [[nodiscard]] const DeviceRequest& request() const { return request_; }
  [[nodiscard]] uint64_t allocated_bytes() const { return allocated_; }
  [[nodiscard]] uint64_t peak_bytes() const { return peak_; }
  /// Bytes that may still be allocated under the budget (UINT64_MAX without one).
  [[nodiscard]] uint64_t available_bytes() const;
  /// Another budget from here on, as in DeviceRequest; and a peak that forgets what was before.
  void set_memory_budget(uint64_t bytes) { request_.memory_budget = bytes; }
  void forget_peak() { peak_ = allocated_; }
  /// What is chosen for speed.
  [[nodiscard]] const Tuning& tuning() const { return tuning_; }
  /// Whether lanes are together again wherever the program's text says so, in loops and branches too: only there
  /// shuffles among them, and sums over them, are defined.
  [[nodiscard]] bool reconverges() const { return info_.software || promises_.reconverges; }
  /// Whether kernels may pass values between lanes.
  [[nodiscard]] bool may_shuffle() const { return info_.shuffles && reconverges() && !request_.no_shuffles; }
  /// What shader modules promise besides what they say themselves.
  [[nodiscard]] const Promises& promises() const { return promises_; }
  /// What follows the name of a kernel that comes in two builds (lib/shuffle_read.glsl): nothing where subgroups read
  /// lists together, or "-no-shuffle".
  [[nodiscard]] const char* lane_variant() const { return tuning_.share_loads && may_shuffle() ? "" : "-no-shuffle"; }
  /// Pipelines are made anew at their next use. None may be in use.
  void forget_programs();
  /// Milliseconds that the host has spent making pipelines since the last call.
  [[nodiscard]] double take_pipeline_milliseconds() { return std::exchange(pipeline_ms_, 0); }
  /// Names of the compute shaders in use: "coherence/trim.comp".
  [[nodiscard]] std::vector<std::string> programs_in_use() const;
  /// Validation messages of severity warning or error since the device was made.
  [[nodiscard]] uint64_t validation_messages() const;

  /// The compute program of this name and specialisation, made at first use.
  [[nodiscard]] const Program& program(const Kernel& kernel);

  // For the other files of gpu/ only.
  [[nodiscard]] VkDevice handle() const { return device_; }
  [[nodiscard]] VkPhysicalDevice physical() const { return physical_; }
  [[nodiscard]] VkInstance instance() const;
  [[nodiscard]] VkQueue queue() const { return queue_; }
  /// To be locked while anything is given to the queue: a window presents from another thread than the one that
  /// renders.
  [[nodiscard]] std::mutex& queue_mutex() { return queue_mutex_; }
  /// Waits until everything given to the queue is done.
  void wait_idle();
  [[nodiscard]] uint32_t queue_family() const { return queue_family_; }
  /// The one-off copies of upload_bytes and download_bytes.
  [[nodiscard]] Transfer& transfer() { return *transfer_; }
  void add_pipeline_milliseconds(double milliseconds) { pipeline_ms_ += milliseconds; }
  /// Labels for debuggers and validation messages; no-ops without validation.
  void name_object(VkObjectType type, uint64_t handle, std::string_view name) const;
  void begin_label(VkCommandBuffer commands, std::string_view name) const;
  void end_label(VkCommandBuffer commands) const;
  /// Allocates memory for `requirements`, or throws OutOfMemory. Only device memory counts: what is host-visible here
  /// is for copies, small, and on most devices no device memory.
  [[nodiscard]] VkDeviceMemory allocate(const VkMemoryRequirements& requirements, bool host_visible,
                                        std::string_view name);
  /// Frees it; `counted` is the size that was asked for, 0 for host-visible memory.
  void release(VkDeviceMemory memory, uint64_t counted);

 private:
  Device();
  void create_device();
  void load_label_functions();
  void count_memory(uint64_t bytes, uint32_t heap, std::string_view name);
  [[nodiscard]] uint32_t memory_type(uint32_t allowed, bool host_visible) const;

  DeviceRequest request_;
  DeviceInfo info_;
  Limits limits_;
  Tuning tuning_;
  Promises promises_;
  std::unique_ptr<Instance> instance_;
  VkPhysicalDevice physical_ = VK_NULL_HANDLE;
  VkDevice device_ = VK_NULL_HANDLE;
  VkQueue queue_ = VK_NULL_HANDLE;
  uint32_t queue_family_ = 0;
  VkPhysicalDeviceMemoryProperties memory_{};
  uint64_t allocated_ = 0, peak_ = 0;
  double pipeline_ms_ = 0;
  std::mutex queue_mutex_, memory_mutex_;
  PFN_vkSetDebugUtilsObjectNameEXT set_name_ = nullptr;
  PFN_vkCmdBeginDebugUtilsLabelEXT begin_label_ = nullptr;
  PFN_vkCmdEndDebugUtilsLabelEXT end_label_ = nullptr;
  std::unique_ptr<Transfer> transfer_;
  std::map<std::string, std::unique_ptr<Program>> programs_;
};

/// Throws UserError with a sentence for device lost and the like; OutOfMemory for memory. `doing` is a gerund phrase.
void check(VkResult result, const char* doing);

}  // namespace crsh::gpu
