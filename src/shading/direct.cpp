#include "shading/direct.h"

#include <algorithm>

#include "shared/ray.h"

namespace crsh::shading {
namespace {

/// As shading/direct.comp declares it.
struct Push {
  uint32_t surfaces, first_surface, first_slot, first_light, light_count;
};

/// The plan's first segments.
uint32_t lights_of(const rays::BatchPlan& plan) {
  const auto is_shadow = [](const rays::Wanted& s) { return s.kind == shared::kind_shadow; };
  return static_cast<uint32_t>(std::ranges::count_if(plan.segments, is_shadow));
}

}  // namespace

void add_direct(gpu::Recorder& recorder, const DirectIn& in, surfaces::Generation& generation) {
  const rays::BatchPlan& plan = in.plan;
  const uint32_t lights = lights_of(plan);
  if (lights == 0) return;
  const Push push{plan.surfaces, plan.first_surface, 0, plan.segments[0].light, lights};
  const surfaces::Surfaces& s = in.surfaces;
  recorder.dispatch("shading/direct", plan.surfaces, push,
                    {{"positions", s.position},
                     {"normals", s.normal},
                     {"geometrics", s.geometric},
                     {"incomings", s.incoming},
                     {"diffuses", s.diffuse},
                     {"speculars", s.specular},
                     {"lights", in.scene.lights},
                     {"ends", in.ends},
                     {"hits", in.hits},
                     {"direct", generation.direct}},
                    uint64_t(plan.surfaces) * lights);
}

void add_visibility(gpu::Recorder& recorder, const DirectIn& in, const gpu::Buffer& pixels) {
  const struct {
    uint32_t surfaces, first_surface, light_count;
  } push{in.plan.surfaces, in.plan.first_surface, lights_of(in.plan)};
  if (push.light_count == 0) return;
  recorder.dispatch("shading/visibility", push.surfaces, push,
                    {{"diffuse_pixel", in.surfaces.diffuse}, {"ends", in.ends}, {"hits", in.hits}, {"sums", pixels}},
                    uint64_t(push.surfaces) * push.light_count);
}

}  // namespace crsh::shading
