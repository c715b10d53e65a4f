// VkResults as sentences.

#include "crsh/error.h"
#include "gpu/device.h"

namespace crsh::gpu {
namespace {

std::string text(VkResult result) {
  switch (result) {
    case VK_ERROR_INITIALIZATION_FAILED: return "the driver could not be initialised";
    case VK_ERROR_LAYER_NOT_PRESENT: return "a Vulkan layer is missing";
    case VK_ERROR_EXTENSION_NOT_PRESENT: return "a Vulkan extension is missing";
    case VK_ERROR_FEATURE_NOT_PRESENT: return "the device lacks a feature";
    case VK_ERROR_INCOMPATIBLE_DRIVER: return "no driver fits";
    case VK_ERROR_TOO_MANY_OBJECTS: return "the driver allows no more objects";
    case VK_ERROR_FORMAT_NOT_SUPPORTED: return "the device does not support the image format";
    case VK_ERROR_SURFACE_LOST_KHR: return "the window's surface was lost";
    default: return "Vulkan error " + std::to_string(result);
  }
}

}  // namespace

void check(VkResult result, const char* doing) {
  if (result >= 0) return;
  if (result == VK_ERROR_OUT_OF_DEVICE_MEMORY || result == VK_ERROR_OUT_OF_HOST_MEMORY) throw OutOfMemory(doing, 0, 0);
  if (result == VK_ERROR_DEVICE_LOST)
    throw UserError(std::string("the device was lost while ") + doing +
                        ", most likely because one submit took longer than the driver allows",
                    Mend::less_work);
  throw UserError(std::string(doing) + " failed: " + text(result));
}

}  // namespace crsh::gpu
