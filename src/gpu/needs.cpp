#include "gpu/needs.h"

#include <algorithm>
#include <array>

#include "gpu/program.h"

namespace crsh::gpu {
namespace {

void add(StageLimits& sum, std::span<const Declared> declared) {
  for (const Declared& one : declared) {
    sum.storage_buffers += one.kind == Resource::storage_buffer;
    sum.storage_images += one.kind == Resource::storage_image;
    sum.sampled_images += one.kind == Resource::texel_buffer;
  }
}

bool ends_with(std::string_view file, std::string_view end) { return file.ends_with(end); }

/// Of a compute shader, or of a fragment shader with the vertex shader that it shares a pipeline with.
Reflection reflect_pipeline(std::string_view file) {
  if (!ends_with(file, ".frag")) return reflect(embedded_spirv(file));
  const std::string vertex = std::string(file.substr(0, file.size() - 5)) + ".vert";
  const std::array modules = {embedded_spirv(vertex), embedded_spirv(file)};
  return reflect_together(modules);
}

StageLimits find_most_needed() {
  StageLimits most;
  for (const std::string_view file : embedded_files()) {
    if (ends_with(file, ".vert")) continue;
    const StageLimits needed = needs_of(reflect_pipeline(file));
    for (const StageLimit& limit : stage_limits) most.*limit.value = std::max(most.*limit.value, needed.*limit.value);
  }
  return most;
}

}  // namespace

StageLimits needs_of(const Reflection& reflection) {
  StageLimits needed;
  add(needed, reflection.arguments);
  add(needed, reflection.tables);
  needed.colour_attachments = reflection.colour_attachments;
  if (needed.colour_attachments)
    needed.fragment_outputs = needed.colour_attachments + needed.storage_buffers + needed.storage_images;
  return needed;
}

const StageLimits& max_needed() {
  static const StageLimits needed = find_most_needed();
  return needed;
}

std::string too_few(const StageLimits& available, const StageLimits& needed) {
  for (const StageLimit& limit : stage_limits)
    if (available.*limit.value < needed.*limit.value)
      return "it binds " + std::to_string(available.*limit.value) + " " + limit.name + " at once, " +
             std::to_string(needed.*limit.value) + " are needed";
  return "";
}

std::string needs_text(const StageLimits& available, const StageLimits& needed) {
  std::string text;
  for (const StageLimit& limit : stage_limits)
    text += (text.empty() ? "" : ", ") + std::to_string(needed.*limit.value) + " of " +
            std::to_string(available.*limit.value) + " " + limit.name;
  return text;
}

}  // namespace crsh::gpu
