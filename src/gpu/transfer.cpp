#include "gpu/transfer.h"

#include <algorithm>
#include <cstring>

namespace crsh::gpu {
namespace {

constexpr uint64_t staging_bytes = 4 << 20;

}  // namespace

const Buffer& Transfer::staging() {
  if (!staging_.handle()) staging_ = Buffer(device_, staging_bytes, "staging of the device", true);
  return staging_;
}

void Transfer::copy(VkBuffer source, uint64_t source_offset, VkBuffer target, uint64_t target_offset, uint64_t bytes) {
  submission_.begin();
  submission_.barrier();
  const VkBufferCopy region{source_offset, target_offset, bytes};
  vkCmdCopyBuffer(submission_.commands(), source, target, 1, &region);
  submission_.barrier();
  submission_.submit("copying a buffer");
}

void Transfer::upload(VkBuffer target, uint64_t offset, const void* data, uint64_t bytes) {
  const Buffer& through = staging();
  for (uint64_t done = 0; done < bytes; done += staging_bytes) {
    const uint64_t piece = std::min(staging_bytes, bytes - done);
    std::memcpy(through.mapped(), static_cast<const char*>(data) + done, piece);
    copy(through.handle(), 0, target, offset + done, piece);
  }
}

void Transfer::download(VkBuffer source, uint64_t offset, void* data, uint64_t bytes) {
  const Buffer& through = staging();
  for (uint64_t done = 0; done < bytes; done += staging_bytes) {
    const uint64_t piece = std::min(staging_bytes, bytes - done);
    copy(source, offset + done, through.handle(), 0, piece);
    std::memcpy(static_cast<char*>(data) + done, through.mapped(), piece);
  }
}

void Transfer::make_general(VkImage image, VkImageAspectFlags aspect) {
  submission_.begin();
  change_layout(submission_.commands(), image, VK_IMAGE_LAYOUT_UNDEFINED, VK_IMAGE_LAYOUT_GENERAL, aspect);
  submission_.submit("preparing an image");
}

}  // namespace crsh::gpu
