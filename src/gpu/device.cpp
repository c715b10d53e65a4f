#include "gpu/device.h"

#include <algorithm>

#include "crsh/assertion.h"
#include "crsh/error.h"
#include "gpu/instance.h"
#include "gpu/program.h"
#include "gpu/transfer.h"

namespace crsh::gpu {
namespace {

std::vector<DeviceInfo> describe_all(const std::vector<VkPhysicalDevice>& devices) {
  std::vector<DeviceInfo> infos;
  for (uint32_t i = 0; i < devices.size(); ++i) infos.push_back(describe_device(devices[i], i));
  return infos;
}

std::string program_key(const Kernel& kernel) {
  std::string key = kernel.path;
  for (const auto& [id, value] : kernel.constants) key += ' ' + std::to_string(id) + '=' + std::to_string(value);
  return key;
}

}  // namespace

std::vector<DeviceInfo> list_devices() { return describe_all(Instance(false).devices()); }

Device::Device() = default;

// Calls the private constructor first, so that the destructor runs where a later step throws.
Device::Device(const DeviceRequest& request) : Device() {
  request_ = request;
  instance_ = std::make_unique<Instance>(request.validation, request.window_extensions, request.on_validation);
  const std::vector<VkPhysicalDevice> devices = instance_->devices();
  const std::vector<DeviceInfo> infos = describe_all(devices);
  const uint32_t index = select_device(infos, request.selector);
  physical_ = devices[index];
  info_ = infos[index];
  info_.ray_queries = info_.ray_queries && !request.no_ray_queries;
  limits_ = device_limits(physical_);
  tuning_ = choose_tuning(info_.software);
  promises_ = promises_of(info_, instance_->layer_version());
  if (request.max_texels) limits_.max_texels = std::min(limits_.max_texels, request.max_texels);
  vkGetPhysicalDeviceMemoryProperties(physical_, &memory_);
  create_device();
  if (request.validation) load_label_functions();
  transfer_ = std::make_unique<Transfer>(*this);
}

Device::~Device() {
  if (!device_) return;
  vkDeviceWaitIdle(device_);
  programs_.clear();
  transfer_.reset();
  vkDestroyDevice(device_, nullptr);
}

void Device::create_device() {
  queue_family_ = find_queue_family(physical_);
  const float priority = 1;
  VkDeviceQueueCreateInfo queue{.sType = VK_STRUCTURE_TYPE_DEVICE_QUEUE_CREATE_INFO};
  queue.queueFamilyIndex = queue_family_;
  queue.queueCount = 1;
  queue.pQueuePriorities = &priority;

  VkPhysicalDeviceVulkan13Features v13{.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_3_FEATURES};
  v13.synchronization2 = VK_TRUE;
  v13.dynamicRendering = VK_TRUE;
  v13.computeFullSubgroups = VK_TRUE;
  VkPhysicalDeviceVulkan12Features v12{.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_VULKAN_1_2_FEATURES};
  v12.pNext = &v13;
  v12.scalarBlockLayout = VK_TRUE;
  VkPhysicalDeviceRayQueryFeaturesKHR queries{.sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_RAY_QUERY_FEATURES_KHR};
  queries.rayQuery = VK_TRUE;
  VkPhysicalDeviceAccelerationStructureFeaturesKHR structures{
      .sType = VK_STRUCTURE_TYPE_PHYSICAL_DEVICE_ACCELERATION_STRUCTURE_FEATURES_KHR};
  structures.pNext = &queries;
  structures.accelerationStructure = VK_TRUE;
  if (info_.ray_queries) v12.bufferDeviceAddress = VK_TRUE, v13.pNext = &structures;

  ReconvergenceFeature reconvergence{.next = &v12, .maximal_reconvergence = VK_TRUE};

  VkDeviceCreateInfo info{.sType = VK_STRUCTURE_TYPE_DEVICE_CREATE_INFO};
  info.pNext = promises_.reconverges ? static_cast<void*>(&reconvergence) : &v12;
  info.queueCreateInfoCount = 1;
  info.pQueueCreateInfos = &queue;
  std::vector<const char*> extensions;
  if (info_.ray_queries) extensions.assign(ray_query_extensions.begin(), ray_query_extensions.end());
  if (promises_.reconverges) extensions.push_back(reconvergence_extension);
  if (!request_.window_extensions.empty()) extensions.push_back(VK_KHR_SWAPCHAIN_EXTENSION_NAME);
  info.enabledExtensionCount = uint32_t(extensions.size());
  info.ppEnabledExtensionNames = extensions.data();
  check(vkCreateDevice(physical_, &info, nullptr, &device_), "opening the device");
  vkGetDeviceQueue(device_, queue_family_, 0, &queue_);
}

VkInstance Device::instance() const { return instance_->handle(); }

uint64_t Device::validation_messages() const { return instance_->messages(); }

void Device::forget_programs() { programs_.clear(); }

void Device::wait_idle() {
  const std::lock_guard lock(queue_mutex_);
  check(vkDeviceWaitIdle(device_), "waiting for the device");
}

std::vector<std::string> Device::programs_in_use() const {
  std::vector<std::string> names;
  for (const auto& [key, program] : programs_) names.push_back(program->name() + ".comp");
  names.erase(std::unique(names.begin(), names.end()), names.end());
  return names;
}

uint64_t Device::available_bytes() const {
  if (request_.memory_budget == 0) return UINT64_MAX;
  return request_.memory_budget - std::min(request_.memory_budget, allocated_);
}

const Program& Device::program(const Kernel& kernel) {
  std::unique_ptr<Program>& program = programs_[program_key(kernel)];
  if (!program) program = std::make_unique<Program>(*this, kernel);
  return *program;
}

uint32_t Device::memory_type(uint32_t allowed, bool host_visible) const {
  constexpr VkMemoryPropertyFlags host = VK_MEMORY_PROPERTY_HOST_VISIBLE_BIT | VK_MEMORY_PROPERTY_HOST_COHERENT_BIT;
  const auto find = [&](VkMemoryPropertyFlags wanted) {
    for (uint32_t i = 0; i < memory_.memoryTypeCount; ++i)
      if ((allowed >> i & 1) && (memory_.memoryTypes[i].propertyFlags & wanted) == wanted) return i;
    return UINT32_MAX;
  };
  // Cached host memory first: it is read as often as written, and reading uncached memory is slow.
  const VkMemoryPropertyFlags needed = host_visible ? host : 0;
  const VkMemoryPropertyFlags better =
      needed | (host_visible ? VK_MEMORY_PROPERTY_HOST_CACHED_BIT : VK_MEMORY_PROPERTY_DEVICE_LOCAL_BIT);
  uint32_t type = find(better);
  if (type == UINT32_MAX) type = find(needed);
  CRSH_ASSERT(type != UINT32_MAX, "Vulkan guarantees such a memory type");
  return type;
}

void Device::count_memory(uint64_t bytes, uint32_t heap, std::string_view name) {
  const uint64_t sum = allocated_ + bytes;
  if (request_.memory_budget && sum > request_.memory_budget)
    throw OutOfMemory(std::string(name), sum, request_.memory_budget);
  if (sum > memory_.memoryHeaps[heap].size) throw OutOfMemory(std::string(name), sum, 0);
  allocated_ = sum;
  peak_ = std::max(peak_, sum);
}

VkDeviceMemory Device::allocate(const VkMemoryRequirements& requirements, bool host_visible, std::string_view name) {
  if (requirements.size > limits_.max_allocation)
    throw OutOfMemory(std::string(name), allocated_ + requirements.size, 0);
  VkMemoryAllocateInfo info{.sType = VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_INFO};
  info.allocationSize = requirements.size;
  info.memoryTypeIndex = memory_type(requirements.memoryTypeBits, host_visible);
  VkMemoryAllocateFlagsInfo flags{.sType = VK_STRUCTURE_TYPE_MEMORY_ALLOCATE_FLAGS_INFO};
  flags.flags = VK_MEMORY_ALLOCATE_DEVICE_ADDRESS_BIT;
  if (info_.ray_queries) info.pNext = &flags;
  const std::lock_guard lock(memory_mutex_);
  const uint64_t before = peak_;
  if (!host_visible) count_memory(requirements.size, memory_.memoryTypes[info.memoryTypeIndex].heapIndex, name);
  VkDeviceMemory memory = VK_NULL_HANDLE;
  const VkResult result = vkAllocateMemory(device_, &info, nullptr, &memory);
  if (result == VK_SUCCESS) return memory;
  if (!host_visible) allocated_ -= requirements.size, peak_ = before;
  if (result == VK_ERROR_OUT_OF_DEVICE_MEMORY || result == VK_ERROR_OUT_OF_HOST_MEMORY)
    throw OutOfMemory(std::string(name), allocated_ + requirements.size, 0);
  check(result, "allocating memory");
  return VK_NULL_HANDLE;
}

void Device::release(VkDeviceMemory memory, uint64_t counted) {
  if (!memory) return;
  vkFreeMemory(device_, memory, nullptr);
  const std::lock_guard lock(memory_mutex_);
  CRSH_ASSERT(counted <= allocated_, "more memory was released than allocated");
  allocated_ -= counted;
}

}  // namespace crsh::gpu
