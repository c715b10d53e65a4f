#include "rays/create.h"

#include <algorithm>

#include "primitives/grow.h"
#include "shared/ray.h"

namespace crsh::rays {
namespace {

/// As rays/shadow.comp declares it.
struct ShadowPush {
  uint32_t surfaces, first_surface, first_slot, count, first_light;
};

/// As rays/closest.glsl declares it.
struct ClosestPush {
  uint32_t surfaces, first_surface, first_slot, mirror;
};

std::vector<Wanted> wanted_segments(const PlanIn& in) {
  std::vector<Wanted> all;
  for (uint32_t kind = 0; kind < kind_count; ++kind) {
    const uint32_t number = kind == shared::kind_shadow ? in.lights : 1;
    for (uint32_t i = 0; in.kinds[kind] && i < number; ++i) all.push_back({kind, i});
  }
  return all;
}

/// Segments in their order, at most `most` a group, and where kinds are not mixed, only one kind a group.
std::vector<std::vector<Wanted>> grouped(const std::vector<Wanted>& all, uint32_t most, bool mixed) {
  std::vector<std::vector<Wanted>> groups;
  for (const Wanted& segment : all) {
    const bool fits =
        !groups.empty() && groups.back().size() < most && (mixed || groups.back().back().kind == segment.kind);
    if (!fits) groups.emplace_back();
    groups.back().push_back(segment);
  }
  return groups;
}

void create_shadow(gpu::Recorder& recorder, const CreateIn& in, uint32_t first, uint32_t lights, const Sparse& out) {
  const ShadowPush push{in.plan.surfaces, in.plan.first_surface, first * in.plan.surfaces, lights * in.plan.surfaces,
                        in.plan.segments[first].light};
  recorder.dispatch(std::string(ray_kinds[shared::kind_shadow].creation), push.count, push,
                    {{"positions", in.surfaces.position},
                     {"geometrics", in.surfaces.geometric},
                     {"lights", in.scene.lights},
                     {"triangle_spheres", in.scene.triangle_spheres},
                     {"rays", out.rays},
                     {"flags", out.flags}});
}

void create_closest(gpu::Recorder& recorder, const CreateIn& in, uint32_t segment, const Sparse& out,
                    gpu::Buffer& weights) {
  const uint32_t kind = in.plan.segments[segment].kind;
  const surfaces::Surfaces& s = in.surfaces;
  primitives::grow(recorder, weights, s.count * uint64_t(sizeof(glm::vec4)), "ray weights");
  const bool mirror = kind == shared::kind_reflection && in.override_mirror;
  const ClosestPush push{in.plan.surfaces, in.plan.first_surface, segment * in.plan.surfaces, mirror ? 1u : 0u};
  recorder.dispatch(std::string(ray_kinds[kind].creation), push.surfaces, push,
                    {{"positions", s.position},
                     {"normals", s.normal},
                     {"geometrics", s.geometric},
                     {"incomings", s.incoming},
                     {"diffuses", s.diffuse},
                     {"speculars", s.specular},
                     {"triangle_spheres", in.scene.triangle_spheres},
                     {"rays", out.rays},
                     {"flags", out.flags},
                     {"weights", weights}});
}

}  // namespace

std::vector<BatchPlan> plan_batches(const PlanIn& in) {
  const std::vector<Wanted> all = wanted_segments(in);
  if (all.empty() || in.surfaces == 0) return {};
  const uint32_t portion = std::min(in.surfaces, in.most_slots);
  const uint32_t most = std::min(most_segments, in.most_slots / portion);
  std::vector<BatchPlan> plans;
  for (uint32_t first = 0; first < in.surfaces; first += portion)
    for (const std::vector<Wanted>& group : grouped(all, most, in.mixed))
      plans.push_back({group, first, std::min(portion, in.surfaces - first)});
  return plans;
}

std::array<bool, kind_count> kinds_at(const RenderOptions& options, uint32_t bounce) {
  std::array<bool, kind_count> kinds{};
  for (size_t kind = 0; kind < kind_count; ++kind)
    kinds[kind] = options.rays[kind] && (bounce < options.bounces || ray_kinds[kind].at_last_bounce);
  return kinds;
}

void create(gpu::Recorder& recorder, const CreateIn& in, Sparse& out, surfaces::Generation& generation) {
  const BatchPlan& plan = in.plan;
  out.slots = plan.slots();
  primitives::grow(recorder, out.rays, out.slots * uint64_t(sizeof(shared::Ray)), "sparse rays");
  primitives::grow(recorder, out.flags, primitives::quad_bytes(out.slots), "head flags");
  uint32_t lights = 0;
  while (lights < plan.segments.size() && plan.segments[lights].kind == shared::kind_shadow) ++lights;
  if (lights) create_shadow(recorder, in, 0, lights, out);
  for (uint32_t segment = lights; segment < plan.segments.size(); ++segment)
    create_closest(recorder, in, segment, out,
                   plan.segments[segment].kind == shared::kind_reflection ? generation.reflection_weight
                                                                          : generation.refraction_weight);
}

}  // namespace crsh::rays
