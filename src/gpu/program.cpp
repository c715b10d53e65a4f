#include "gpu/program.h"

#include <array>

#include "crsh/assertion.h"
#include "gpu/buffer_set.h"
#include "gpu/shader_module.h"

namespace crsh::gpu {
namespace {

/// The constant_id of `lanes_reconverge` (shaders/lib/counters.glsl). Shaders without it take no notice.
constexpr uint32_t reconvergence_constant = 17;

/// The value a kernel gives to a specialisation constant, else the shader's own.
uint32_t specialised(const Kernel& kernel, uint32_t constant_id, uint32_t otherwise) {
  for (const auto& [id, value] : kernel.constants)
    if (id == constant_id) return value;
  return otherwise;
}

/// Invocations of a workgroup along an axis.
uint32_t group_edge(const Kernel& kernel, const Reflection& reflection, int axis) {
  return specialised(kernel, reflection.local_size_id[axis], reflection.local_size[axis]);
}

uint32_t count_group(const Kernel& kernel, const Reflection& reflection) {
  uint32_t size = 1;
  for (int axis = 0; axis < 3; ++axis) size *= group_edge(kernel, reflection, axis);
  return size;
}

}  // namespace

ShaderModule::ShaderModule(Device& device, std::string_view file) : device_(device) {
  const std::vector<uint32_t> spirv = with_promises(embedded_spirv(file), device.promises());
  VkShaderModuleCreateInfo info{.sType = VK_STRUCTURE_TYPE_SHADER_MODULE_CREATE_INFO};
  info.codeSize = spirv.size() * sizeof(uint32_t);
  info.pCode = spirv.data();
  check(vkCreateShaderModule(device.handle(), &info, nullptr, &module_), "loading a shader");
}

ShaderModule::~ShaderModule() { vkDestroyShaderModule(device_.handle(), module_, nullptr); }

VkPipelineShaderStageCreateInfo ShaderModule::stage(VkShaderStageFlagBits stage) const {
  VkPipelineShaderStageCreateInfo info{.sType = VK_STRUCTURE_TYPE_PIPELINE_SHADER_STAGE_CREATE_INFO};
  info.stage = stage;
  info.module = module_;
  info.pName = "main";
  return info;
}

PipelineLayout::PipelineLayout(Device& device, const Reflection& reflection, VkShaderStageFlags stages)
    : device_(device), stages_(stages), set_(make_set_layout(device, reflection.arguments, stages)) {
  if (!reflection.tables.empty()) tables_ = make_set_layout(device, reflection.tables, table_stages);
  const std::array sets = {set_, tables_};
  const VkPushConstantRange range{stages, 0, reflection.push_bytes};
  VkPipelineLayoutCreateInfo info{.sType = VK_STRUCTURE_TYPE_PIPELINE_LAYOUT_CREATE_INFO};
  info.setLayoutCount = tables_ ? 2 : 1;
  info.pSetLayouts = sets.data();
  info.pushConstantRangeCount = reflection.push_bytes ? 1 : 0;
  info.pPushConstantRanges = &range;
  check(vkCreatePipelineLayout(device.handle(), &info, nullptr, &layout_), "making a pipeline layout");
}

PipelineLayout::~PipelineLayout() {
  vkDestroyPipelineLayout(device_.handle(), layout_, nullptr);
  vkDestroyDescriptorSetLayout(device_.handle(), set_, nullptr);
  vkDestroyDescriptorSetLayout(device_.handle(), tables_, nullptr);
}

Constants::Constants(const Device& device, const Kernel& kernel) {
  const auto add = [this](uint32_t id, uint32_t value) {
    entries_.push_back({id, static_cast<uint32_t>(values_.size() * sizeof(uint32_t)), sizeof(uint32_t)});
    values_.push_back(value);
  };
  for (const auto& [id, value] : kernel.constants) add(id, value);
  add(reconvergence_constant, device.reconverges());
  info_ = {static_cast<uint32_t>(entries_.size()), entries_.data(), values_.size() * sizeof(uint32_t), values_.data()};
}

PipelineTimer::~PipelineTimer() {
  device_.add_pipeline_milliseconds(
      std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start_).count());
}

Program::Program(Device& device, const Kernel& kernel)
    : device_(device),
      name_(kernel.path),
      reflection_(reflect(embedded_spirv(kernel.path + ".comp"))),
      group_size_(count_group(kernel, reflection_)),
      layout_(device, reflection_, VK_SHADER_STAGE_COMPUTE_BIT) {
  const PipelineTimer timer(device);
  const Constants constants(device, kernel);
  const ShaderModule module(device, kernel.path + ".comp");
  VkComputePipelineCreateInfo info{.sType = VK_STRUCTURE_TYPE_COMPUTE_PIPELINE_CREATE_INFO};
  info.stage = module.stage(VK_SHADER_STAGE_COMPUTE_BIT);
  info.stage.pSpecializationInfo = constants.info();
  if (reflection_.tells_lanes_apart && group_edge(kernel, reflection_, 0) % device.info().subgroup_size == 0)
    info.stage.flags = VK_PIPELINE_SHADER_STAGE_CREATE_REQUIRE_FULL_SUBGROUPS_BIT;
  info.layout = layout_.handle();
  const std::string doing = "compiling " + name_;
  check(vkCreateComputePipelines(device.handle(), VK_NULL_HANDLE, 1, &info, nullptr, &pipeline_), doing.c_str());
  device.name_object(VK_OBJECT_TYPE_PIPELINE, reinterpret_cast<uint64_t>(pipeline_), name_);
}

Program::~Program() { vkDestroyPipeline(device_.handle(), pipeline_, nullptr); }

}  // namespace crsh::gpu
