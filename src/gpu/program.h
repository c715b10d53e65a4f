#pragma once
// Compute and graphics pipelines made from the embedded SPIR-V, checked against what the shader declares.

#include <vulkan/vulkan.h>

#include <chrono>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "gpu/device.h"
#include "gpu/image.h"
#include "gpu/reflection.h"

namespace crsh::gpu {

/// A shader by its path below shaders/ without ".comp" (a variant: "rays/hash@hilbert"), and its
/// specialisation constants as (constant_id, value bits).
struct Kernel {
  Kernel(const char* file) : path(file) {}             // NOLINT: meant to convert
  Kernel(std::string file) : path(std::move(file)) {}  // NOLINT: meant to convert
  Kernel(std::string file, std::vector<std::pair<uint32_t, uint32_t>> values)
      : path(std::move(file)), constants(std::move(values)) {}
  std::string path;
  std::vector<std::pair<uint32_t, uint32_t>> constants;
};

/// The sets and the push block of a pipeline, as reflected.
class PipelineLayout {
 public:
  PipelineLayout(Device& device, const Reflection& reflection, VkShaderStageFlags stages);
  ~PipelineLayout();
  PipelineLayout(const PipelineLayout&) = delete;
  PipelineLayout& operator=(const PipelineLayout&) = delete;

  [[nodiscard]] VkPipelineLayout handle() const { return layout_; }
  /// Of the arguments.
  [[nodiscard]] VkDescriptorSetLayout set() const { return set_; }
  [[nodiscard]] VkShaderStageFlags stages() const { return stages_; }

 private:
  Device& device_;
  VkShaderStageFlags stages_;
  VkDescriptorSetLayout set_ = VK_NULL_HANDLE, tables_ = VK_NULL_HANDLE;
  VkPipelineLayout layout_ = VK_NULL_HANDLE;
};

/// Adds the host's time between its beginning and end to what the device has spent on pipelines.
class PipelineTimer {
 public:
  explicit PipelineTimer(Device& device) : device_(device) {}
  ~PipelineTimer();
  PipelineTimer(const PipelineTimer&) = delete;
  PipelineTimer& operator=(const PipelineTimer&) = delete;

 private:
  Device& device_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
};

/// A kernel's specialisation constants as Vulkan takes them. It must stay where it is while it is used.
class Constants {
 public:
  Constants(const Device& device, const Kernel& kernel);
  Constants(const Constants&) = delete;
  Constants& operator=(const Constants&) = delete;
  [[nodiscard]] const VkSpecializationInfo* info() const { return &info_; }

 private:
  std::vector<VkSpecializationMapEntry> entries_;
  std::vector<uint32_t> values_;
  VkSpecializationInfo info_{};
};

/// Whether something is used for the first time.
class FirstUse {
 public:
  [[nodiscard]] bool take() const { return std::exchange(first_, false); }

 private:
  mutable bool first_ = true;
};

/// A compute pipeline with its layout. Where the shader tells lanes apart and subgroups divide its workgroup, they are
/// full.
class Program {
 public:
  Program(Device& device, const Kernel& kernel);
  ~Program();
  Program(const Program&) = delete;
  Program& operator=(const Program&) = delete;

  [[nodiscard]] const std::string& name() const { return name_; }
  /// Invocations of a workgroup.
  [[nodiscard]] uint32_t group_size() const { return group_size_; }
  [[nodiscard]] const Reflection& reflection() const { return reflection_; }
  [[nodiscard]] const PipelineLayout& layout() const { return layout_; }
  [[nodiscard]] VkPipeline pipeline() const { return pipeline_; }
  [[nodiscard]] const FirstUse& first_use() const { return first_use_; }

 private:
  Device& device_;
  FirstUse first_use_;
  std::string name_;
  Reflection reflection_;
  uint32_t group_size_ = 1;
  PipelineLayout layout_;
  VkPipeline pipeline_ = VK_NULL_HANDLE;
};

/// A graphics pipeline of "path.vert" and "path.frag" (vertex pulling: no vertex input; triangle list; no face culling;
/// depth test GREATER with write: depth is reversed, cleared to 0). Vertex and fragment shader share sets and push
/// block, and specialisation constants.
class DrawProgram {
 public:
  DrawProgram(Device& device, const Kernel& kernel, std::span<const Format> colours, Format depth = Format::depth32f);
  ~DrawProgram();
  DrawProgram(const DrawProgram&) = delete;
  DrawProgram& operator=(const DrawProgram&) = delete;

  [[nodiscard]] const std::string& name() const { return name_; }
  [[nodiscard]] const Reflection& reflection() const { return reflection_; }
  [[nodiscard]] const PipelineLayout& layout() const { return layout_; }
  [[nodiscard]] VkPipeline pipeline() const { return pipeline_; }
  [[nodiscard]] const FirstUse& first_use() const { return first_use_; }

 private:
  Device& device_;
  FirstUse first_use_;
  std::string name_;
  Reflection reflection_;  ///< of both stages together
  PipelineLayout layout_;
  VkPipeline pipeline_ = VK_NULL_HANDLE;
};

}  // namespace crsh::gpu
