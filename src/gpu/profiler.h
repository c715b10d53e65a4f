#pragma once
// GPU time a stage, from timestamps.

#include <vulkan/vulkan.h>

#include <array>
#include <cstdint>
#include <vector>

#include "crsh/stage.h"
#include "gpu/device.h"

namespace crsh::gpu {

/// Writes a timestamp at every change of stage and at the end of a submit; sums up the spans a stage.
class Profiler {
 public:
  explicit Profiler(Device& device);
  ~Profiler();
  Profiler(const Profiler&) = delete;
  Profiler& operator=(const Profiler&) = delete;

  /// Milliseconds a stage since the last call.
  [[nodiscard]] std::array<double, stage_count> take_milliseconds();

  // For Recorder only.
  void begin(VkCommandBuffer commands);  ///< of a command buffer: resets the queries, opens the span
  /// Closes the span that is open and opens the next; without commands, only says what the next begin opens.
  void change(VkCommandBuffer commands, Stage stage);
  [[nodiscard]] bool full() const;     ///< no room for another span in this command buffer
  void end(VkCommandBuffer commands);  ///< closes the span
  void collect();                      ///< after the submit is done: reads the queries

 private:
  void write_timestamp(VkCommandBuffer commands);

  Device& device_;
  VkQueryPool pool_ = VK_NULL_HANDLE;  ///< none where the queue has no timestamps: all times are 0 then
  uint64_t tick_mask_ = 0;             ///< the bits of a timestamp that are valid
  std::vector<Stage> spans_;           ///< the stage that began at each timestamp of this command buffer
  Stage stage_ = Stage::raster;
  std::array<double, stage_count> nanoseconds_{};
};

}  // namespace crsh::gpu
