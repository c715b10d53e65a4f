#include "objects/device_hierarchy.h"

#include <fmt/format.h>

#include "crsh/error.h"

namespace crsh::objects {
namespace {

/// Made once: every frame has as many triangles.
void make(gpu::Recorder& recorder, uint32_t triangles, DeviceHierarchy& h) {
  gpu::Device& device = recorder.device();
  const uint64_t bytes = 3 * uint64_t(triangles) * sizeof(glm::vec4);
  if (bytes > device.limits().max_binding)
    throw UserError(fmt::format("{} triangles are too many for ray queries on {}", triangles, device.info().name),
                    Mend::other_algorithm);
  h.corners.reserve(device, bytes, "corners of the acceleration structure");
  h.structure = std::make_unique<gpu::AccelerationStructure>(device, triangles);
}

}  // namespace

void require_ray_queries(const gpu::Device& device) {
  if (device.info().ray_queries) return;
  throw UserError(fmt::format("{} has no ray queries (VK_KHR_ray_query)", device.info().name),
                  Mend::other_algorithm_or_device);
}

void update(gpu::Recorder& recorder, const In& in, DeviceHierarchy& h) {
  const uint32_t triangles = in.scene.triangle_count;
  if (triangles == 0 || (h.builds > 0 && h.pose == in.pose)) return;
  recorder.stage(Stage::object_hierarchy);
  if (!h.structure) make(recorder, triangles, h);
  recorder.dispatch("objects/soup", triangles, triangles,
                    {{"corner_a", in.scene.corner_a},
                     {"corner_b", in.scene.corner_b},
                     {"corner_c", in.scene.corner_c},
                     {"corners", h.corners}},
                    triangles);
  recorder.build(*h.structure, h.corners);
  recorder.submit();
  h.pose = in.pose;
  ++h.builds;
}

}  // namespace crsh::objects
