#include "gpu/window/imgui_backend.h"

#include <imgui.h>
#include <imgui_impl_vulkan.h>

#include "gpu/submission.h"

namespace crsh::gpu {
namespace {

constexpr uint32_t max_sets = 8;  // one for the fonts, and some to spare

void check_backend(VkResult result) { check(result, "drawing the window"); }

void start(Device& device, VkDescriptorPool pool, VkRenderPass pass) {
  ImGui_ImplVulkan_InitInfo info{};
  info.Instance = device.instance();
  info.PhysicalDevice = device.physical();
  info.Device = device.handle();
  info.QueueFamily = device.queue_family();
  info.Queue = device.queue();
  info.DescriptorPool = pool;
  info.MinImageCount = info.ImageCount = 2;  // how many buffers of vertices it keeps
  info.MSAASamples = VK_SAMPLE_COUNT_1_BIT;
  info.CheckVkResultFn = check_backend;
#if IMGUI_VERSION_NUM >= 19030  // where the render pass is a member of the info
  info.RenderPass = pass;
  ImGui_ImplVulkan_Init(&info);
#else
  ImGui_ImplVulkan_Init(&info, pass);
#endif
}

}  // namespace

ImguiBackend::ImguiBackend(Device& device) : device_(device) {}

// Calls the private constructor first, so that the destructor runs where a later step throws.
ImguiBackend::ImguiBackend(Device& device, const Swapchain& swapchain) : ImguiBackend(device) {
  make_pool();
  start(device, pool_, swapchain.render_pass());
  started_ = true;
  upload_fonts();
}

ImguiBackend::~ImguiBackend() {
  device_.wait_idle();
  if (started_) ImGui_ImplVulkan_Shutdown();
  vkDestroyDescriptorPool(device_.handle(), pool_, nullptr);
}

void ImguiBackend::make_pool() {
  const VkDescriptorPoolSize size{VK_DESCRIPTOR_TYPE_COMBINED_IMAGE_SAMPLER, max_sets};
  VkDescriptorPoolCreateInfo info{.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO};
  info.flags = VK_DESCRIPTOR_POOL_CREATE_FREE_DESCRIPTOR_SET_BIT;
  info.maxSets = max_sets;
  info.poolSizeCount = 1;
  info.pPoolSizes = &size;
  check(vkCreateDescriptorPool(device_.handle(), &info, nullptr, &pool_), "making a descriptor pool");
}

void ImguiBackend::upload_fonts() {
#if IMGUI_VERSION_NUM >= 19000  // which submits by itself
  const std::lock_guard lock(device_.queue_mutex());
  ImGui_ImplVulkan_CreateFontsTexture();
#else
  Submission submission(device_);
  submission.begin();
  ImGui_ImplVulkan_CreateFontsTexture(submission.commands());
  submission.submit("uploading the fonts");
  ImGui_ImplVulkan_DestroyFontUploadObjects();
#endif
}

void ImguiBackend::begin_frame() { ImGui_ImplVulkan_NewFrame(); }

void ImguiBackend::record(VkCommandBuffer commands) const {
  ImGui_ImplVulkan_RenderDrawData(ImGui::GetDrawData(), commands);
}

}  // namespace crsh::gpu
