#include "gpu/window/swapchain.h"

#include <algorithm>

#include "crsh/error.h"

namespace crsh::gpu {
namespace {

/// For errors' sentences.
constexpr const char* drawing = "drawing the window";

constexpr VkClearColorValue dark_grey = {.float32 = {0.09f, 0.09f, 0.1f, 1}};

VkSemaphore make_semaphore(Device& device) {
  const VkSemaphoreCreateInfo info{.sType = VK_STRUCTURE_TYPE_SEMAPHORE_CREATE_INFO};
  VkSemaphore semaphore = VK_NULL_HANDLE;
  check(vkCreateSemaphore(device.handle(), &info, nullptr, &semaphore), "making a semaphore");
  return semaphore;
}

uint32_t image_count_of(const VkSurfaceCapabilitiesKHR& capabilities) {
  const uint32_t wanted = std::max(capabilities.minImageCount + 1, 2u);
  return capabilities.maxImageCount ? std::min(wanted, capabilities.maxImageCount) : wanted;
}

VkImageView make_view(Device& device, VkImage image, VkFormat format) {
  VkImageViewCreateInfo info{.sType = VK_STRUCTURE_TYPE_IMAGE_VIEW_CREATE_INFO};
  info.image = image;
  info.viewType = VK_IMAGE_VIEW_TYPE_2D;
  info.format = format;
  info.subresourceRange = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, 1};
  VkImageView view = VK_NULL_HANDLE;
  check(vkCreateImageView(device.handle(), &info, nullptr, &view), "making a view of the window");
  return view;
}

/// Swaps red and blue where the window has them the other way round, and drops alpha.
void append_pixel(std::vector<uint8_t>& rgb, const uint8_t* pixel, bool blue_first) {
  rgb.push_back(pixel[blue_first ? 2 : 0]);
  rgb.push_back(pixel[1]);
  rgb.push_back(pixel[blue_first ? 0 : 2]);
}

}  // namespace

Swapchain::Swapchain(Device& device, const Surface& surface)
    : device_(device), surface_(surface), submission_(device), format_(surface.format()) {
  make_render_pass();
  acquired_ = make_semaphore(device);
}

Swapchain::~Swapchain() {
  device_.wait_idle();
  drop_frames();
  vkDestroySwapchainKHR(device_.handle(), swapchain_, nullptr);
  vkDestroySemaphore(device_.handle(), acquired_, nullptr);
  vkDestroyRenderPass(device_.handle(), render_pass_, nullptr);
}

void Swapchain::make_render_pass() {
  VkAttachmentDescription colour{};
  colour.format = format_.format;
  colour.samples = VK_SAMPLE_COUNT_1_BIT;
  colour.loadOp = VK_ATTACHMENT_LOAD_OP_LOAD;
  colour.storeOp = VK_ATTACHMENT_STORE_OP_STORE;
  colour.stencilLoadOp = VK_ATTACHMENT_LOAD_OP_DONT_CARE;
  colour.stencilStoreOp = VK_ATTACHMENT_STORE_OP_DONT_CARE;
  colour.initialLayout = VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL;
  colour.finalLayout = VK_IMAGE_LAYOUT_PRESENT_SRC_KHR;
  const VkAttachmentReference reference{0, VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL};
  VkSubpassDescription subpass{};
  subpass.pipelineBindPoint = VK_PIPELINE_BIND_POINT_GRAPHICS;
  subpass.colorAttachmentCount = 1;
  subpass.pColorAttachments = &reference;
  VkRenderPassCreateInfo info{.sType = VK_STRUCTURE_TYPE_RENDER_PASS_CREATE_INFO};
  info.attachmentCount = info.subpassCount = 1;
  info.pAttachments = &colour;
  info.pSubpasses = &subpass;
  check(vkCreateRenderPass(device_.handle(), &info, nullptr, &render_pass_), "making a render pass");
}

