// The only kind of graphics pipeline.

#include <array>

#include "gpu/program.h"
#include "gpu/shader_module.h"

namespace crsh::gpu {
namespace {

Reflection reflect_both(const std::string& path) {
  const std::array modules = {embedded_spirv(path + ".vert"), embedded_spirv(path + ".frag")};
  return reflect_together(modules);
}

/// The fixed states: triangles, no culling, reversed depth, every attachment written as it is.
struct FixedStates {
  VkPipelineVertexInputStateCreateInfo input{.sType = VK_STRUCTURE_TYPE_PIPELINE_VERTEX_INPUT_STATE_CREATE_INFO};
  VkPipelineInputAssemblyStateCreateInfo assembly{.sType = VK_STRUCTURE_TYPE_PIPELINE_INPUT_ASSEMBLY_STATE_CREATE_INFO};
  VkPipelineViewportStateCreateInfo viewport{.sType = VK_STRUCTURE_TYPE_PIPELINE_VIEWPORT_STATE_CREATE_INFO};
  VkPipelineRasterizationStateCreateInfo raster{.sType = VK_STRUCTURE_TYPE_PIPELINE_RASTERIZATION_STATE_CREATE_INFO};
  VkPipelineMultisampleStateCreateInfo samples{.sType = VK_STRUCTURE_TYPE_PIPELINE_MULTISAMPLE_STATE_CREATE_INFO};
  VkPipelineDepthStencilStateCreateInfo depth{.sType = VK_STRUCTURE_TYPE_PIPELINE_DEPTH_STENCIL_STATE_CREATE_INFO};
  VkPipelineColorBlendStateCreateInfo blend{.sType = VK_STRUCTURE_TYPE_PIPELINE_COLOR_BLEND_STATE_CREATE_INFO};
  VkPipelineDynamicStateCreateInfo dynamic{.sType = VK_STRUCTURE_TYPE_PIPELINE_DYNAMIC_STATE_CREATE_INFO};
  std::vector<VkPipelineColorBlendAttachmentState> attachments;
  std::array<VkDynamicState, 2> dynamic_states = {VK_DYNAMIC_STATE_VIEWPORT, VK_DYNAMIC_STATE_SCISSOR};

  explicit FixedStates(size_t colours) {
    assembly.topology = VK_PRIMITIVE_TOPOLOGY_TRIANGLE_LIST;
    viewport.viewportCount = viewport.scissorCount = 1;
    raster.cullMode = VK_CULL_MODE_NONE;
    raster.lineWidth = 1;
    samples.rasterizationSamples = VK_SAMPLE_COUNT_1_BIT;
    depth.depthTestEnable = depth.depthWriteEnable = VK_TRUE;
    depth.depthCompareOp = VK_COMPARE_OP_GREATER;
    VkPipelineColorBlendAttachmentState plain{};
    plain.colorWriteMask =
        VK_COLOR_COMPONENT_R_BIT | VK_COLOR_COMPONENT_G_BIT | VK_COLOR_COMPONENT_B_BIT | VK_COLOR_COMPONENT_A_BIT;
    attachments.assign(colours, plain);
    blend.attachmentCount = static_cast<uint32_t>(colours);
    blend.pAttachments = attachments.data();
    dynamic.dynamicStateCount = static_cast<uint32_t>(dynamic_states.size());
    dynamic.pDynamicStates = dynamic_states.data();
  }
  FixedStates(const FixedStates&) = delete;  // its parts point at one another

  void fill(VkGraphicsPipelineCreateInfo& info) const {
    info.pVertexInputState = &input;
    info.pInputAssemblyState = &assembly;
    info.pViewportState = &viewport;
    info.pRasterizationState = &raster;
    info.pMultisampleState = &samples;
    info.pDepthStencilState = &depth;
    info.pColorBlendState = &blend;
    info.pDynamicState = &dynamic;
  }
};

}  // namespace

DrawProgram::DrawProgram(Device& device, const Kernel& kernel, std::span<const Format> colours, Format depth)
    : device_(device),
      name_(kernel.path),
      reflection_(reflect_both(name_)),
      layout_(device, reflection_, VK_SHADER_STAGE_VERTEX_BIT | VK_SHADER_STAGE_FRAGMENT_BIT) {
  const PipelineTimer timer(device);
  std::vector<VkFormat> formats;
  for (const Format format : colours) formats.push_back(vulkan_format(format));
  VkPipelineRenderingCreateInfo rendering{.sType = VK_STRUCTURE_TYPE_PIPELINE_RENDERING_CREATE_INFO};
  rendering.colorAttachmentCount = static_cast<uint32_t>(formats.size());
  rendering.pColorAttachmentFormats = formats.data();
  rendering.depthAttachmentFormat = vulkan_format(depth);

  const ShaderModule vertex(device, name_ + ".vert"), fragment(device, name_ + ".frag");
  const Constants constants(device, kernel);
  std::array stages = {vertex.stage(VK_SHADER_STAGE_VERTEX_BIT), fragment.stage(VK_SHADER_STAGE_FRAGMENT_BIT)};
  for (VkPipelineShaderStageCreateInfo& stage : stages) stage.pSpecializationInfo = constants.info();
  const FixedStates states(colours.size());
  VkGraphicsPipelineCreateInfo info{.sType = VK_STRUCTURE_TYPE_GRAPHICS_PIPELINE_CREATE_INFO};
  info.pNext = &rendering;
  info.stageCount = static_cast<uint32_t>(stages.size());
  info.pStages = stages.data();
  info.layout = layout_.handle();
  states.fill(info);
  const std::string doing = "compiling " + name_;
  check(vkCreateGraphicsPipelines(device.handle(), VK_NULL_HANDLE, 1, &info, nullptr, &pipeline_), doing.c_str());
  device.name_object(VK_OBJECT_TYPE_PIPELINE, reinterpret_cast<uint64_t>(pipeline_), name_);
}

DrawProgram::~DrawProgram() { vkDestroyPipeline(device_.handle(), pipeline_, nullptr); }

}  // namespace crsh::gpu
