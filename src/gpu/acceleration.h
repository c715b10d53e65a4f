#pragma once
// The device's own hierarchy over triangles (VK_KHR_acceleration_structure), for devices with ray queries.

#include <vulkan/vulkan.h>

#include <cstdint>

#include "gpu/buffer.h"
#include "gpu/device.h"

namespace crsh::gpu {

/// One bottom level over a list of triangles, and a top level with one instance of it. To be made only on devices whose
/// info has ray_queries; this is not checked here.
class AccelerationStructure {
 public:
  /// Has room for so many triangles, 1 at least. Throws OutOfMemory.
  AccelerationStructure(Device& device, uint32_t triangles);
  ~AccelerationStructure();
  AccelerationStructure(const AccelerationStructure&) = delete;
  AccelerationStructure& operator=(const AccelerationStructure&) = delete;

  /// The top level.
  [[nodiscard]] VkAccelerationStructureKHR handle() const { return top_.structure; }

  // For Recorder only.
  /// Builds it over `corners`, three vec4 a triangle. Calls `barrier` between steps that must not overlap.
  template <class Barrier>
  void record(VkCommandBuffer commands, const Buffer& corners, const Barrier& barrier) {
    record_bottom(commands, corners);
    barrier();
    record_top(commands);
    barrier();
  }

 private:
  struct Level {
    Buffer memory, scratch;
    VkAccelerationStructureKHR structure = VK_NULL_HANDLE;
  };

  void load_functions();
  void make(Level& level, VkAccelerationStructureTypeKHR type, const VkAccelerationStructureGeometryKHR& geometry,
            uint32_t count, const char* name);
  void record(VkCommandBuffer commands, const Level& level, VkAccelerationStructureTypeKHR type,
              const VkAccelerationStructureGeometryKHR& geometry, uint32_t count) const;
  void record_bottom(VkCommandBuffer commands, const Buffer& corners) const;
  void record_top(VkCommandBuffer commands) const;
  [[nodiscard]] VkDeviceAddress address(const Buffer& buffer) const;
  [[nodiscard]] VkAccelerationStructureGeometryKHR triangles_of(VkDeviceAddress corners) const;
  [[nodiscard]] VkAccelerationStructureGeometryKHR instance_of() const;
  void write_instance();

  Device& device_;
  uint32_t triangles_;
  uint32_t scratch_alignment_ = 1;
  Level bottom_, top_;
  Buffer instance_;
  PFN_vkCreateAccelerationStructureKHR create_ = nullptr;
  PFN_vkDestroyAccelerationStructureKHR destroy_ = nullptr;
  PFN_vkGetAccelerationStructureBuildSizesKHR sizes_ = nullptr;
  PFN_vkCmdBuildAccelerationStructuresKHR build_ = nullptr;
  PFN_vkGetAccelerationStructureDeviceAddressKHR structure_address_ = nullptr;
};

}  // namespace crsh::gpu
