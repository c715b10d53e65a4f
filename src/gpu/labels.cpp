// Names of objects and passes, for validation messages and debuggers.

#include "gpu/device.h"

namespace crsh::gpu {

void Device::load_label_functions() {
  set_name_ =
      reinterpret_cast<PFN_vkSetDebugUtilsObjectNameEXT>(vkGetDeviceProcAddr(device_, "vkSetDebugUtilsObjectNameEXT"));
  begin_label_ =
      reinterpret_cast<PFN_vkCmdBeginDebugUtilsLabelEXT>(vkGetDeviceProcAddr(device_, "vkCmdBeginDebugUtilsLabelEXT"));
  end_label_ =
      reinterpret_cast<PFN_vkCmdEndDebugUtilsLabelEXT>(vkGetDeviceProcAddr(device_, "vkCmdEndDebugUtilsLabelEXT"));
}

void Device::name_object(VkObjectType type, uint64_t handle, std::string_view name) const {
  if (!set_name_) return;
  const std::string text(name);
  VkDebugUtilsObjectNameInfoEXT info{.sType = VK_STRUCTURE_TYPE_DEBUG_UTILS_OBJECT_NAME_INFO_EXT};
  info.objectType = type;
  info.objectHandle = handle;
  info.pObjectName = text.c_str();
  check(set_name_(device_, &info), "naming an object");
}

void Device::begin_label(VkCommandBuffer commands, std::string_view name) const {
  if (!begin_label_) return;
  const std::string text(name);
  VkDebugUtilsLabelEXT label{.sType = VK_STRUCTURE_TYPE_DEBUG_UTILS_LABEL_EXT};
  label.pLabelName = text.c_str();
  begin_label_(commands, &label);
}

void Device::end_label(VkCommandBuffer commands) const {
  if (end_label_) end_label_(commands);
}

}  // namespace crsh::gpu
