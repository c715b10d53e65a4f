#pragma once
// What shaders are promised beyond plain Vulkan where the device can keep it: written into their SPIR-V as they are
// loaded, because a device that cannot keep it would refuse them.

#include <vulkan/vulkan.h>

#include <cstdint>
#include <span>
#include <vector>

#include "crsh/device.h"

namespace crsh::gpu {

struct Promises {
  /// Signed zeros, infinities and NaNs go through arithmetic as IEEE 754 has it (SignedZeroInfNanPreserve): numbers
  /// travel as bits of floats, some of which are NaNs, and bounds without end are infinite.
  bool special_values = false;
  /// Lanes that part in a branch or a loop are together again behind it (VK_KHR_shader_maximal_reconvergence).
  bool reconverges = false;
};

/// What this device can promise. `layer_version` is the validation layer's, 0 without: one that is older than an
/// extension takes a shader that names it for broken.
[[nodiscard]] Promises promises_of(const DeviceInfo& info, uint32_t layer_version);

/// The module with the execution modes that ask for it; reconvergence only where lanes speak to each other.
[[nodiscard]] std::vector<uint32_t> with_promises(std::span<const uint32_t> spirv, const Promises& promises);

/// In the chain of what a device is created with. (Debian 12's headers do not have it.)
struct ReconvergenceFeature {
  VkStructureType type = static_cast<VkStructureType>(1000434000);
  void* next = nullptr;
  VkBool32 maximal_reconvergence = VK_FALSE;
};
inline constexpr const char* reconvergence_extension = "VK_KHR_shader_maximal_reconvergence";

}  // namespace crsh::gpu
