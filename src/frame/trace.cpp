#include "frame/trace.h"

#include "frame/built.h"
#include "frame/dump.h"
#include "trace/tally.h"

namespace crsh {
namespace {

/// Those that a layer shows.
hierarchy::WantedTests wanted_tests(const shading::Film& film) {
  hierarchy::WantedTests wanted{};
  for (uint32_t type = 0; type < shared::tests_count; ++type)
    wanted[type] = film.layers.has(shading::layer_of_tests(type));
  return wanted;
}

trace::TestsByPixel tests_by_pixel(const shading::Film& film, const hierarchy::WantedTests& wanted) {
  trace::TestsByPixel tests{};
  for (uint32_t type = 0; type < shared::tests_count; ++type)
    if (wanted[type]) tests[type] = &film.of(shading::layer_of_tests(type));
  return tests;
}

/// Hands the rays and nodes of the batch to whoever asked for them.
void dump(gpu::Recorder& recorder, const trace::Traced& traced, Dump& to) {
  if (to.nodes) dump_nodes(recorder, traced, to.rays_seen, *to.nodes);
  to.rays_seen += traced.in.batch.count;
  if (to.rays) dump_rays(recorder, traced, *to.rays);
}

}  // namespace

void place_objects(Renderer::State& s, const scene::Pose& pose) {
  scene::animate(s.recorder, s.gpu_scene, s.scene, pose, s.lights);
  trace::place(s.recorder, {s.gpu_scene, pose, s.options.submit_work}, trace::tracer_of(s.options.algorithm).needs,
               s.structures);
}

void trace_rays(Renderer::State& s, uint32_t bounce, const trace::RayNames& names) {
  const hierarchy::WantedTests wanted = wanted_tests(s.film);
  const trace::Traced traced = trace::trace(s.recorder, {.scene = s.gpu_scene,
                                                         .structures = s.structures,
                                                         .batch = s.batch.rays,
                                                         .names = names,
                                                         .options = s.options,
                                                         .counters = *s.counters,
                                                         .bounce = bounce,
                                                         .max_pairs = s.max_pairs,
                                                         .wanted = wanted,
                                                         .workspace = s.batch.tracing});
  trace::tally(s.recorder, traced, tests_by_pixel(s.film, wanted), s.frame_statistics);
  dump(s.recorder, traced, s.dump);
}

}  // namespace crsh
