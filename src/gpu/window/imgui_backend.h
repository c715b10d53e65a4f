#pragma once
// Dear ImGui's Vulkan backend, as Debian packages it: the one place that knows how 1.86 and 1.90 differ in it. Both
// know render passes only, and 1.86 no pictures: these are the swapchain's.

#include <vulkan/vulkan.h>

#include "gpu/window/swapchain.h"

namespace crsh::gpu {

/// Draws Dear ImGui's current context. One at a time.
class ImguiBackend {
 public:
  /// The context's fonts are there. Uploads them.
  ImguiBackend(Device& device, const Swapchain& swapchain);
  ~ImguiBackend();
  ImguiBackend(const ImguiBackend&) = delete;
  ImguiBackend& operator=(const ImguiBackend&) = delete;

  /// Before ImGui::NewFrame().
  void begin_frame();
  /// What ImGui::Render() left, within the swapchain's render pass.
  void record(VkCommandBuffer commands) const;

 private:
  ImguiBackend(Device& device);
  void make_pool();
  void upload_fonts();

  Device& device_;
  VkDescriptorPool pool_ = VK_NULL_HANDLE;
  bool started_ = false;
};

}  // namespace crsh::gpu
