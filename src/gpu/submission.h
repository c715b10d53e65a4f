#pragma once
// One command buffer: recorded, submitted, waited for, recorded again.

#include <vulkan/vulkan.h>

#include "gpu/device.h"

namespace crsh::gpu {

/// A command buffer with its pool and fence.
class Submission {
 public:
  explicit Submission(Device& device);
  ~Submission();
  Submission(const Submission&) = delete;
  Submission& operator=(const Submission&) = delete;

  [[nodiscard]] VkCommandBuffer commands() const { return commands_; }
  [[nodiscard]] bool recording() const { return recording_; }
  /// Drops what was recorded, and begins to record.
  void begin();
  /// Drops what was recorded.
  void abandon() { recording_ = false; }
  /// Submits and waits. An error's sentence says that it happened while `doing`.
  void submit(const char* doing);
  /// Submits without waiting: begins when `after` is signalled, if any, and signals `before` at its end.
  void send(const char* doing, VkSemaphore after = VK_NULL_HANDLE, VkSemaphore before = VK_NULL_HANDLE);
  /// Waits for what was sent, if anything.
  void wait(const char* doing);
  /// A full memory barrier: everything written before is visible to everything after, reads by the host included.
  void barrier() const;

 private:
  Submission(Device& device, int);  ///< only the handle of the device; see device.cpp on constructors that throw
  Device& device_;
  VkCommandPool pool_ = VK_NULL_HANDLE;
  VkCommandBuffer commands_ = VK_NULL_HANDLE;
  VkFence fence_ = VK_NULL_HANDLE;
  bool recording_ = false, under_way_ = false;
};

/// Brings an image from one layout to another, after all commands recorded before and before all that follow.
void change_layout(VkCommandBuffer commands, VkImage image, VkImageLayout from, VkImageLayout to,
                   VkImageAspectFlags aspect = VK_IMAGE_ASPECT_COLOR_BIT);

}  // namespace crsh::gpu
