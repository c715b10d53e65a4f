#include "gpu/window/texture.h"

#include <cstring>

#include "crsh/assertion.h"

namespace crsh::gpu {

Texture::Texture(Device& device, uint32_t width, uint32_t height, int)
    : device_(device),
      width_(width),
      height_(height),
      submission_(device),
      staging_(device, uint64_t(width) * height * 4, "staging of a texture", true) {}

// Calls the private constructor first, so that the destructor runs where a later step throws.
Texture::Texture(Device& device, uint32_t width, uint32_t height) : Texture(device, width, height, 0) {
  VkImageCreateInfo info{.sType = VK_STRUCTURE_TYPE_IMAGE_CREATE_INFO};
  info.imageType = VK_IMAGE_TYPE_2D;
  info.format = VK_FORMAT_R8G8B8A8_UNORM;
  info.extent = {width, height, 1};
  info.mipLevels = info.arrayLayers = 1;
  info.samples = VK_SAMPLE_COUNT_1_BIT;
  info.usage = VK_IMAGE_USAGE_TRANSFER_SRC_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT;
  check(vkCreateImage(device.handle(), &info, nullptr, &image_), "making a texture");
  VkMemoryRequirements requirements{};
  vkGetImageMemoryRequirements(device.handle(), image_, &requirements);
  memory_ = device.allocate(requirements, false, "texture");
  counted_ = requirements.size;
  check(vkBindImageMemory(device.handle(), image_, memory_, 0), "binding a texture's memory");
}

Texture::~Texture() {
  vkDestroyImage(device_.handle(), image_, nullptr);
  device_.release(memory_, counted_);
}

void Texture::write(std::span<const uint8_t> rgba) {
  CRSH_ASSERT(rgba.size() == size_t(width_) * height_ * 4, "pixels of another size");
  std::memcpy(staging_.mapped(), rgba.data(), rgba.size());
  submission_.begin();
  change_layout(submission_.commands(), image_, VK_IMAGE_LAYOUT_UNDEFINED, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL);
  VkBufferImageCopy region{};
  region.imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1};
  region.imageExtent = {width_, height_, 1};
  vkCmdCopyBufferToImage(submission_.commands(), staging_.handle(), image_, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, 1,
                         &region);
  change_layout(submission_.commands(), image_, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL,
                VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL);
  submission_.submit("writing a texture");
}

}  // namespace crsh::gpu
