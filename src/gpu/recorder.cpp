#include "gpu/recorder.h"

#include <algorithm>
#include <cstring>

#include "crsh/assertion.h"

namespace crsh::gpu {
namespace {

/// Reads of up to so many bytes are copied within the submit that they wait for; larger ones are downloads of their
/// own.
constexpr uint64_t staging_bytes = 64 << 10;

uint64_t divide_up(uint64_t value, uint64_t by) { return (value + by - 1) / by; }

/// The grid of workgroups: several rows of equal length where one axis cannot hold `groups`.
VkExtent2D dispatch_grid(uint64_t groups, uint32_t max_groups) {
  const uint64_t rows = divide_up(groups, max_groups);
  CRSH_ASSERT(rows <= max_groups, "a dispatch of more workgroups than two axes hold");
  return {static_cast<uint32_t>(divide_up(groups, rows)), static_cast<uint32_t>(rows)};
}

VkRenderingAttachmentInfo attachment_info(const Image& image, bool clear) {
  VkRenderingAttachmentInfo info{.sType = VK_STRUCTURE_TYPE_RENDERING_ATTACHMENT_INFO};
  info.imageView = image.view();
  info.imageLayout = VK_IMAGE_LAYOUT_GENERAL;
  info.loadOp = clear ? VK_ATTACHMENT_LOAD_OP_CLEAR : VK_ATTACHMENT_LOAD_OP_LOAD;  // clear values are all 0
  info.storeOp = VK_ATTACHMENT_STORE_OP_STORE;
  return info;
}

VkExtent2D extent_of(const Attachments& attachments) {
  const Image& image = attachments.colours.empty() ? *attachments.depth : *attachments.colours[0];
  for (const Image* other : attachments.colours)
    CRSH_ASSERT(other->width() == image.width() && other->height() == image.height(), "attachments differ in size");
  CRSH_ASSERT(!attachments.depth ||
                  (attachments.depth->width() == image.width() && attachments.depth->height() == image.height()),
              "the depth attachment differs in size");
  return {image.width(), image.height()};
}

/// The one argument without a name, if any.
const BufferSet* tables_among(Arguments arguments, std::string_view name) {
  const BufferSet* tables = nullptr;
  for (const Argument& argument : arguments)
    if (const auto* set = std::get_if<const BufferSet*>(&argument.bound)) {
      CRSH_ASSERT(!tables, std::string(name) + " is given tables twice");
      tables = *set;
    }
  return tables;
}

}  // namespace

Recorder::Recorder(Device& device)
    : device_(device),
      submission_(device),
      profiler_(device),
      descriptors_(device),
      staging_(device, staging_bytes, "staging of a recorder", true) {}

void Recorder::begin() {
  if (submission_.recording()) return;
  submission_.begin();
  profiler_.begin(submission_.commands());
}

void Recorder::make_room_for_spans() {
  if (submission_.recording() && profiler_.full()) submit();
}

double Recorder::take_pipeline_milliseconds() {
  return device_.take_pipeline_milliseconds() + profiler_.take_first_run_milliseconds();
}

void Recorder::stage(Stage stage) {
  make_room_for_spans();
  profiler_.change(submission_.recording() ? submission_.commands() : VK_NULL_HANDLE, stage);
}

void Recorder::bind(VkPipelineBindPoint point, VkPipeline pipeline, const PipelineLayout& layout,
                    const Reflection& reflection, Bytes push, Arguments arguments, std::string_view name) {
  CRSH_ASSERT(push.size() == reflection.push_bytes, std::string(name) + " takes " +
                                                        std::to_string(reflection.push_bytes) +
                                                        " bytes of push constants, not " + std::to_string(push.size()));
  const VkCommandBuffer commands = submission_.commands();
  vkCmdBindPipeline(commands, point, pipeline);
  if (!reflection.arguments.empty() || !std::ranges::all_of(arguments, is_tables)) {
    const VkDescriptorSet set = descriptors_.describe(layout.set(), reflection, arguments, name);
    vkCmdBindDescriptorSets(commands, point, layout.handle(), argument_set, 1, &set, 0, nullptr);
  }
  bind_tables(point, layout, reflection, arguments, name);
  if (!push.empty())
    vkCmdPushConstants(commands, layout.handle(), layout.stages(), 0, static_cast<uint32_t>(push.size()), push.data());
}

void Recorder::bind_tables(VkPipelineBindPoint point, const PipelineLayout& layout, const Reflection& reflection,
                           Arguments arguments, std::string_view name) {
  const BufferSet* tables = tables_among(arguments, name);
  if (!tables && reflection.tables.empty()) return;
  const std::span<const Declared> given =
      tables ? std::span<const Declared>(tables->members()) : std::span<const Declared>();
  CRSH_ASSERT(std::ranges::equal(given, reflection.tables), "the tables of " + std::string(name) + " are " +
                                                                names_of(reflection.tables) + ", it is given " +
                                                                names_of(given) + ", or they are of other kinds");
  const VkDescriptorSet set = tables->handle();
  vkCmdBindDescriptorSets(submission_.commands(), point, layout.handle(), table_set, 1, &set, 0, nullptr);
}

void Recorder::dispatch_bytes(const Kernel& kernel, uint64_t count, Bytes push, Arguments arguments, uint64_t work) {
  if (count == 0) return;
  const Program& program = device_.program(kernel);
  const bool first = program.first_use().take();
  if (first) make_room_for_spans();
  begin();
  const VkCommandBuffer commands = submission_.commands();
  device_.begin_label(commands, program.name());
  bind(VK_PIPELINE_BIND_POINT_COMPUTE, program.pipeline(), program.layout(), program.reflection(), push, arguments,
       program.name());
  if (first) {  // lavapipe compiles a pipeline when it runs first: it runs on nothing, which is timed apart
    profiler_.begin_first_run(commands);
    vkCmdDispatch(commands, 0, 0, 0);
    submission_.barrier();  // validation takes it for one that writes
    profiler_.end_first_run(commands);
  }
  const VkExtent2D grid = dispatch_grid(divide_up(count, program.group_size()), device_.limits().max_groups);
  vkCmdDispatch(commands, grid.width, grid.height, 1);
  submission_.barrier();
  device_.end_label(commands);
  work_ += work;
}

void Recorder::build(AccelerationStructure& structure, const Buffer& corners) {
  begin();
  structure.record(submission_.commands(), corners, [&] { submission_.barrier(); });
}

void Recorder::begin_rendering(const Attachments& attachments) {
  std::vector<VkRenderingAttachmentInfo> colours;
  for (const Image* image : attachments.colours) colours.push_back(attachment_info(*image, attachments.clear));
  VkRenderingInfo info{.sType = VK_STRUCTURE_TYPE_RENDERING_INFO};
  info.renderArea.extent = extent_of(attachments);
  info.layerCount = 1;
  info.colorAttachmentCount = static_cast<uint32_t>(colours.size());
  info.pColorAttachments = colours.data();
  VkRenderingAttachmentInfo depth{};
  if (attachments.depth) {
    depth = attachment_info(*attachments.depth, attachments.clear);
    info.pDepthAttachment = &depth;
  }
  vkCmdBeginRendering(submission_.commands(), &info);
  const VkViewport viewport{
      0, 0, static_cast<float>(info.renderArea.extent.width), static_cast<float>(info.renderArea.extent.height), 0, 1};
  vkCmdSetViewport(submission_.commands(), 0, 1, &viewport);
  vkCmdSetScissor(submission_.commands(), 0, 1, &info.renderArea);
}

/// The first run of a pipeline, timed apart as in dispatch_bytes: a triangle, with all of the image cut off.
void Recorder::draw_nothing(const DrawProgram& program, const Attachments& attachments, uint32_t first, Bytes push,
                            Arguments arguments) {
  const VkCommandBuffer commands = submission_.commands();
  profiler_.begin_first_run(commands);
  begin_rendering(attachments);
  const VkRect2D nothing{};
  vkCmdSetScissor(commands, 0, 1, &nothing);
  bind(VK_PIPELINE_BIND_POINT_GRAPHICS, program.pipeline(), program.layout(), program.reflection(), push, arguments,
       program.name());
  vkCmdDraw(commands, 3, 1, first, 0);
  vkCmdEndRendering(commands);
  submission_.barrier();
  profiler_.end_first_run(commands);
}

void Recorder::draw_bytes(const DrawProgram& program, const Attachments& attachments, uint32_t first, uint32_t count,
                          Bytes push, Arguments arguments) {
  const bool first_run = count >= 3 && program.first_use().take();
  if (first_run) make_room_for_spans();
  begin();
  const VkCommandBuffer commands = submission_.commands();
  device_.begin_label(commands, program.name());
  if (first_run) draw_nothing(program, attachments, first, push, arguments);
  begin_rendering(attachments);  // also without vertices: it clears
  if (count) {
    bind(VK_PIPELINE_BIND_POINT_GRAPHICS, program.pipeline(), program.layout(), program.reflection(), push, arguments,
         program.name());
    vkCmdDraw(commands, count, 1, first, 0);
  }
  vkCmdEndRendering(commands);
  submission_.barrier();
  device_.end_label(commands);
}

void Recorder::fill(const Buffer& buffer, uint32_t value, uint64_t words, uint64_t first) {
  if (words == 0) return;
  CRSH_ASSERT((first + words) * sizeof(uint32_t) <= buffer.bytes(), "a fill past the end of " + buffer.name());
  begin();
  vkCmdFillBuffer(submission_.commands(), buffer.handle(), first * sizeof(uint32_t), words * sizeof(uint32_t), value);
  submission_.barrier();
}

void Recorder::copy(const Buffer& source, uint64_t source_offset, const Buffer& target, uint64_t target_offset,
                    uint64_t bytes) {
  if (bytes == 0) return;
  CRSH_ASSERT(source_offset + bytes <= source.bytes(), "a copy past the end of " + source.name());
  CRSH_ASSERT(target_offset + bytes <= target.bytes(), "a copy past the end of " + target.name());
  begin();
  const VkBufferCopy region{source_offset, target_offset, bytes};
  vkCmdCopyBuffer(submission_.commands(), source.handle(), target.handle(), 1, &region);
  submission_.barrier();
}

void Recorder::copy(const Image& source, const Buffer& target) {
  CRSH_ASSERT(source.format() != Format::depth32f, "depth cannot be copied");
  const uint64_t pixel_bytes = source.format() == Format::rgba32f ? 16 : 4;
  CRSH_ASSERT(pixel_bytes * source.width() * source.height() <= target.bytes(),
              "an image is larger than " + target.name());
  begin();
  VkBufferImageCopy region{};
  region.imageSubresource = {VK_IMAGE_ASPECT_COLOR_BIT, 0, 0, 1};
  region.imageExtent = {source.width(), source.height(), 1};
  vkCmdCopyImageToBuffer(submission_.commands(), source.handle(), VK_IMAGE_LAYOUT_GENERAL, target.handle(), 1, &region);
  submission_.barrier();
}

void Recorder::ask_before_submit() {
  if (!before_submit_) return;
  try {
    before_submit_();
  } catch (...) {
    submission_.abandon();
    descriptors_.reset();
    work_ = 0;
    throw;
  }
}

void Recorder::submit() {
  if (!submission_.recording()) return;
  ask_before_submit();
  profiler_.end(submission_.commands());
  submission_.submit("rendering");
  profiler_.collect();
  descriptors_.reset();
  work_ = 0;
}

void Recorder::submit_past(uint64_t bound) {
  if (work_ >= bound) submit();
}

void Recorder::read_bytes(const Buffer& buffer, uint64_t offset, void* data, uint64_t bytes) {
  if (bytes > staging_bytes) {
    submit();
    download_bytes(device_, buffer, offset, data, bytes);
    return;
  }
  copy(buffer, offset, staging_, 0, bytes);
  submit();
  if (bytes) std::memcpy(data, staging_.mapped(), bytes);  // nothing may have no place
}

}  // namespace crsh::gpu
