#include "gpu/descriptors.h"

#include <array>

#include "crsh/assertion.h"

namespace crsh::gpu {
namespace {

constexpr uint32_t sets_a_pool = 256;
constexpr uint32_t buffers_a_set = 16, images_a_set = 4;  // on average

VkDescriptorBufferInfo buffer_info(const Limits& limits, const Binding& binding, std::string_view name) {
  const std::string text = binding.buffer->name() + ", bound by " + std::string(name) + ", ";
  CRSH_ASSERT(binding.buffer->handle(), text + "is an empty buffer");
  CRSH_ASSERT(binding.bytes > 0, text + "is bound with no bytes");
  CRSH_ASSERT(binding.offset <= binding.buffer->bytes() && binding.bytes <= binding.buffer->bytes() - binding.offset,
              text + "is bound past its end");
  CRSH_ASSERT(binding.offset % limits.binding_alignment == 0, text + "is bound at an unaligned offset");
  CRSH_ASSERT(binding.bytes <= limits.max_binding, text + "is larger than one binding holds");
  return {binding.buffer->handle(), binding.offset, binding.bytes};
}

VkDescriptorImageInfo image_info(const Image& image, std::string_view name) {
  CRSH_ASSERT(image.view() && image.format() != Format::depth32f,
              std::string(name) + " binds an image that cannot be read");
  return {VK_NULL_HANDLE, image.view(), VK_IMAGE_LAYOUT_GENERAL};
}

/// The descriptor writes of one set; they point into the two lists of infos.
class Writes {
 public:
  Writes(VkDescriptorSet set, size_t count) : set_(set) {
    buffers_.reserve(count), images_.reserve(count), structures_.reserve(count), handles_.reserve(count);
  }

  void add(const VkDescriptorBufferInfo& info) {
    buffers_.push_back(info);
    add(VK_DESCRIPTOR_TYPE_STORAGE_BUFFER).pBufferInfo = &buffers_.back();
  }
  void add(const VkDescriptorImageInfo& info) {
    images_.push_back(info);
    add(VK_DESCRIPTOR_TYPE_STORAGE_IMAGE).pImageInfo = &images_.back();
  }
  void add(const AccelerationStructure& structure) {
    handles_.push_back(structure.handle());
    VkWriteDescriptorSetAccelerationStructureKHR info{
        .sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET_ACCELERATION_STRUCTURE_KHR};
    info.accelerationStructureCount = 1;
    info.pAccelerationStructures = &handles_.back();
    structures_.push_back(info);
    add(VK_DESCRIPTOR_TYPE_ACCELERATION_STRUCTURE_KHR).pNext = &structures_.back();
  }
  void update(VkDevice device) const {
    vkUpdateDescriptorSets(device, static_cast<uint32_t>(writes_.size()), writes_.data(), 0, nullptr);
  }

 private:
  VkWriteDescriptorSet& add(VkDescriptorType type) {
    VkWriteDescriptorSet write{.sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET};
    write.dstSet = set_;
    write.dstBinding = static_cast<uint32_t>(writes_.size());
    write.descriptorCount = 1;
    write.descriptorType = type;
    return writes_.emplace_back(write);
  }

  VkDescriptorSet set_;
  std::vector<VkDescriptorBufferInfo> buffers_;
  std::vector<VkDescriptorImageInfo> images_;
  std::vector<VkWriteDescriptorSetAccelerationStructureKHR> structures_;
  std::vector<VkAccelerationStructureKHR> handles_;
  std::vector<VkWriteDescriptorSet> writes_;
};

}  // namespace

Descriptors::~Descriptors() {
  for (VkDescriptorPool pool : pools_) vkDestroyDescriptorPool(device_.handle(), pool, nullptr);
}

VkDescriptorSet Descriptors::describe(VkDescriptorSetLayout layout, const Reflection& reflection,
                                      std::initializer_list<Argument> arguments, std::string_view name) {
  CRSH_ASSERT(arguments.size() == reflection.resources.size(),
              std::string(name) + " takes " + std::to_string(reflection.resources.size()) + " arguments, not " +
                  std::to_string(arguments.size()));
  const VkDescriptorSet set = allocate(layout);
  Writes writes(set, arguments.size());
  size_t index = 0;
  for (const Argument& argument : arguments) {
    CRSH_ASSERT(static_cast<Resource>(argument.index()) == reflection.resources[index],
                "argument " + std::to_string(index) + " of " + std::string(name) + " is of the wrong kind");
    switch (reflection.resources[index]) {
      case Resource::storage_buffer:
        writes.add(buffer_info(device_.limits(), std::get<Binding>(argument), name));
        break;
      case Resource::storage_image: writes.add(image_info(*std::get<const Image*>(argument), name)); break;
      case Resource::acceleration_structure: writes.add(*std::get<const AccelerationStructure*>(argument)); break;
    }
    ++index;
  }
  writes.update(device_.handle());
  return set;
}

VkDescriptorSet Descriptors::allocate(VkDescriptorSetLayout layout) {
  for (;; ++current_) {
    const bool fresh = current_ == pools_.size();
    if (fresh) add_pool();
    VkDescriptorSetAllocateInfo info{.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO};
    info.descriptorPool = pools_[current_];
    info.descriptorSetCount = 1;
    info.pSetLayouts = &layout;
    VkDescriptorSet set = VK_NULL_HANDLE;
    const VkResult result = vkAllocateDescriptorSets(device_.handle(), &info, &set);
    const bool exhausted = result == VK_ERROR_OUT_OF_POOL_MEMORY || result == VK_ERROR_FRAGMENTED_POOL;
    if (!exhausted || fresh) {
      check(result, "making a descriptor set");
      return set;
    }
  }
}

void Descriptors::add_pool() {
  const std::array<VkDescriptorPoolSize, 3> sizes = {{{VK_DESCRIPTOR_TYPE_STORAGE_BUFFER, sets_a_pool * buffers_a_set},
                                                      {VK_DESCRIPTOR_TYPE_STORAGE_IMAGE, sets_a_pool * images_a_set},
                                                      {VK_DESCRIPTOR_TYPE_ACCELERATION_STRUCTURE_KHR, sets_a_pool}}};
  VkDescriptorPoolCreateInfo info{.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO};
  info.maxSets = sets_a_pool;
  info.poolSizeCount = device_.info().ray_queries ? 3 : 2;
  info.pPoolSizes = sizes.data();
  VkDescriptorPool pool = VK_NULL_HANDLE;
  check(vkCreateDescriptorPool(device_.handle(), &info, nullptr, &pool), "making a descriptor pool");
  pools_.push_back(pool);
}

void Descriptors::reset() {
  for (VkDescriptorPool pool : pools_)
    check(vkResetDescriptorPool(device_.handle(), pool, 0), "resetting a descriptor pool");
  current_ = 0;
}

}  // namespace crsh::gpu