bool Swapchain::resize(uint32_t width, uint32_t height) {
  const VkSurfaceCapabilitiesKHR capabilities = surface_.capabilities();
  VkExtent2D wanted = capabilities.currentExtent;
  if (wanted.width == UINT32_MAX)
    wanted = {std::clamp(width, capabilities.minImageExtent.width, capabilities.maxImageExtent.width),
              std::clamp(height, capabilities.minImageExtent.height, capabilities.maxImageExtent.height)};
  if (wanted.width == 0 || wanted.height == 0) return false;
  if (!stale_ && wanted.width == size_.width && wanted.height == size_.height) return true;
  device_.wait_idle();
  drop_frames();
  can_copy_ = capabilities.supportedUsageFlags & VK_IMAGE_USAGE_TRANSFER_SRC_BIT;
  VkSwapchainCreateInfoKHR info{.sType = VK_STRUCTURE_TYPE_SWAPCHAIN_CREATE_INFO_KHR};
  info.surface = surface_.handle();
  info.minImageCount = image_count_of(capabilities);
  info.imageFormat = format_.format;
  info.imageColorSpace = format_.colorSpace;
  info.imageExtent = wanted;
  info.imageArrayLayers = 1;
  info.imageUsage = VK_IMAGE_USAGE_COLOR_ATTACHMENT_BIT | VK_IMAGE_USAGE_TRANSFER_DST_BIT |
                    (can_copy_ ? VK_IMAGE_USAGE_TRANSFER_SRC_BIT : 0);
  info.preTransform = capabilities.currentTransform;
  info.compositeAlpha = VK_COMPOSITE_ALPHA_OPAQUE_BIT_KHR;
  info.presentMode = VK_PRESENT_MODE_FIFO_KHR;
  info.clipped = VK_TRUE;
  info.oldSwapchain = swapchain_;
  VkSwapchainKHR made = VK_NULL_HANDLE;
  check(vkCreateSwapchainKHR(device_.handle(), &info, nullptr, &made), "making the window's images");
  vkDestroySwapchainKHR(device_.handle(), swapchain_, nullptr);
  swapchain_ = made;
  size_ = wanted;
  make_frames();
  stale_ = false;
  return true;
}

void Swapchain::make_frames() {
  uint32_t count = 0;
  check(vkGetSwapchainImagesKHR(device_.handle(), swapchain_, &count, nullptr), "listing the window's images");
  std::vector<VkImage> images(count);
  check(vkGetSwapchainImagesKHR(device_.handle(), swapchain_, &count, images.data()), "listing the window's images");
  for (const VkImage image : images) {
    Frame& frame = frames_.emplace_back(Frame{.image = image});
    frame.view = make_view(device_, image, format_.format);
    frame.drawn = make_semaphore(device_);
    VkFramebufferCreateInfo info{.sType = VK_STRUCTURE_TYPE_FRAMEBUFFER_CREATE_INFO};
    info.renderPass = render_pass_;
    info.attachmentCount = 1;
    info.pAttachments = &frame.view;
    info.width = size_.width;
    info.height = size_.height;
    info.layers = 1;
    check(vkCreateFramebuffer(device_.handle(), &info, nullptr, &frame.framebuffer), "making a framebuffer");
  }
}

void Swapchain::drop_frames() {
  for (const Frame& frame : frames_) {
    vkDestroyFramebuffer(device_.handle(), frame.framebuffer, nullptr);
    vkDestroyImageView(device_.handle(), frame.view, nullptr);
    vkDestroySemaphore(device_.handle(), frame.drawn, nullptr);
  }
  frames_.clear();
}

void Swapchain::wait() { submission_.wait(drawing); }

bool Swapchain::acquire(uint32_t& index) {
  const VkResult result =
      vkAcquireNextImageKHR(device_.handle(), swapchain_, UINT64_MAX, acquired_, VK_NULL_HANDLE, &index);
  if (result == VK_SUBOPTIMAL_KHR) stale_ = true;
  if (result == VK_ERROR_OUT_OF_DATE_KHR) return stale_ = true, false;
  check(result, "taking an image of the window");
  return true;
}

void Swapchain::record_all(const Frame& frame, const WindowFrame& window, const Buffer* copy) {
  submission_.begin();
  const VkCommandBuffer commands = submission_.commands();
  change_layout(commands, frame.image, VK_IMAGE_LAYOUT_UNDEFINED, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL);
  const VkImageSubresourceRange whole{VK_IMAGE_ASPECT_COLOR_BIT, 0, 1, 0, 1};
  vkCmdClearColorImage(commands, frame.image, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, &dark_grey, 1, &whole);
  change_layout(commands, frame.image, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL);
  for (const ShownTexture& shown : window.textures) show(frame, shown);
  change_layout(commands, frame.image, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, VK_IMAGE_LAYOUT_COLOR_ATTACHMENT_OPTIMAL);
  draw_above(frame, window);
  if (copy) copy_out(frame, *copy);
}

