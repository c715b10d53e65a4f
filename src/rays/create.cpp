#include "rays/create.h"

#include <algorithm>

#include "primitives/grow.h"
#include "shared/ray.h"

namespace crsh::rays {
namespace {

/// As rays/create.glsl declares it.
struct Push {
  uint32_t surfaces, first_surface, first_slot, count, kind, first_light, mirror, sample, seed;
  float scene_edge;
};

std::vector<Wanted> wanted_segments(const PlanIn& in) {
  std::vector<Wanted> all;
  for (uint32_t kind = 0; kind < kind_count; ++kind) {
    const uint32_t number = ray_kinds[kind].one_a_light ? in.lights : 1;
    for (uint32_t i = 0; in.kinds[kind] && i < number; ++i) all.push_back({kind, i});
  }
  return all;
}

/// Splits segments, in their order, into groups of at most `most`; where kinds are not mixed, a group has only one
/// kind.
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

Push push_of(const CreateIn& in, const KindRun& run) {
  const BatchPlan& plan = in.plan;
  return {.surfaces = plan.surfaces,
          .first_surface = plan.first_surface,
          .first_slot = run.first * plan.surfaces,
          .count = run.segments * plan.surfaces,
          .kind = run.kind,
          .first_light = plan.segments[run.first].light,
          .mirror = in.override_mirror && ray_kinds[run.kind].mirrors_everything ? 1u : 0u,
          .sample = in.sample,
          .seed = in.seed,
          .scene_edge = in.scene.bounds.longest_edge()};
}

/// What every creation shader may read, and where its rays go.
std::vector<gpu::Argument> arguments_of(const CreateIn& in, const Sparse& out) {
  const surfaces::Surfaces& s = in.surfaces;
  return {{"positions", s.position},   {"normals", s.normal},
          {"geometrics", s.geometric}, {"incomings", s.incoming},
          {"diffuses", s.diffuse},     {"speculars", s.specular},
          {"lights", in.scene.lights}, {"triangle_spheres", in.scene.triangle_spheres},
          {"rays", out.rays},          {"flags", out.flags},
          {"surface_lobes", s.lobes}};
}

/// `weights`: of the kind's rays, where it takes closest hits; else null.
void create_run(gpu::Recorder& recorder, const CreateIn& in, const KindRun& run, const Sparse& out,
                gpu::Buffer* weights) {
  std::vector<gpu::Argument> arguments = arguments_of(in, out);
  if (weights) {
    primitives::grow(recorder, *weights, in.surfaces.count * uint64_t(sizeof(glm::vec4)), "ray weights");
    arguments.push_back({"weights", *weights});
    arguments.push_back({"footprints", in.surfaces.footprint});
  }
  const Push push = push_of(in, run);
  recorder.dispatch(in.scene.with_lobes(std::string(ray_kinds[run.kind].creation)), push.count, push, arguments);
}

}  // namespace

std::vector<BatchPlan> plan_batches(const PlanIn& in) {
  const std::vector<Wanted> all = wanted_segments(in);
  if (all.empty() || in.surfaces == 0) return {};
  const uint32_t surfaces_a_plan = std::min(in.surfaces, in.max_slots);
  const uint32_t most = std::min(max_segments, in.max_slots / surfaces_a_plan);
  std::vector<BatchPlan> plans;
  for (uint32_t first = 0; first < in.surfaces; first += surfaces_a_plan)
    for (const std::vector<Wanted>& group : grouped(all, most, in.mixed))
      plans.push_back({group, first, std::min(surfaces_a_plan, in.surfaces - first)});
  return plans;
}

std::vector<KindRun> runs_of(const BatchPlan& plan) {
  std::vector<KindRun> runs;
  for (uint32_t segment = 0; segment < plan.segments.size(); ++segment) {
    const uint32_t kind = plan.segments[segment].kind;
    if (runs.empty() || runs.back().kind != kind) runs.push_back({kind, segment, 0});
    ++runs.back().segments;
  }
  return runs;
}

PerKind<bool> kinds_at(const RenderOptions& options, uint32_t bounce) {
  return PerKind<bool>(
      [&](uint32_t kind) { return options.rays[kind] && ray_kinds[kind].cast_at(bounce, options.bounces); });
}

void create(gpu::Recorder& recorder, const CreateIn& in, Sparse& out, surfaces::Generation& generation) {
  out.slots = in.plan.slots();
  primitives::grow(recorder, out.rays, out.slots * uint64_t(sizeof(shared::Ray)), "sparse rays");
  primitives::grow(recorder, out.flags, primitives::quad_bytes(out.slots), "head flags");
  for (const KindRun& run : runs_of(in.plan))
    create_run(recorder, in, run, out, ray_kinds[run.kind].any_hit ? nullptr : &generation.weights[run.kind]);
}

}  // namespace crsh::rays
