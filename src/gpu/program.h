#pragma once
// Compute and graphics pipelines made from the embedded SPIR-V, checked against what the shader declares.

#include <vulkan/vulkan.h>

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "gpu/device.h"
#include "gpu/image.h"

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

/// The SPIR-V words of a shader built from shaders/: "coherence/flag_heads.comp", "raster/surface.frag", or a variant
/// "rays/hash@hilbert.comp". Asserts that it exists.
[[nodiscard]] std::span<const uint32_t> embedded_spirv(std::string_view file);
/// Every embedded file, sorted: what the build found (keys and bounds are listed from this).
[[nodiscard]] std::vector<std::string_view> embedded_files();

/// The default value of a shader's specialisation constant: what a variant declares of itself. Asserts that it has one.
[[nodiscard]] uint32_t declared_constant(std::string_view file, uint32_t constant_id);

/// What a binding is, in the order of Argument's alternatives (gpu/descriptors.h).
enum class Resource { storage_buffer, storage_image, acceleration_structure };

/// What a module declares in set 0 and for itself; the small part of SPIR-V reflection that dispatches need.
struct Reflection {
  std::vector<Resource> resources;  ///< by binding, 0 .. n-1 without gaps (asserted)
  uint32_t push_bytes = 0;          ///< size of the push constant block, at most 128 (asserted)
  uint32_t local_size[3] = {1, 1, 1};
  /// The constant_id behind each local size (layout(local_size_x_id = 0)), or no_constant.
  uint32_t local_size_id[3] = {no_constant, no_constant, no_constant};
  static constexpr uint32_t no_constant = UINT32_MAX;
  bool tells_lanes_apart = false;  ///< it reads gl_SubgroupID or gl_SubgroupInvocationID
};
[[nodiscard]] Reflection reflect(std::span<const uint32_t> spirv);
/// Of modules that share set 0 and the push block, as a vertex and a fragment shader do.
[[nodiscard]] Reflection reflect_together(std::span<const std::span<const uint32_t>> modules);

/// Set 0 and the push block of a pipeline, as reflected.
class PipelineLayout {
 public:
  PipelineLayout(Device& device, const Reflection& reflection, VkShaderStageFlags stages);
  ~PipelineLayout();
  PipelineLayout(const PipelineLayout&) = delete;
  PipelineLayout& operator=(const PipelineLayout&) = delete;

  [[nodiscard]] VkPipelineLayout handle() const { return layout_; }
  [[nodiscard]] VkDescriptorSetLayout set() const { return set_; }
  [[nodiscard]] VkShaderStageFlags stages() const { return stages_; }

 private:
  Device& device_;
  VkShaderStageFlags stages_;
  VkDescriptorSetLayout set_ = VK_NULL_HANDLE;
  VkPipelineLayout layout_ = VK_NULL_HANDLE;
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

 private:
  Device& device_;
  std::string name_;
  Reflection reflection_;
  uint32_t group_size_ = 1;
  PipelineLayout layout_;
  VkPipeline pipeline_ = VK_NULL_HANDLE;
};

/// A graphics pipeline of "path.vert" and "path.frag" (vertex pulling: no vertex input; triangle list; no face culling;
/// depth test GREATER with write: depth is reversed, cleared to 0). Vertex and fragment shader share set 0 and the push
/// block.
class DrawProgram {
 public:
  DrawProgram(Device& device, std::string_view path, std::span<const Format> colours, Format depth = Format::depth32f);
  ~DrawProgram();
  DrawProgram(const DrawProgram&) = delete;
  DrawProgram& operator=(const DrawProgram&) = delete;

  [[nodiscard]] const std::string& name() const { return name_; }
  [[nodiscard]] const Reflection& reflection() const { return reflection_; }
  [[nodiscard]] const PipelineLayout& layout() const { return layout_; }
  [[nodiscard]] VkPipeline pipeline() const { return pipeline_; }

 private:
  Device& device_;
  std::string name_;
  Reflection reflection_;  ///< of both stages together
  PipelineLayout layout_;
  VkPipeline pipeline_ = VK_NULL_HANDLE;
};

}  // namespace crsh::gpu