/// Shows the part of it that lies inside the window.
void Swapchain::show(const Frame& frame, const ShownTexture& shown) const {
  const Area& from = shown.from;
  const Area& to = shown.to;
  const bool inside =
      to.left >= 0 && to.top >= 0 && to.right <= int32_t(size_.width) && to.bottom <= int32_t(size_.height);
  if (!inside || to.left >= to.right || to.top >= to.bottom || from.left >= from.right || from.top >= from.bottom)
    return;
  VkImageBlit region{};
  region.srcSubresource = region.dstSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1};
  region.srcOffsets[0] = {from.left, from.top, 0};
  region.srcOffsets[1] = {from.right, from.bottom, 1};
  region.dstOffsets[0] = {to.left, to.top, 0};
  region.dstOffsets[1] = {to.right, to.bottom, 1};
  const bool same = to.right - to.left == from.right - from.left && to.bottom - to.top == from.bottom - from.top;
  vkCmdBlitImage(submission_.commands(), shown.texture->image(), VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, frame.image,
                 VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL, 1, &region, same ? VK_FILTER_NEAREST : VK_FILTER_LINEAR);
  change_layout(submission_.commands(), frame.image, VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL,
                VK_IMAGE_LAYOUT_TRANSFER_DST_OPTIMAL);
}

void Swapchain::draw_above(const Frame& frame, const WindowFrame& window) const {
  VkRenderPassBeginInfo pass{.sType = VK_STRUCTURE_TYPE_RENDER_PASS_BEGIN_INFO};
  pass.renderPass = render_pass_;
  pass.framebuffer = frame.framebuffer;
  pass.renderArea.extent = size_;
  vkCmdBeginRenderPass(submission_.commands(), &pass, VK_SUBPASS_CONTENTS_INLINE);
  window.record(submission_.commands());
  vkCmdEndRenderPass(submission_.commands());
}

void Swapchain::copy_out(const Frame& frame, const Buffer& pixels) const {
  change_layout(submission_.commands(), frame.image, VK_IMAGE_LAYOUT_PRESENT_SRC_KHR,
                VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL);
  VkBufferImageCopy region{};
  region.imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1};
  region.imageExtent = {size_.width, size_.height, 1};
  vkCmdCopyImageToBuffer(submission_.commands(), frame.image, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL, pixels.handle(), 1,
                         &region);
  change_layout(submission_.commands(), frame.image, VK_IMAGE_LAYOUT_TRANSFER_SRC_OPTIMAL,
                VK_IMAGE_LAYOUT_PRESENT_SRC_KHR);
}

void Swapchain::present(uint32_t index) {
  VkPresentInfoKHR info{.sType = VK_STRUCTURE_TYPE_PRESENT_INFO_KHR};
  info.waitSemaphoreCount = info.swapchainCount = 1;
  info.pWaitSemaphores = &frames_[index].drawn;
  info.pSwapchains = &swapchain_;
  info.pImageIndices = &index;
  const std::lock_guard lock(device_.queue_mutex());
  const VkResult result = vkQueuePresentKHR(device_.queue(), &info);
  if (result == VK_ERROR_OUT_OF_DATE_KHR || result == VK_SUBOPTIMAL_KHR) stale_ = true;
  else check(result, "showing the window");
}

void Swapchain::read_back(const Buffer& pixels, Screenshot& screenshot) const {
  screenshot = {size_.width, size_.height, {}};
  const auto* bytes = static_cast<const uint8_t*>(pixels.mapped());
  const bool blue_first = format_.format == VK_FORMAT_B8G8R8A8_UNORM;
  for (size_t pixel = 0; pixel < size_t(size_.width) * size_.height; ++pixel)
    append_pixel(screenshot.rgb, bytes + 4 * pixel, blue_first);
}

bool Swapchain::draw(const WindowFrame& window, Screenshot* screenshot) {
  wait();
  uint32_t index = 0;
  if (!resize(window.width, window.height) || !acquire(index)) return false;
  if (screenshot && !can_copy_)
    throw UserError("the window of " + device_.info().name + " cannot be read", Mend::other_device);
  Buffer pixels;
  if (screenshot) pixels = Buffer(device_, uint64_t(size_.width) * size_.height * 4, "screenshot", true);
  record_all(frames_[index], window, screenshot ? &pixels : nullptr);
  submission_.send(drawing, acquired_, frames_[index].drawn);
  present(index);
  if (screenshot) wait(), read_back(pixels, *screenshot);
  return true;
}

}  // namespace crsh::gpu
