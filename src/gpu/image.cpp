#include "gpu/image.h"

#include <string>
#include <utility>

#include "crsh/assertion.h"
#include "gpu/transfer.h"

namespace crsh::gpu {
namespace {

constexpr VkImageUsageFlags depth_usage = VK_IMAGE_USAGE_DEPTH_STENCIL_ATTACHMENT_BIT;
constexpr VkImageUsageFlags colour_usage =
    VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_STORAGE_BIT | VK_IMAGE_USAGE_TRANSFER_SRC_BIT;

VkImage create_image(Device& device, uint32_t width, uint32_t height, Format format) {
  VkImageCreateInfo info{.sType = VK_STRUCTURE_TYPE_IMAGE_CREATE_INFO};
  info.imageType = VK_IMAGE_TYPE_2D;
  info.format = vulkan_format(format);
  info.extent = {width, height, 1};
  info.mipLevels = info.arrayLayers = 1;
  info.samples = VK_SAMPLE_COUNT_1_BIT;
  info.usage = format == Format::depth32f ? depth_usage : colour_usage;
  VkImage image = VK_NULL_HANDLE;
  check(vkCreateImage(device.handle(), &info, nullptr, &image), "making an image");
  return image;
}

VkImageView create_view(Device& device, VkImage image, Format format, VkImageAspectFlags aspect) {
  VkImageViewCreateInfo info{.sType = VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO};
  info.image = image;
  info.viewType = VK_IMAGE_VIEW_TYPE_2D;
  info.format = vulkan_format(format);
  info.subresourceRange = {aspect, 0, 1, 0, 1};
  VkImageView view = VK_NULL_HANDLE;
  check(vkCreateImageView(device.handle(), &info, nullptr, &view), "making an image view");
  return view;
}

}  // namespace

VkFormat vulkan_format(Format format) {
  switch (format) {
    case Format::rgba32f: return VK_FORMAT_R32G32B32A32_SFLOAT;
    case Format::r32u: return VK_FORMAT_R32_UINT;
    case Format::depth32f: return VK_FORMAT_D32_SFLOAT;
  }
  CRSH_ASSERT(false, "a format without a name");
  return VK_FORMAT_UNDEFINED;
}

// Calls the default constructor first, so that the destructor runs where a later step throws.
Image::Image(Device& device, uint32_t width, uint32_t height, Format format, std::string_view name) : Image() {
  CRSH_ASSERT(width && height && width <= device.limits().max_image_size && height <= device.limits().max_image_size,
              "image " + std::string(name) + " is empty or larger than the device allows");
  device_ = &device;
  width_ = width, height_ = height, format_ = format;
  image_ = create_image(device, width, height, format);
  device.name_object(VK_OBJECT_TYPE_IMAGE, reinterpret_cast<uint64_t>(image_), name);
  VkMemoryRequirements requirements{};
  vkGetImageMemoryRequirements(device.handle(), image_, &requirements);
  memory_ = device.allocate(requirements, false, name);
  counted_ = requirements.size;
  check(vkBindImageMemory(device.handle(), image_, memory_, 0), "binding an image's memory");
  const VkImageAspectFlags aspect = format == Format::depth32f ? VK_IMAGE_ASPECT_DEPTH_BIT : VK_IMAGE_ASPECT_COLOR_BIT;
  view_ = create_view(device, image_, format, aspect);
  device.transfer().make_general(image_, aspect);
}

Image::~Image() {
  if (!device_) return;
  vkDestroyImageView(device_->handle(), view_, nullptr);
  vkDestroyImage(device_->handle(), image_, nullptr);
  device_->release(memory_, counted_);
}

Image& Image::operator=(Image&& other) noexcept {
  std::swap(device_, other.device_);
  std::swap(image_, other.image_);
  std::swap(view_, other.view_);
  std::swap(memory_, other.memory_);
  std::swap(counted_, other.counted_);
  std::swap(width_, other.width_);
  std::swap(height_, other.height_);
  std::swap(format_, other.format_);
  return *this;
}

}  // namespace crsh::gpu
