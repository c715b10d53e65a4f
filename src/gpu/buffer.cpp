#include "gpu/buffer.h"

#include <algorithm>

#include "gpu/transfer.h"

namespace crsh::gpu {
namespace {

VkBuffer create_buffer(Device& device, uint64_t bytes) {
  VkBufferCreateInfo info{.sType = VK_STRUCTURE_TYPE_BUFFER_CREATE_INFO};
  info.size = bytes;
  info.usage = VK_BUFFER_USAGE_STORAGE_BUFFER_BIT | VK_BUFFER_USAGE_UNIFORM_TEXEL_BUFFER_BIT |
               VK_BUFFER_USAGE_TRANSFER_SRC_BIT | VK_BUFFER_USAGE_TRANSFER_DST_BIT | VK_BUFFER_USAGE_VERTEX_BUFFER_BIT |
               VK_BUFFER_USAGE_INDIRECT_BUFFER_BIT;
  if (device.info().ray_queries)
    info.usage |= VK_BUFFER_USAGE_SHADER_DEVICE_ADDRESS_BIT | VK_BUFFER_USAGE_ACCELERATION_STRUCTURE_STORAGE_BIT_KHR |
                  VK_BUFFER_USAGE_ACCELERATION_STRUCTURE_BUILD_INPUT_READ_ONLY_BIT_KHR;
  VkBuffer buffer = VK_NULL_HANDLE;
  check(vkCreateBuffer(device.handle(), &info, nullptr, &buffer), "making a buffer");
  return buffer;
}

void require_part(const Buffer& buffer, uint64_t offset, uint64_t bytes) {
  CRSH_ASSERT(offset <= buffer.bytes() && bytes <= buffer.bytes() - offset, "a copy past the end of " + buffer.name());
}

/// The size to which a buffer of `now` bytes grows that must hold `wanted`: half as much again, unless that is more
/// than a shader can bind, one allocation can hold or the budget allows; then `wanted`.
uint64_t grown(const Device& device, uint64_t now, uint64_t wanted) {
  uint64_t capacity = now;
  if (capacity == 0) capacity = device.request().first_capacity ? device.request().first_capacity : wanted;
  while (capacity < wanted) capacity += capacity / 2 + 1;
  const Limits& limits = device.limits();
  if (capacity > limits.max_binding || capacity > limits.max_allocation || capacity > device.available_bytes())
    return wanted;
  return capacity;
}

}  // namespace

// Calls the default constructor first, so that the destructor runs where a later step throws.
Buffer::Buffer(Device& device, uint64_t bytes, std::string_view name, bool host_visible) : Buffer() {
  device_ = &device;
  name_ = name;
  bytes_ = std::max<uint64_t>(16, (bytes + 3) / 4 * 4);  // whole words, for fill, and never nothing, for descriptors
  if (bytes_ > device.limits().max_allocation) throw OutOfMemory(name_, device.allocated_bytes() + bytes_, 0);
  buffer_ = create_buffer(device, bytes_);
  device.name_object(VK_OBJECT_TYPE_BUFFER, reinterpret_cast<uint64_t>(buffer_), name);
  VkMemoryRequirements requirements{};
  vkGetBufferMemoryRequirements(device.handle(), buffer_, &requirements);
  memory_ = device.allocate(requirements, host_visible, name);
  if (!host_visible) counted_ = requirements.size;
  check(vkBindBufferMemory(device.handle(), buffer_, memory_, 0), "binding a buffer's memory");
  if (host_visible) check(vkMapMemory(device.handle(), memory_, 0, VK_WHOLE_SIZE, 0, &mapped_), "mapping a buffer");
}

Buffer::~Buffer() {
  if (!device_) return;
  vkDestroyBuffer(device_->handle(), buffer_, nullptr);
  device_->release(memory_, counted_);
}

Buffer& Buffer::operator=(Buffer&& other) noexcept {
  std::swap(device_, other.device_);
  std::swap(buffer_, other.buffer_);
  std::swap(memory_, other.memory_);
  std::swap(mapped_, other.mapped_);
  std::swap(bytes_, other.bytes_);
  std::swap(counted_, other.counted_);
  std::swap(name_, other.name_);
  return *this;
}

void Buffer::reserve(Device& device, uint64_t bytes, std::string_view name) {
  if (buffer_ && bytes <= bytes_) return;
  const uint64_t before = bytes_;
  *this = Buffer();  // frees the old one first, because both together might not fit
  *this = Buffer(device, grown(device, before, bytes), name);
}

void upload_bytes(Device& device, const Buffer& target, uint64_t offset, const void* data, uint64_t bytes) {
  require_part(target, offset, bytes);
  device.transfer().upload(target.handle(), offset, data, bytes);
}

void download_bytes(Device& device, const Buffer& source, uint64_t offset, void* data, uint64_t bytes) {
  require_part(source, offset, bytes);
  device.transfer().download(source.handle(), offset, data, bytes);
}

}  // namespace crsh::gpu
