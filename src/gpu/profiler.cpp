#include "gpu/profiler.h"

#include <utility>

namespace crsh::gpu {
namespace {

constexpr uint32_t max_timestamps = 1024;
/// Timestamps of a first run and of the end of a submit, besides the next stage's.
constexpr uint32_t reserved_timestamps = 3;

uint32_t timestamp_bits(const Device& device) {
  uint32_t count = 0;
  vkGetPhysicalDeviceQueueFamilyProperties(device.physical(), &count, nullptr);
  std::vector<VkQueueFamilyProperties> families(count);
  vkGetPhysicalDeviceQueueFamilyProperties(device.physical(), &count, families.data());
  return families[device.queue_family()].timestampValidBits;
}

/// lavapipe puts a timestamp off until something makes it flush, which the next dispatch does not: an execution barrier
/// does, so that a span does not take in the first dispatch of the next.
void flush_timestamp(VkCommandBuffer commands) {
  VkMemoryBarrier2 memory{.sType = VK_STRUCTURE_TYPE_MEMORY_BARRIER_2};
  memory.srcStageMask = memory.dstStageMask = VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT;
  VkDependencyInfo dependency{.sType = VK_STRUCTURE_TYPE_DEPENDENCY_INFO};
  dependency.memoryBarrierCount = 1;
  dependency.pMemoryBarriers = &memory;
  vkCmdPipelineBarrier2(commands, &dependency);
}

}  // namespace

Profiler::Profiler(Device& device) : device_(device) {
  const uint32_t bits = timestamp_bits(device);
  if (bits == 0) return;
  tick_mask_ = bits >= 64 ? UINT64_MAX : (uint64_t(1) << bits) - 1;
  VkQueryPoolCreateInfo info{.sType = VK_STRUCTURE_TYPE_QUERY_POOL_CREATE_INFO};
  info.queryType = VK_QUERY_TYPE_TIMESTAMP;
  info.queryCount = max_timestamps;
  check(vkCreateQueryPool(device.handle(), &info, nullptr, &pool_), "making a query pool");
}

Profiler::~Profiler() { vkDestroyQueryPool(device_.handle(), pool_, nullptr); }

bool Profiler::full() const { return spans_.size() + reserved_timestamps >= max_timestamps; }

void Profiler::write_timestamp(VkCommandBuffer commands, size_t span) {
  if (pool_) {
    vkCmdWriteTimestamp2(commands, VK_PIPELINE_STAGE_2_ALL_COMMANDS_BIT, pool_, static_cast<uint32_t>(spans_.size()));
    flush_timestamp(commands);
  }
  spans_.push_back(span);
}

void Profiler::begin(VkCommandBuffer commands) {
  spans_.clear();
  if (pool_) vkCmdResetQueryPool(commands, pool_, 0, max_timestamps);
  write_timestamp(commands, static_cast<size_t>(stage_));
}

void Profiler::change(VkCommandBuffer commands, Stage stage) {
  if (stage == stage_) return;
  stage_ = stage;
  if (commands) write_timestamp(commands, static_cast<size_t>(stage));
}

void Profiler::begin_first_run(VkCommandBuffer commands) { write_timestamp(commands, first_run); }
void Profiler::end_first_run(VkCommandBuffer commands) { write_timestamp(commands, static_cast<size_t>(stage_)); }
void Profiler::end(VkCommandBuffer commands) { write_timestamp(commands, static_cast<size_t>(stage_)); }

void Profiler::collect() {
  if (!pool_) return;
  std::vector<uint64_t> ticks(spans_.size());
  check(vkGetQueryPoolResults(device_.handle(), pool_, 0, static_cast<uint32_t>(ticks.size()),
                              ticks.size() * sizeof(uint64_t), ticks.data(), sizeof(uint64_t),
                              VK_QUERY_RESULT_64_BIT | VK_QUERY_RESULT_WAIT_BIT),
        "reading timestamps");
  for (size_t i = 0; i + 1 < ticks.size(); ++i)  // each span ends where the next begins; the last timestamp is an end
    nanoseconds_[spans_[i]] +=
        static_cast<double>((ticks[i + 1] - ticks[i]) & tick_mask_) * device_.limits().nanoseconds_per_tick;
}

std::array<double, stage_count> Profiler::take_milliseconds() {
  std::array<double, stage_count> milliseconds;
  for (size_t i = 0; i < stage_count; ++i) milliseconds[i] = std::exchange(nanoseconds_[i], 0) * 1e-6;
  return milliseconds;
}

double Profiler::take_first_run_milliseconds() { return std::exchange(nanoseconds_[first_run], 0) * 1e-6; }

}  // namespace crsh::gpu
