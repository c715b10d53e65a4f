#include "gpu/buffer_set.h"

#include <algorithm>
#include <array>
#include <utility>

namespace crsh::gpu {
namespace {

constexpr uint32_t texel_bytes(ReadAs read_as) { return read_as == ReadAs::texels_r32u ? 4 : 16; }

std::vector<Declared> declared(std::span<const BufferSet::Member> members) {
  std::vector<Declared> all;
  for (const BufferSet::Member& member : members)
    all.push_back({std::string(member.name),
                   member.read_as == ReadAs::storage ? Resource::storage_buffer : Resource::texel_buffer});
  return all;
}

}  // namespace

VkDescriptorType descriptor_type(Resource kind) {
  switch (kind) {
    case Resource::storage_buffer: return VK_DESCRIPTOR_TYPE_STORAGE_BUFFER;
    case Resource::storage_image: return VK_DESCRIPTOR_TYPE_STORAGE_IMAGE;
    case Resource::texel_buffer: return VK_DESCRIPTOR_TYPE_UNIFORM_TEXEL_BUFFER;
    case Resource::acceleration_structure: break;
  }
  return VK_DESCRIPTOR_TYPE_ACCELERATION_STRUCTURE_KHR;
}

VkDescriptorSetLayout make_set_layout(Device& device, std::span<const Declared> declared, VkShaderStageFlags stages) {
  std::vector<VkDescriptorSetLayoutBinding> bindings;
  for (const Declared& one : declared)
    bindings.push_back({static_cast<uint32_t>(bindings.size()), descriptor_type(one.kind), 1, stages, nullptr});
  VkDescriptorSetLayoutCreateInfo info{.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_LAYOUT_CREATE_INFO};
  info.bindingCount = static_cast<uint32_t>(bindings.size());
  info.pBindings = bindings.data();
  VkDescriptorSetLayout layout = VK_NULL_HANDLE;
  check(vkCreateDescriptorSetLayout(device.handle(), &info, nullptr, &layout), "making a descriptor set layout");
  return layout;
}

// Calls the default constructor first, so that the destructor runs where a later step throws.
BufferSet::BufferSet(Device& device, std::span<const Member> members) : BufferSet() {
  device_ = &device;
  members_ = declared(members);
  layout_ = make_set_layout(device, members_, table_stages);
  allocate();
  write(members);
}

BufferSet::~BufferSet() {
  if (!device_) return;
  for (const VkBufferView view : views_) vkDestroyBufferView(device_->handle(), view, nullptr);
  vkDestroyDescriptorPool(device_->handle(), pool_, nullptr);
  vkDestroyDescriptorSetLayout(device_->handle(), layout_, nullptr);
}

BufferSet& BufferSet::operator=(BufferSet&& other) noexcept {
  std::swap(device_, other.device_);
  std::swap(members_, other.members_);
  std::swap(views_, other.views_);
  std::swap(layout_, other.layout_);
  std::swap(pool_, other.pool_);
  std::swap(set_, other.set_);
  return *this;
}

void BufferSet::allocate() {
  std::vector<VkDescriptorPoolSize> sizes;
  for (const Declared& member : members_) sizes.push_back({descriptor_type(member.kind), 1});
  VkDescriptorPoolCreateInfo pool{.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_POOL_CREATE_INFO};
  pool.maxSets = 1;
  pool.poolSizeCount = static_cast<uint32_t>(sizes.size());
  pool.pPoolSizes = sizes.data();
  check(vkCreateDescriptorPool(device_->handle(), &pool, nullptr, &pool_), "making a descriptor pool");
  VkDescriptorSetAllocateInfo info{.sType = VK_STRUCTURE_TYPE_DESCRIPTOR_SET_ALLOCATE_INFO};
  info.descriptorPool = pool_;
  info.descriptorSetCount = 1;
  info.pSetLayouts = &layout_;
  check(vkAllocateDescriptorSets(device_->handle(), &info, &set_), "making a descriptor set");
}

VkBufferView BufferSet::view_of(const Member& member) {
  const uint64_t size = texel_bytes(member.read_as);
  VkBufferViewCreateInfo info{.sType = VK_STRUCTURE_TYPE_BUFFER_VIEW_CREATE_INFO};
  info.buffer = member.buffer.handle();
  info.format = member.read_as == ReadAs::texels_r32u ? VK_FORMAT_R32_UINT : VK_FORMAT_R32G32B32A32_UINT;
  info.range = std::min<uint64_t>(member.buffer.bytes() / size, device_->limits().max_texels) * size;
  VkBufferView view = VK_NULL_HANDLE;
  check(vkCreateBufferView(device_->handle(), &info, nullptr, &view), "making a texel buffer");
  return views_.emplace_back(view);
}

void BufferSet::write(std::span<const Member> members) {
  std::vector<VkDescriptorBufferInfo> buffers;
  std::vector<VkBufferView> texels;
  for (const Member& member : members) {
    const bool is_storage = member.read_as == ReadAs::storage;
    const uint64_t bytes = std::min(member.buffer.bytes(), device_->limits().max_binding);
    buffers.push_back({member.buffer.handle(), 0, bytes});
    texels.push_back(is_storage ? VK_NULL_HANDLE : view_of(member));
  }
  std::vector<VkWriteDescriptorSet> writes;
  for (uint32_t i = 0; i < members_.size(); ++i) {
    VkWriteDescriptorSet write{.sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET};
    write.dstSet = set_;
    write.dstBinding = i;
    write.descriptorCount = 1;
    write.descriptorType = descriptor_type(members_[i].kind);
    write.pBufferInfo = &buffers[i];
    write.pTexelBufferView = &texels[i];
    writes.push_back(write);
  }
  vkUpdateDescriptorSets(device_->handle(), static_cast<uint32_t>(writes.size()), writes.data(), 0, nullptr);
}

}  // namespace crsh::gpu
