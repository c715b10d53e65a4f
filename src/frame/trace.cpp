// Section 3.2.1, and sections 3.2.3 to 3.2.6: through the ray hierarchy, the object hierarchy, or without any.

#include "frame/trace.h"

#include <algorithm>

#include "frame/dump.h"
#include "frame/look_inside.h"
#include "hierarchy/sample.h"
#include "primitives/grow.h"
#include "shared/ray.h"

namespace crsh {
namespace {

/// Nodes of a batch that are traversed together: one kind's, on the top level of that kind.
hierarchy::Range nodes_of(const rays::Batch& batch, const hierarchy::Hierarchy& hierarchy, uint32_t kind,
                          uint32_t depth) {
  hierarchy::Range range;
  for (size_t s = 0; s < batch.segments.size(); ++s) {
    const hierarchy::Range nodes = batch.segments[s].kind == kind && depth <= hierarchy.depth
                                       ? hierarchy.levels[depth - 1].segments[s]
                                       : hierarchy::Range{};
    if (range.count == 0) range.first = nodes.first;
    range.count += nodes.count;
  }
  return range;
}

/// Empties the account of tests for a batch, if any Tests layer is wanted.
void begin_account(Renderer::State& s, const rays::Batch& batch) {
  hierarchy::WantedTests wanted{};
  for (uint32_t kind = 0; kind < shared::tests_count; ++kind)
    wanted[kind] = s.film.layers.has(shading::layer_of_tests(kind));
  s.batch.account.begin(s.recorder, wanted, batch.count, s.batch.hierarchy);
}

/// Neither sorted nor bundled.
void begin_without_nodes(Renderer::State& s, const rays::Batch& batch) {
  s.batch.hierarchy.depth = 0;
  s.batch.order.chunks.clear();
  begin_account(s, batch);
}

/// The tests of a batch's rays and nodes go to the film.
void share_tests(Renderer::State& s, const rays::Batch& batch, const RayNames& names) {
  for (uint32_t kind = 0; kind < shared::tests_count; ++kind)
    if (s.batch.account.wants(kind))
      s.batch.account.share(s.recorder,
                            {batch, s.batch.hierarchy, s.batch.order.order, names.first_surface, names.pixels}, kind,
                            s.film.of(shading::layer_of_tests(kind)));
}

traversal::In traversal_in(Renderer::State& s, uint32_t bounce, uint32_t kind) {
  return {.hierarchy = s.batch.hierarchy,
          .scene = s.gpu_scene,
          .options = s.options.algorithm,
          .counters = s.counters->buffer(),
          .counter_row = Counters::row(bounce, kind),
          .submit_work = s.options.submit_work,
          .most_pairs = s.most_pairs,
          .drop_every = s.options.mutation == "dropped-pairs" ? 10000u : 0u,
          .account = s.batch.account};
}

/// Nodes against all triangles, level by level, and rays against candidates.
void meet_triangles(Renderer::State& s, const rays::Batch& batch, uint32_t bounce) {
  intersection::clear(s.recorder, batch, s.batch.hits);
  const AlgorithmOptions& options = s.options.algorithm;
  BatchBuffers& b = s.batch;
  for (uint32_t kind = 0; kind < kind_count; ++kind) {
    const traversal::In in = traversal_in(s, bounce, kind);
    const hierarchy::Range top = nodes_of(batch, b.hierarchy, kind, options.levels[kind]);
    traversal::traverse(s.recorder, in, options.levels[kind], top, b.traversal, [&](const auto& candidates) {
      intersection::intersect(s.recorder,
                              {s.gpu_scene, batch, b.hits, in.counters, in.counter_row, in.submit_work, in.account},
                              b.hierarchy, b.sorted_rays, b.order.order, candidates);
    });
  }
}

/// The rays of a segment one by one.
void meet_alone(Renderer::State& s, const rays::Batch& batch, uint32_t bounce, const rays::Segment& segment) {
  intersection::intersect_single(s.recorder,
                                 {s.gpu_scene, batch, s.batch.hits, s.counters->buffer(),
                                  Counters::row(bounce, segment.kind), s.options.submit_work, s.batch.account},
                                 s.objects, segment, s.batch.single);
}

/// Nodes through the object hierarchy.
void meet_objects(Renderer::State& s, const rays::Batch& batch, uint32_t bounce) {
  BatchBuffers& b = s.batch;
  for (size_t segment = 0; segment < batch.segments.size(); ++segment) {
    if (batch.segments[segment].alone) {
      meet_alone(s, batch, bounce, batch.segments[segment]);
      continue;
    }
    const traversal::In in = traversal_in(s, bounce, batch.segments[segment].kind);
    intersection::intersect_nodes(s.recorder, {in, s.objects, batch, b.sorted_rays, b.order.order, b.hits}, segment,
                                  b.nodes, b.single);
  }
}

/// Steps 4 to 6 (§3.2.3 to §3.2.6): sorts the rays, bundles them into nodes, and takes these through the scene.
void trace_hierarchy(Renderer::State& s, const rays::Batch& batch, uint32_t bounce) {
  const AlgorithmOptions& options = s.options.algorithm;
  BatchBuffers& b = s.batch;
  const bool unstable = s.options.mutation == "unstable-sort", narrow = s.options.mutation == "narrow-cones";
  coherence::order(s.recorder, b.sort,
                   {.batch = batch,
                    .keys = options.keys,
                    .bounds = s.gpu_scene.bounds,
                    .compression = options.compression,
                    .unstable = unstable},
                   b.order);
  coherence::gather(s.recorder, batch, b.order, b.sorted_rays);
  hierarchy::build(s.recorder, {b.sorted_rays, batch.segments, options, narrow, s.gpu_scene.bounds.longest_edge()},
                   b.hierarchy);
  begin_account(s, batch);
  options.object_hierarchy ? meet_objects(s, batch, bounce) : meet_triangles(s, batch, bounce);
}

/// Step 6 for rays one by one.
void trace_single(Renderer::State& s, const rays::Batch& batch, uint32_t bounce) {
  begin_without_nodes(s, batch);
  for (const rays::Segment& segment : batch.segments) meet_alone(s, batch, bounce, segment);
}

/// Step 6 by the device's own ray queries.
void trace_queries(Renderer::State& s, const rays::Batch& batch, uint32_t bounce) {
  begin_without_nodes(s, batch);
  for (const rays::Segment& segment : batch.segments)
    intersection::query(s.recorder,
                        {s.gpu_scene, batch, s.batch.hits, s.counters->buffer(), Counters::row(bounce, segment.kind),
                         s.options.submit_work},
                        s.device_objects, s.plain, segment);
}

/// Step 6 without any structure.
void trace_brute(Renderer::State& s, const rays::Batch& batch, uint32_t bounce) {
  intersection::clear(s.recorder, batch, s.batch.hits);
  begin_without_nodes(s, batch);
  for (const rays::Segment& segment : batch.segments)
    intersection::intersect_all(s.recorder,
                                {s.gpu_scene, batch, s.batch.hits, s.counters->buffer(),
                                 Counters::row(bounce, segment.kind), s.options.submit_work, s.batch.account},
                                segment);
}

/// Marks the segments whose rays are too scattered for nodes.
void find_scattered(Renderer::State& s) {
  const AlgorithmOptions& options = s.options.algorithm;
  const bool may_be = options.object_hierarchy && options.nodes == NodeCut::cut && options.least_rays > 0;
  if (tracing_of(s) != Tracing::nodes || !may_be) return;
  const std::vector<float> means =
      hierarchy::rays_a_node(s.recorder, {s.batch.rays, options, s.gpu_scene.bounds.longest_edge()}, s.batch.sampled);
  for (size_t i = 0; i < means.size(); ++i) s.batch.rays.segments[i].alone = means[i] < options.least_rays;
}

void walk(Renderer::State& s, const rays::Batch& batch, uint32_t bounce) {
  switch (tracing_of(s)) {
    case Tracing::nodes: return trace_hierarchy(s, batch, bounce);
    case Tracing::single_rays: return trace_single(s, batch, bounce);
    case Tracing::brute: return trace_brute(s, batch, bounce);
    case Tracing::ray_query: return trace_queries(s, batch, bounce);
  }
}

}  // namespace

Tracing tracing_of(const Renderer::State& s) {
  constexpr uint32_t few_triangles = 128;
  const AlgorithmOptions& options = s.options.algorithm;
  if (options.tracing != Tracing::nodes || !options.object_hierarchy) return options.tracing;
  const std::vector<rays::Segment>& segments = s.batch.rays.segments;
  const bool all_alone = !segments.empty() && std::ranges::all_of(segments, [](const rays::Segment& segment) {
    return segment.count == 0 || segment.alone;
  });
  return s.gpu_scene.triangle_count <= few_triangles || all_alone ? Tracing::single_rays : Tracing::nodes;
}

void place_objects(Renderer::State& s, const scene::Pose& pose) {
  scene::animate(s.recorder, s.gpu_scene, s.scene, pose, s.lights);
  if (s.options.algorithm.object_hierarchy)
    objects::update(s.recorder, {s.gpu_scene, pose.instances, s.options.submit_work}, s.objects);
  if (s.options.algorithm.tracing == Tracing::ray_query)
    objects::update(s.recorder, {s.gpu_scene, pose.instances, s.options.submit_work}, s.device_objects);
}

void trace(Renderer::State& s, uint32_t bounce, const RayNames& names) {
  const rays::Batch& batch = s.batch.rays;
  primitives::grow(s.recorder, s.batch.hits, uint64_t(batch.count) * sizeof(shared::Hit), "hits");
  find_scattered(s);
  walk(s, batch, bounce);
  for (const rays::Segment& segment : batch.segments)
    intersection::digest(s.recorder,
                         {s.gpu_scene, batch, s.batch.hits, s.counters->buffer(), Counters::row(bounce, segment.kind),
                          s.options.submit_work},
                         segment, names.first_surface, names.pixels, names.paths);
  share_tests(s, batch, names);
  add_batch(s.recorder, batch, s.batch.order, s.batch.hierarchy, bounce, s.frame_statistics);
  if (s.nodes) dump_nodes(s, bounce, s.rays_seen, *s.nodes);
  s.rays_seen += batch.count;
  if (s.dump) dump_batch(s, bounce, names, *s.dump);
}

}  // namespace crsh
