#include "gpu/descriptors.h"

#include <algorithm>
#include <array>

#include "crsh/assertion.h"

namespace crsh::gpu {
namespace {

constexpr uint32_t sets_a_pool = 256;
constexpr uint32_t buffers_a_set = 16, images_a_set = 4;  // on average

VkDescriptorBufferInfo buffer_info(const Limits& limits, const Binding& binding, std::string_view name) {
  const auto text = [&](const char* what) {
    return binding.buffer->name() + ", bound by " + std::string(name) + ", " + what;
  };
  CRSH_ASSERT(binding.buffer->handle(), text("is an empty buffer"));
  CRSH_ASSERT(binding.bytes > 0, text("is bound with no bytes"));
  CRSH_ASSERT(binding.offset <= binding.buffer->bytes() && binding.bytes <= binding.buffer->bytes() - binding.offset,
              text("is bound past its end"));
  CRSH_ASSERT(binding.offset % limits.binding_alignment == 0, text("is bound at an unaligned offset"));
  CRSH_ASSERT(binding.bytes <= limits.max_binding, text("is larger than one binding holds"));
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

  void add(uint32_t binding, const VkDescriptorBufferInfo& info) {
    buffers_.push_back(info);
    add(binding, Resource::storage_buffer).pBufferInfo = &buffers_.back();
  }
  void add(uint32_t binding, const VkDescriptorImageInfo& info) {
    images_.push_back(info);
    add(binding, Resource::storage_image).pImageInfo = &images_.back();
  }
  void add(uint32_t binding, const AccelerationStructure& structure) {
    handles_.push_back(structure.handle());
    VkWriteDescriptorSetAccelerationStructureKHR info{
        .sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET_ACCELERATION_STRUCTURE_KHR};
    info.accelerationStructureCount = 1;
    info.pAccelerationStructures = &handles_.back();
    structures_.push_back(info);
    add(binding, Resource::acceleration_structure).pNext = &structures_.back();
  }
  void update(VkDevice device) const {
    vkUpdateDescriptorSets(device, static_cast<uint32_t>(writes_.size()), writes_.data(), 0, nullptr);
  }

 private:
  VkWriteDescriptorSet& add(uint32_t binding, Resource kind) {
    VkWriteDescriptorSet write{.sType = VK_STRUCTURE_TYPE_WRITE_DESCRIPTOR_SET};
    write.dstSet = set_;
    write.dstBinding = binding;
    write.descriptorCount = 1;
    write.descriptorType = descriptor_type(kind);
    return writes_.emplace_back(write);
  }

  VkDescriptorSet set_;
  std::vector<VkDescriptorBufferInfo> buffers_;
  std::vector<VkDescriptorImageInfo> images_;
  std::vector<VkWriteDescriptorSetAccelerationStructureKHR> structures_;
  std::vector<VkAccelerationStructureKHR> handles_;
  std::vector<VkWriteDescriptorSet> writes_;
};

/// Where the shader declares it, the number of declarations where it does not. Callers mostly name arguments in the
/// shader's order, so the one at the same place is tried first.
uint32_t binding_of(std::span<const Declared> declared, std::string_view name, size_t place) {
  if (place < declared.size() && declared[place].name == name) return static_cast<uint32_t>(place);
  return static_cast<uint32_t>(std::ranges::find(declared, name, &Declared::name) - declared.begin());
}

/// Asserts that each declared name is given once, and no other.
void require_names(std::string_view shader, std::span<const Declared> declared, Arguments arguments) {
  uint64_t given = 0;
  size_t place = 0;
  for (const Argument& argument : arguments)
    if (!is_tables(argument)) given |= uint64_t(1) << binding_of(declared, argument.name, place++);
  if (place == declared.size() && given == (uint64_t(1) << declared.size()) - 1) return;
  std::vector<std::string_view> names;
  for (const Argument& argument : arguments)
    if (!is_tables(argument)) names.push_back(argument.name);
  assertion_failed(__FILE__, __LINE__, misnamed(shader, declared, names));
}

}  // namespace

Descriptors::~Descriptors() {
  for (VkDescriptorPool pool : pools_) vkDestroyDescriptorPool(device_.handle(), pool, nullptr);
}

std::string misnamed(std::string_view shader, std::span<const Declared> declared,
                     std::span<const std::string_view> names) {
  const auto is_given_once = [&](const Declared& one) { return std::ranges::count(names, one.name) == 1; };
  if (names.size() == declared.size() && std::ranges::all_of(declared, is_given_once)) return "";
  std::string given;
  for (const std::string_view name : names) given += (given.empty() ? "" : ", ") + std::string(name);
  return std::string(shader) + " takes " + names_of(declared) + ", and is given " + (given.empty() ? "nothing" : given);
}

VkDescriptorSet Descriptors::describe(VkDescriptorSetLayout layout, const Reflection& reflection, Arguments arguments,
                                      std::string_view shader) {
  require_names(shader, reflection.arguments, arguments);
  const VkDescriptorSet set = allocate(layout);
  Writes writes(set, arguments.size());
  uint32_t place = 0;
  for (const Argument& argument : arguments) {
    if (is_tables(argument)) continue;
    const uint32_t binding = binding_of(reflection.arguments, argument.name, place++);
    const Declared& declared = reflection.arguments[binding];
    CRSH_ASSERT(static_cast<Resource>(argument.bound.index()) == declared.kind,
                declared.name + " of " + std::string(shader) + " is of another kind");
    if (const auto* buffer = std::get_if<Binding>(&argument.bound))
      writes.add(binding, buffer_info(device_.limits(), *buffer, shader));
    else if (const auto* image = std::get_if<const Image*>(&argument.bound))
      writes.add(binding, image_info(**image, shader));
    else writes.add(binding, *std::get<const AccelerationStructure*>(argument.bound));
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
