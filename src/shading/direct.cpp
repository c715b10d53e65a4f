#include "shading/direct.h"

#include "crsh/kinds.h"

namespace crsh::shading {
namespace {

/// As shading/direct.comp declares it.
struct Push {
  uint32_t surfaces, first_surface, first_slot, first_light, light_count;
};

}  // namespace

void add_direct(gpu::Recorder& recorder, const DirectIn& in, surfaces::Generation& generation) {
  const rays::BatchPlan& plan = in.plan;
  const surfaces::Surfaces& s = in.surfaces;
  for (const rays::KindRun& run : rays::runs_of(plan)) {
    const RayKind& kind = ray_kinds[run.kind];
    if (!kind.any_hit || !kind.adds_light) continue;
    const Push push{plan.surfaces, plan.first_surface, run.first * plan.surfaces, plan.segments[run.first].light,
                    run.segments};
    recorder.dispatch(in.scene.with_lobes("shading/direct"), plan.surfaces, push,
                      {{"positions", s.position},
                       {"normals", s.normal},
                       {"geometrics", s.geometric},
                       {"incomings", s.incoming},
                       {"diffuses", s.diffuse},
                       {"speculars", s.specular},
                       {"lights", in.scene.lights},
                       {"ends", in.ends},
                       {"hits", in.hits},
                       {"direct", generation.direct},
                       {"surface_lobes", s.lobes},
                       {"footprints", s.footprint}},
                      uint64_t(plan.surfaces) * run.segments);
  }
}

void add_visibility(gpu::Recorder& recorder, const DirectIn& in, uint32_t kind, const gpu::Buffer& pixels) {
  for (const rays::KindRun& run : rays::runs_of(in.plan)) {
    if (run.kind != kind) continue;
    const struct {
      uint32_t surfaces, first_surface, first_slot, segments;
    } push{in.plan.surfaces, in.plan.first_surface, run.first * in.plan.surfaces, run.segments};
    recorder.dispatch("shading/visibility", push.surfaces, push,
                      {{"diffuse_pixel", in.surfaces.diffuse}, {"ends", in.ends}, {"hits", in.hits}, {"sums", pixels}},
                      uint64_t(push.surfaces) * push.segments);
  }
}

}  // namespace crsh::shading
