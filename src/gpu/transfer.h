#pragma once
// Copies between host and device, done at once, through a small staging buffer.

#include <vulkan/vulkan.h>

#include <cstdint>

#include "gpu/buffer.h"
#include "gpu/submission.h"

namespace crsh::gpu {

/// Uploads and downloads of a Device, which has one of these.
class Transfer {
 public:
  explicit Transfer(Device& device) : device_(device), submission_(device) {}

  void upload(VkBuffer target, uint64_t offset, const void* data, uint64_t bytes);
  void download(VkBuffer source, uint64_t offset, void* data, uint64_t bytes);
  /// Brings an image from layout UNDEFINED to GENERAL, in which all images stay.
  void make_general(VkImage image, VkImageAspectFlags aspect);

 private:
  /// Copies one piece, no larger than the staging buffer, and waits.
  void copy(VkBuffer source, uint64_t source_offset, VkBuffer target, uint64_t target_offset, uint64_t bytes);
  [[nodiscard]] const Buffer& staging();

  Device& device_;
  Submission submission_;
  Buffer staging_;  ///< made when it is used first
};

}  // namespace crsh::gpu
