// What a device says of itself, and what it lacks.

#include <algorithm>
#include <array>
#include <cstdio>
#include <cstring>

#include "gpu/instance.h"
#include "gpu/needs.h"
#include "gpu/promises.h"

namespace crsh::gpu {
namespace {

/// All that is queried of a physical device, in one chain of structs.
struct Properties {
  VkPhysicalDeviceProperties2 core{.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2};
  VkPhysicalDeviceVulkan11Properties v11{.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_1_PROPERTIES};
  VkPhysicalDeviceVulkan12Properties v12{.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_2_PROPERTIES};
  VkPhysicalDeviceVulkan13Properties v13{.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_3_PROPERTIES};

  explicit Properties(VkPhysicalDevice physical) {
    core.pNext = &v11, v11.pNext = &v12, v12.pNext = &v13;
    vkGetPhysicalDeviceProperties2(physical, &core);
  }
  Properties(const Properties&) = delete;  // the chain points into the object
};

std::string version_text(uint32_t version) {
  return std::to_string(VK_API_VERSION_MAJOR(version)) + "." + std::to_string(VK_API_VERSION_MINOR(version)) + "." +
         std::to_string(VK_API_VERSION_PATCH(version));
}

std::string uuid_text(const uint8_t (&bytes)[VK_UUID_SIZE]) {
  std::string text;
  for (size_t i = 0; i < VK_UUID_SIZE; ++i) {
    char digits[3];
    std::snprintf(digits, sizeof digits, "%02x", bytes[i]);
    text += (i == 4 || i == 6 || i == 8 || i == 10) ? std::string("-") + digits : digits;
  }
  return text;
}

const char* type_text(VkPhysicalDeviceType type) {
  switch (type) {
    case VK_PHYSICAL_DEVICE_TYPE_DISCRETE_GPU: return "discrete";
    case VK_PHYSICAL_DEVICE_TYPE_INTEGRATED_GPU: return "integrated";
    case VK_PHYSICAL_DEVICE_TYPE_VIRTUAL_GPU: return "virtual";
    case VK_PHYSICAL_DEVICE_TYPE_CPU: return "cpu";
    default: return "other";
  }
}

bool can(VkPhysicalDevice physical, VkFormat format, VkFormatFeatureFlags wanted) {
  VkFormatProperties properties{};
  vkGetPhysicalDeviceFormatProperties(physical, format, &properties);
  return (properties.optimalTilingFeatures & wanted) == wanted;
}

const char* missing_feature(VkPhysicalDevice physical) {
  VkPhysicalDeviceVulkan13Features v13{.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_3_FEATURES};
  VkPhysicalDeviceVulkan12Features v12{.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_2_FEATURES};
  VkPhysicalDeviceFeatures2 features{.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FEATURES_2};
  v12.pNext = &v13, features.pNext = &v12;
  vkGetPhysicalDeviceFeatures2(physical, &features);
  if (!v12.scalarBlockLayout) return "it has no scalar block layout";
  if (!v13.synchronization2) return "it has no synchronization2";
  if (!v13.dynamicRendering) return "it has no dynamic rendering";
  if (!v13.computeFullSubgroups) return "it has no full subgroups";
  if (!can(physical, VK_FORMAT_D32_SFLOAT, VK_FORMAT_FEATURE_DEPTH_STENCIL_ATTACHMENT_BIT))
    return "it has no 32-bit depth";
  return nullptr;
}

bool has_ray_queries(VkPhysicalDevice physical) {
  for (const char* wanted : ray_query_extensions)
    if (!has_extension(physical, wanted)) return false;
  VkPhysicalDeviceRayQueryFeaturesKHR queries{.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_RAY_QUERY_FEATURES_KHR};
  VkPhysicalDeviceAccelerationStructureFeaturesKHR structures{
      .sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_ACCELERATION_STRUCTURE_FEATURES_KHR};
  VkPhysicalDeviceVulkan12Features v12{.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_2_FEATURES};
  VkPhysicalDeviceFeatures2 features{.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FEATURES_2};
  structures.pNext = &queries, v12.pNext = &structures, features.pNext = &v12;
  vkGetPhysicalDeviceFeatures2(physical, &features);
  return v12.bufferDeviceAddress && structures.accelerationStructure && queries.rayQuery;
}

bool has_reconvergence(VkPhysicalDevice physical) {
  if (!has_extension(physical, reconvergence_extension)) return false;
  ReconvergenceFeature feature;
  VkPhysicalDeviceFeatures2 features{.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_FEATURES_2};
  features.pNext = &feature;
  vkGetPhysicalDeviceFeatures2(physical, &features);
  return feature.maximal_reconvergence;
}

StageLimits stage_limits_of(const VkPhysicalDeviceLimits& limits) {
  StageLimits out;
  out.storage_buffers = limits.maxPerStageDescriptorStorageBuffers;
  out.storage_images = limits.maxPerStageDescriptorStorageImages;
  out.sampled_images = limits.maxPerStageDescriptorSampledImages;
  out.colour_attachments = std::min(limits.maxColorAttachments, limits.maxFragmentOutputAttachments);
  out.fragment_outputs = limits.maxFragmentCombinedOutputResources;
  return out;
}

/// Why the device cannot be used, or an empty text. `core` alone is valid below Vulkan 1.3.
std::string missing(VkPhysicalDevice physical, const VkPhysicalDeviceProperties& core) {
  if (core.apiVersion < VK_API_VERSION_1_3) return "it has Vulkan " + version_text(core.apiVersion) + ", 1.3 is needed";
  if (find_queue_family(physical) == UINT32_MAX) return "it has no queue for both graphics and compute";
  if (const char* feature = missing_feature(physical)) return feature;
  const Properties properties(physical);
  constexpr VkSubgroupFeatureFlags wanted =
      VK_SUBGROUP_FEATURE_BASIC_BIT | VK_SUBGROUP_FEATURE_BALLOT_BIT | VK_SUBGROUP_FEATURE_ARITHMETIC_BIT;
  const bool subgroups = (properties.v11.subgroupSupportedOperations & wanted) == wanted &&
                         (properties.v11.subgroupSupportedStages & VK_SHADER_STAGE_COMPUTE_BIT);
  if (!subgroups) return "its compute shaders have no subgroup ballot and arithmetic";
  return too_few(stage_limits_of(core.limits), max_needed());
}

}  // namespace

bool has_extension(VkPhysicalDevice physical, const char* name) {
  uint32_t count = 0;
  vkEnumerateDeviceExtensionProperties(physical, nullptr, &count, nullptr);
  std::vector<VkExtensionProperties> extensions(count);
  vkEnumerateDeviceExtensionProperties(physical, nullptr, &count, extensions.data());
  return std::ranges::any_of(extensions, [&](const auto& e) { return std::strcmp(e.extensionName, name) == 0; });
}

uint32_t find_queue_family(VkPhysicalDevice physical) {
  uint32_t count = 0;
  vkGetPhysicalDeviceQueueFamilyProperties(physical, &count, nullptr);
  std::vector<VkQueueFamilyProperties> families(count);
  vkGetPhysicalDeviceQueueFamilyProperties(physical, &count, families.data());
  constexpr VkQueueFlags wanted = VK_QUEUE_GRAPHICS_BIT | VK_QUEUE_COMPUTE_BIT;
  for (uint32_t i = 0; i < count; ++i)
    if ((families[i].queueFlags & wanted) == wanted) return i;
  return UINT32_MAX;
}

DeviceInfo describe_device(VkPhysicalDevice physical, uint32_t index) {
  const Properties all(physical);
  const VkPhysicalDeviceProperties& core = all.core.properties;
  DeviceInfo info;
  info.index = index;
  info.name = core.deviceName;
  info.driver = all.v12.driverName;
  info.driver_version = all.v12.driverInfo[0] ? all.v12.driverInfo : version_text(core.driverVersion);
  info.api_version = version_text(core.apiVersion);
  info.type = type_text(core.deviceType);
  info.uuid = uuid_text(all.v11.deviceUUID);
  info.subgroup_size = all.v11.subgroupSize;
  info.shuffles = all.v11.subgroupSupportedOperations & VK_SUBGROUP_FEATURE_SHUFFLE_BIT;
  info.software = core.deviceType == VK_PHYSICAL_DEVICE_TYPE_CPU;
  info.stage = stage_limits_of(core.limits);
  info.unusable = missing(physical, core);
  info.ray_queries = info.unusable.empty() && has_ray_queries(physical);
  info.reconvergence = info.unusable.empty() && has_reconvergence(physical);
  info.special_values = info.unusable.empty() && all.v12.shaderSignedZeroInfNanPreserveFloat32;
  return info;
}

Limits device_limits(VkPhysicalDevice physical) {
  const Properties all(physical);
  const VkPhysicalDeviceLimits& core = all.core.properties.limits;
  Limits limits;
  limits.max_binding = core.maxStorageBufferRange;
  limits.max_allocation = std::min(all.v11.maxMemoryAllocationSize, all.v13.maxBufferSize);
  limits.max_texels = core.maxTexelBufferElements;
  limits.binding_alignment = static_cast<uint32_t>(core.minStorageBufferOffsetAlignment);
  limits.max_groups = std::min(core.maxComputeWorkGroupCount[0], core.maxComputeWorkGroupCount[1]);
  limits.max_image_size = std::min({core.maxImageDimension2D, core.maxFramebufferWidth, core.maxFramebufferHeight});
  limits.nanoseconds_per_tick = static_cast<double>(core.timestampPeriod);
  return limits;
}

}  // namespace crsh::gpu
