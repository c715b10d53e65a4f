#pragma once
// A VkShaderModule, which is needed only while a pipeline is made of it.

#include <vulkan/vulkan.h>

#include <string_view>

#include "gpu/device.h"

namespace crsh::gpu {

/// The module of an embedded file.
class ShaderModule {
 public:
  ShaderModule(Device& device, std::string_view file);
  ~ShaderModule();
  ShaderModule(const ShaderModule&) = delete;
  ShaderModule& operator=(const ShaderModule&) = delete;

  /// The pipeline stage that runs its main.
  [[nodiscard]] VkPipelineShaderStageCreateInfo stage(VkShaderStageFlagBits stage) const;

 private:
  Device& device_;
  VkShaderModule module_ = VK_NULL_HANDLE;
};

}  // namespace crsh::gpu
