#pragma once
// GPU time a stage, from timestamps.

#include <vulkan/vulkan.h>

#include <array>
#include <cstdint>
#include <vector>

#include "crsh/stage.h"
#include "gpu/device.h"

namespace crsh::gpu {

/// Writes a timestamp at every change of stage and at the end of a submit, and sums up the time of each stage. First
/// runs of pipelines, in which some drivers compile, have spans of their own that are no stage's.
class Profiler {
 public:
  explicit Profiler(Device& device);
  ~Profiler();
  Profiler(const Profiler&) = delete;
  Profiler& operator=(const Profiler&) = delete;

  /// Milliseconds a stage since the last call.
  [[nodiscard]] std::array<double, stage_count> take_milliseconds();
  /// Milliseconds of first runs since the last call.
  [[nodiscard]] double take_first_run_milliseconds();

  // For Recorder only.
  void begin(VkCommandBuffer commands);  ///< of a command buffer: resets the queries, opens the span
  /// Closes the span that is open and opens the next; without commands, only says what the next begin opens.
  void change(VkCommandBuffer commands, Stage stage);
  void begin_first_run(VkCommandBuffer commands);
  void end_first_run(VkCommandBuffer commands);  ///< goes on with the stage
  [[nodiscard]] bool full() const;               ///< no room for the next spans in this command buffer
  void end(VkCommandBuffer commands);            ///< closes the span
  void collect();                                ///< after the submit is done: reads the queries

 private:
  /// Spans of a stage have its number, those of first runs the one behind.
  static constexpr size_t first_run = stage_count;
  void write_timestamp(VkCommandBuffer commands, size_t span);

  Device& device_;
  VkQueryPool pool_ = VK_NULL_HANDLE;  ///< none where the queue has no timestamps: all times are 0 then
  uint64_t tick_mask_ = 0;             ///< the bits of a timestamp that are valid
  std::vector<size_t> spans_;          ///< what began at each timestamp of this command buffer
  Stage stage_ = Stage::raster;
  std::array<double, stage_count + 1> nanoseconds_{};
};

}  // namespace crsh::gpu
