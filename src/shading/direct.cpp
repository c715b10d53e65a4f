#include "shading/direct.h"

#include <algorithm>

#include "shared/ray.h"

namespace crsh::shading {
namespace {

/// As shading/direct.comp declares it.
struct Push {
  uint32_t surfaces, first_surface, first_slot, first_light, light_count;
};

}  // namespace

void add_direct(gpu::Recorder& recorder, const DirectIn& in, Generation& generation) {
  const rays::BatchPlan& plan = in.plan;
  const auto is_shadow = [](const rays::Wanted& s) { return s.kind == shared::kind_shadow; };
  const auto lights = uint32_t(std::count_if(plan.segments.begin(), plan.segments.end(), is_shadow));
  if (lights == 0) return;
  const Push push{plan.surfaces, plan.first_surface, 0, plan.segments[0].light, lights};
  const Surfaces& s = in.surfaces;
  recorder.dispatch("shading/direct", plan.surfaces, push,
                    {s.position, s.normal, s.geometric, s.incoming, s.diffuse, s.specular, in.scene.lights, in.ends,
                     in.hits, generation.direct},
                    uint64_t(plan.surfaces) * lights);
}

}  // namespace crsh::shading
