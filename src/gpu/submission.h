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
  /// Drops what was recorded and starts anew.
  void begin();
  /// Drops what was recorded.
  void abandon() { recording_ = false; }
  /// Submits and waits. `doing` is for the error's sentence.
  void submit(const char* doing);
  /// A full memory barrier: everything written before is visible to everything after, reads by the host included.
  void barrier() const;

 private:
  Submission(Device& device, int);  ///< only the handle of the device; see device.cpp on constructors that throw
  Device& device_;
  VkCommandPool pool_ = VK_NULL_HANDLE;
  VkCommandBuffer commands_ = VK_NULL_HANDLE;
  VkFence fence_ = VK_NULL_HANDLE;
  bool recording_ = false;
};

}  // namespace crsh::gpu
