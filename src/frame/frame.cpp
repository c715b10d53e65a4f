// One frame, top to bottom as the paper's Figure 1: steps 1 and 2 once, steps 3 to 7 once a batch of rays.

#include <algorithm>

#include "coherence/trim.h"
#include "crsh/kinds.h"
#include "frame/state.h"
#include "frame/trace.h"
#include "raster/jitter.h"
#include "shading/direct.h"

namespace crsh {
namespace {

/// Steps 3 to 6 for the rays of one plan: created, trimmed, traced. The hits are in state.batch.tracing.
const rays::Batch& trace_batch(Renderer::State& s, const rays::BatchPlan& plan, const surfaces::Surfaces& surfaces,
                               surfaces::Generation& generation, uint32_t bounce) {
  rays::Batch& batch = s.batch.rays;
  batch.segments.clear();
  for (const rays::Wanted& wanted : plan.segments)
    batch.segments.push_back({.kind = wanted.kind, .light = wanted.light});
  batch.surfaces = plan.surfaces;
  s.recorder.stage(Stage::ray_creation);
  rays::create(s.recorder, {surfaces, s.gpu_scene, plan, s.options.override_mirror, s.film.samples - 1, s.options.seed},
               s.batch.sparse, generation);
  coherence::trim(s.recorder, s.batch.trim, s.batch.sparse.rays, s.batch.sparse.flags, batch);
  if (batch.count) trace_rays(s, bounce, {surfaces.diffuse, surfaces.specular, plan.first_surface});
  return batch;
}

/// Which rays of a batch become surfaces of the next generation, and which surfaces these are.
surfaces::Children children_of(rays::Batch& batch, const rays::BatchPlan& plan, uint32_t first_child) {
  surfaces::Children children;
  children.first_surface = plan.first_surface;
  children.surfaces = plan.surfaces;
  children.end = first_child;
  for (uint32_t s = 0; s < batch.segments.size(); ++s) {
    const rays::Segment& segment = batch.segments[s];
    if (ray_kinds[segment.kind].any_hit) continue;
    children.of_kind[segment.kind] = {s * plan.surfaces, segment.first, segment.count, children.end};
    children.end += segment.count;
  }
  children.ends = std::move(batch.ends);
  return children;
}

bool is_closest(const rays::Wanted& wanted) { return !ray_kinds[wanted.kind].any_hit; }

bool casts_closest(const rays::BatchPlan& plan) { return std::ranges::any_of(plan.segments, is_closest); }

/// How many surfaces the plans can add to the next generation at most. Throws PortionTooLarge where a binding cannot
/// hold them.
uint32_t max_children(Renderer::State& s, const std::vector<rays::BatchPlan>& plans) {
  uint64_t slots = 0;
  for (const rays::BatchPlan& plan : plans)
    slots += uint64_t(plan.surfaces) * std::ranges::count_if(plan.segments, is_closest);
  if (slots * sizeof(glm::vec4) > s.device.limits().max_binding) throw PortionTooLarge();
  return static_cast<uint32_t>(slots);
}

/// Frees the children's buffers; submits first, because recorded commands may still read them.
void drop_children(Renderer::State& s, surfaces::Generation& generation) {
  if (generation.children.empty()) return;
  s.recorder.submit();
  generation.children.clear();
}

/// What rays of any-hit kinds saw, for the layers that show it.
void add_visibilities(Renderer::State& s, const shading::DirectIn& direct) {
  for (const LayerId layer : s.film.layers.members())
    if (const LayerSource& source = row_of(layer).source; source.fill == LayerFill::visibility)
      shading::add_visibility(s.recorder, direct, source.kind, s.film.of(layer));
}

/// Whether what lies behind the surfaces of a generation shows.
bool sees_through(const Renderer::State& s, uint32_t generation) {
  const PerKind<bool> cast = rays::kinds_at(s.options, generation);
  for (uint32_t kind = 0; kind < kind_count; ++kind)
    if (cast[kind] && ray_kinds[kind].goes_through) return true;
  return false;
}

/// Steps 3 to 7 of one bounce: traces all rays of generation k, shades, and yields generation k + 1.
void trace_bounce(Renderer::State& s, uint32_t bounce) {
  surfaces::Surfaces& surfaces = s.paths.surfaces(bounce);
  surfaces::Surfaces& next = s.paths.surfaces(bounce + 1);
  surfaces::Generation& generation = s.paths.generations[bounce];
  const std::vector<rays::BatchPlan> plans = rays::plan_batches({.surfaces = surfaces.count,
                                                                 .lights = s.gpu_scene.light_count,
                                                                 .kinds = rays::kinds_at(s.options, bounce),
                                                                 .mixed = s.options.algorithm.mixed_batches});
  drop_children(s, generation);
  const uint32_t room = max_children(s, plans);
  const auto closest_plans = std::count_if(plans.begin(), plans.end(), casts_closest);
  next.count = 0;
  for (const rays::BatchPlan& plan : plans) {
    const rays::Batch& batch = trace_batch(s, plan, surfaces, generation, bounce);
    s.recorder.stage(Stage::shading);
    const shading::DirectIn direct{surfaces, s.gpu_scene, plan, batch.ends, s.batch.tracing.hits};
    if (batch.count) shading::add_direct(s.recorder, direct, generation);
    if (batch.count && bounce == 0) add_visibilities(s, direct);
    if (!casts_closest(plan)) continue;
    surfaces::Children children = children_of(s.batch.rays, plan, next.count);
    const uint32_t count = children.end - next.count;
    if (next.count == 0)
      surfaces::reserve(s.recorder, next, s.paths.generations[bounce + 1], closest_plans > 1 ? room : count,
                        s.gpu_scene.has_lobes);
    surfaces::from_hits(s.recorder,
                        {s.gpu_scene, batch.rays, batch.slots, s.batch.tracing.hits, children, surfaces,
                         generation.weights, s.cone_spread, sees_through(s, bounce + 1)},
                        next, s.paths.generations[bounce + 1]);
    generation.children.push_back(std::move(children));
  }
}

/// Whether the layer shows what rays of one kind brought.
bool shows_one_kind(LayerId layer) { return row_of(layer).source.value == SurfaceValue::brought; }

/// Step 7: carries radiance back along the paths, from the last generation to the first.
void gather_generations(Renderer::State& s, uint32_t generations) {
  s.recorder.stage(Stage::shading);
  for (uint32_t k = generations; k-- > 0;) {
    surfaces::Generation& generation = s.paths.generations[k];
    if (k + 1 == generations) drop_children(s, generation);
    for (surfaces::Children& children : generation.children) children.totals = &s.paths.gathered[k + 1].total;
    const bool parts = k == 0 && std::ranges::any_of(s.film.layers.members(), shows_one_kind);
    shading::gather(s.recorder, generation, s.options.background.value_or(glm::vec3(0)), s.paths.gathered[k],
                    parts ? shading::Parts::wanted : shading::Parts::unwanted);
  }
}

/// Traces all bounces that begin at generation 0.
void trace_paths(Renderer::State& s, const Renderer::Progress& progress, double done, double share) {
  uint32_t generations = 0;
  const uint32_t most = s.options.bounces + 1;
  while (generations < most && s.paths.surfaces(generations).count > 0) {
    trace_bounce(s, generations);
    ++generations;
    if (progress) progress(done + share * generations / most);
  }
  gather_generations(s, generations);
}

/// Steps 2 to 7 for the film's next sample; `begun` samples of this call are done already.
void render_sample(Renderer::State& s, const raster::CameraView& view, const Renderer::Progress& progress,
                   uint32_t begun) {
  const uint32_t pixels = s.size.width * s.size.height;
  const double share = double(std::min(s.portion, pixels)) / (double(pixels) * s.options.samples);
  double done = double(begun) / s.options.samples;
  s.cone_spread = raster::pixel_cone(view, s.size).spread;
  s.recorder.stage(Stage::raster);
  const glm::vec2 jitter = raster::jitter(s.film.samples, s.options.seed);
  raster::rasterise(s.recorder, {s.gpu_scene, view, s.size, jitter}, s.gbuffer);
  shading::begin_sample(s.film);
  for (uint32_t first = 0; first < pixels; first += s.portion, done += share) {
    s.recorder.stage(Stage::shading);
    surfaces::from_raster(s.recorder,
                          {s.gbuffer, s.gpu_scene, view, s.size, s.options.algorithm.ray_order, first,
                           std::min(s.portion, pixels - first), sees_through(s, 0)},
                          s.paths.first, s.paths.generations[0]);
    trace_paths(s, progress, done, share);
    shading::add_sample(s.recorder, {s.paths.first, s.paths.generations[0], s.paths.gathered[0], s.gpu_scene, view},
                        s.film);
  }
}

}  // namespace

Picture render_frame(Renderer::State& s, double seconds, const Renderer::Progress& progress) {
  const scene::Pose pose = s.scene.pose(seconds, s.animations);
  const raster::CameraView view = raster::camera_view(s.scene, pose, s.options, s.first_bounds, s.size);
  s.recorder.stage(Stage::raster);
  s.placing = true;
  place_objects(s, pose);
  s.recorder.submit();
  s.placing = false;
  s.recorder.stage(Stage::raster);
  shading::begin_frame(s.recorder, s.film, s.size, s.options.layers);
  s.paths.generations.resize(s.options.bounces + 2);
  s.paths.gathered.resize(s.options.bounces + 2);
  for (uint32_t sample = 0; sample < s.options.samples; ++sample) render_sample(s, view, progress, sample);
  return shading::take_picture(s.recorder, s.film, view, s.scene.origin, s.options.background);
}

Picture refine_frame(Renderer::State& s, double seconds, const Renderer::Progress& progress) {
  const scene::Pose pose = s.scene.pose(seconds, s.animations);
  const raster::CameraView view = raster::camera_view(s.scene, pose, s.options, s.first_bounds, s.size);
  render_sample(s, view, progress, 0);
  return shading::take_picture(s.recorder, s.film, view, s.scene.origin, s.options.background);
}

}  // namespace crsh
