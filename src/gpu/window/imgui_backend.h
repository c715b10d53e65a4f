#pragma once
// Dear ImGui's Vulkan backend, as Debian packages it. All differences between 1.86 and 1.90 are handled here. Both
// versions need a render pass; 1.86 cannot show pictures, so the swapchain shows them.

#include <vulkan/vulkan.h>

#include "gpu/window/swapchain.h"

namespace crsh::gpu {

/// Draws Dear ImGui's current context. There may be only one at a time.
class ImguiBackend {
 public:
  /// Uploads the fonts, which the context must have by now.
  ImguiBackend(Device& device, const Swapchain& swapchain);
  ~ImguiBackend();
  ImguiBackend(const ImguiBackend&) = delete;
  ImguiBackend& operator=(const ImguiBackend&) = delete;

  /// To be called before ImGui::NewFrame().
  void begin_frame();
  /// Records what ImGui::Render() has made, within the swapchain's render pass.
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
