#include "gpu/acceleration.h"

#include <algorithm>

namespace crsh::gpu {
namespace {

constexpr VkDeviceSize corner_bytes = 16;

template <class Function>
void load(VkDevice device, const char* name, Function& function) {
  function = reinterpret_cast<Function>(vkGetDeviceProcAddr(device, name));
  CRSH_ASSERT(function, std::string("a device with ray queries has no ") + name);
}

VkAccelerationStructureBuildGeometryInfoKHR build_info(VkAccelerationStructureTypeKHR type,
                                                       const VkAccelerationStructureGeometryKHR& geometry) {
  VkAccelerationStructureBuildGeometryInfoKHR info{
      .sType = VK_STRUCTURE_TYPE_ACCELERATION_STRUCTURE_BUILD_GEOMETRY_INFO_KHR};
  info.type = type;
  info.flags = VK_BUILD_ACCELERATION_STRUCTURE_PREFER_FAST_TRACE_BIT_KHR;
  info.mode = VK_BUILD_ACCELERATION_STRUCTURE_MODE_BUILD_KHR;
  info.geometryCount = 1;
  info.pGeometries = &geometry;
  return info;
}

uint32_t scratch_alignment(VkPhysicalDevice physical) {
  VkPhysicalDeviceAccelerationStructurePropertiesKHR structures{
      .sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_ACCELERATION_STRUCTURE_PROPERTIES_KHR};
  VkPhysicalDeviceProperties2 all{.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_PROPERTIES_2};
  all.pNext = &structures;
  vkGetPhysicalDeviceProperties2(physical, &all);
  return std::max(structures.minAccelerationStructureScratchOffsetAlignment, 1u);
}

}  // namespace

AccelerationStructure::AccelerationStructure(Device& device, uint32_t triangles)
    : device_(device), triangles_(triangles), scratch_alignment_(scratch_alignment(device.physical())) {
  load_functions();
  make(bottom_, VK_ACCELERATION_STRUCTURE_TYPE_BOTTOM_LEVEL_KHR, triangles_of(0), triangles_, "acceleration structure");
  write_instance();
  make(top_, VK_ACCELERATION_STRUCTURE_TYPE_TOP_LEVEL_KHR, instance_of(), 1, "top of the acceleration structure");
}

AccelerationStructure::~AccelerationStructure() {
  for (const Level* level : {&top_, &bottom_})
    if (level->structure) destroy_(device_.handle(), level->structure, nullptr);
}

void AccelerationStructure::load_functions() {
  load(device_.handle(), "vkCreateAccelerationStructureKHR", create_);
  load(device_.handle(), "vkDestroyAccelerationStructureKHR", destroy_);
  load(device_.handle(), "vkGetAccelerationStructureBuildSizesKHR", sizes_);
  load(device_.handle(), "vkCmdBuildAccelerationStructuresKHR", build_);
  load(device_.handle(), "vkGetAccelerationStructureDeviceAddressKHR", structure_address_);
}

void AccelerationStructure::make(Level& level, VkAccelerationStructureTypeKHR type,
                                 const VkAccelerationStructureGeometryKHR& geometry, uint32_t count, const char* name) {
  const VkAccelerationStructureBuildGeometryInfoKHR info = build_info(type, geometry);
  VkAccelerationStructureBuildSizesInfoKHR sizes{.sType =
                                                     VK_STRUCTURE_TYPE_ACCELERATION_STRUCTURE_BUILD_SIZES_INFO_KHR};
  sizes_(device_.handle(), VK_ACCELERATION_STRUCTURE_BUILD_TYPE_DEVICE_KHR, &info, &count, &sizes);
  level.memory = Buffer(device_, sizes.accelerationStructureSize, name);
  level.scratch = Buffer(device_, sizes.buildScratchSize + scratch_alignment_, "scratch of the acceleration structure");
  VkAccelerationStructureCreateInfoKHR create{.sType = VK_STRUCTURE_TYPE_ACCELERATION_STRUCTURE_CREATE_INFO_KHR};
  create.buffer = level.memory.handle();
  create.size = sizes.accelerationStructureSize;
  create.type = type;
  check(create_(device_.handle(), &create, nullptr, &level.structure), "making an acceleration structure");
}

VkDeviceAddress AccelerationStructure::address(const Buffer& buffer) const {
  VkBufferDeviceAddressInfo info{.sType = VK_STRUCTURE_TYPE_BUFFER_DEVICE_ADDRESS_INFO};
  info.buffer = buffer.handle();
  return vkGetBufferDeviceAddress(device_.handle(), &info);
}

/// Without flags that would skip triangles: whether a triangle counts is decided where a ray hits it. No triangle is
/// reported twice to a ray.
VkAccelerationStructureGeometryKHR AccelerationStructure::triangles_of(VkDeviceAddress corners) const {
  VkAccelerationStructureGeometryKHR geometry{.sType = VK_STRUCTURE_TYPE_ACCELERATION_STRUCTURE_GEOMETRY_KHR};
  geometry.geometryType = VK_GEOMETRY_TYPE_TRIANGLES_KHR;
  geometry.flags = VK_GEOMETRY_NO_DUPLICATE_ANY_HIT_INVOCATION_BIT_KHR;
  VkAccelerationStructureGeometryTrianglesDataKHR& triangles = geometry.geometry.triangles;
  triangles.sType = VK_STRUCTURE_TYPE_ACCELERATION_STRUCTURE_GEOMETRY_TRIANGLES_DATA_KHR;
  triangles.vertexFormat = VK_FORMAT_R32G32B32_SFLOAT;
  triangles.vertexData.deviceAddress = corners;
  triangles.vertexStride = corner_bytes;
  triangles.maxVertex = 3 * triangles_ - 1;
  triangles.indexType = VK_INDEX_TYPE_NONE_KHR;
  return geometry;
}

VkAccelerationStructureGeometryKHR AccelerationStructure::instance_of() const {
  VkAccelerationStructureGeometryKHR geometry{.sType = VK_STRUCTURE_TYPE_ACCELERATION_STRUCTURE_GEOMETRY_KHR};
  geometry.geometryType = VK_GEOMETRY_TYPE_INSTANCES_KHR;
  VkAccelerationStructureGeometryInstancesDataKHR& instances = geometry.geometry.instances;
  instances.sType = VK_STRUCTURE_TYPE_ACCELERATION_STRUCTURE_GEOMETRY_INSTANCES_DATA_KHR;
  instances.data.deviceAddress = address(instance_);
  return geometry;
}

void AccelerationStructure::write_instance() {
  VkAccelerationStructureDeviceAddressInfoKHR bottom{
      .sType = VK_STRUCTURE_TYPE_ACCELERATION_STRUCTURE_DEVICE_ADDRESS_INFO_KHR};
  bottom.accelerationStructure = bottom_.structure;
  VkAccelerationStructureInstanceKHR instance{};
  for (int i = 0; i < 3; ++i) instance.transform.matrix[i][i] = 1;
  instance.mask = 0xFF;
  instance.flags = VK_GEOMETRY_INSTANCE_TRIANGLE_FACING_CULL_DISABLE_BIT_KHR;
  instance.accelerationStructureReference = structure_address_(device_.handle(), &bottom);
  instance_ = Buffer(device_, sizeof instance, "instance of the acceleration structure");
  upload_bytes(device_, instance_, 0, &instance, sizeof instance);
}

void AccelerationStructure::record(VkCommandBuffer commands, const Level& level, VkAccelerationStructureTypeKHR type,
                                   const VkAccelerationStructureGeometryKHR& geometry, uint32_t count) const {
  VkAccelerationStructureBuildGeometryInfoKHR info = build_info(type, geometry);
  info.dstAccelerationStructure = level.structure;
  const VkDeviceAddress scratch = address(level.scratch), align = scratch_alignment_;
  info.scratchData.deviceAddress = (scratch + align - 1) / align * align;
  VkAccelerationStructureBuildRangeInfoKHR range{};
  range.primitiveCount = count;
  const VkAccelerationStructureBuildRangeInfoKHR* ranges = &range;
  build_(commands, 1, &info, &ranges);
}

void AccelerationStructure::record_bottom(VkCommandBuffer commands, const Buffer& corners) const {
  CRSH_ASSERT(corners.bytes() >= 3 * corner_bytes * triangles_, "an acceleration structure over too few corners");
  record(commands, bottom_, VK_ACCELERATION_STRUCTURE_TYPE_BOTTOM_LEVEL_KHR, triangles_of(address(corners)),
         triangles_);
}

void AccelerationStructure::record_top(VkCommandBuffer commands) const {
  record(commands, top_, VK_ACCELERATION_STRUCTURE_TYPE_TOP_LEVEL_KHR, instance_of(), 1);
}

}  // namespace crsh::gpu
