#include "support/cases_trace.h"

#include <algorithm>
#include <numeric>

#include "intersection/intersection.h"
#include "scene/bounding.h"
#include "shared/counters.h"

namespace crsh::test {
namespace {

scene::Material material_of(const Object& object) {
  scene::Material material;
  material.base_colour = object.transmissive ? glm::vec4(0.9f, 0.7f, 0.5f, 1) : glm::vec4(1);
  material.metallic = 0;
  material.transmission = object.transmissive ? 1.0f : 0.0f;
  material.double_sided = !object.single_sided;
  return material;
}

scene::Mesh mesh_of(const std::vector<Triangle>& triangles, uint32_t material) {
  scene::Mesh mesh;
  for (const Triangle& t : triangles) {
    const uint32_t first = uint32_t(mesh.positions.size());
    mesh.positions.insert(mesh.positions.end(), {t.a, t.b, t.c});
    mesh.triangles.emplace_back(first, first + 1, first + 2);
  }
  const size_t corners = mesh.positions.size();
  mesh.normals.resize(corners, glm::vec3(0));
  mesh.uv[0].resize(corners, glm::vec2(0));
  mesh.uv[1].resize(corners, glm::vec2(0));
  mesh.colours.resize(corners, scene::white);
  mesh.materials.resize(triangles.size(), material);
  scene::fill_bounds(mesh);
  return mesh;
}

void shuffle(Random& random, std::vector<uint32_t>& values, uint32_t first, uint32_t count) {
  for (uint32_t i = count; i > 1; --i) std::swap(values[first + i - 1], values[first + random.below(i)]);
}

}  // namespace

scene::GpuScene make_scene(gpu::Recorder& recorder, const std::vector<Object>& objects) {
  scene::Scene scene;
  scene::Pose pose;
  for (const Object& object : objects) {
    const uint32_t index = uint32_t(scene.meshes.size());
    scene.meshes.push_back(mesh_of(object.triangles, index));
    scene.materials.push_back(material_of(object));
    scene.instances.push_back({index, index});
    pose.instances.push_back(object.transform);
  }
  scene.materials.emplace_back();
  scene::GpuScene target = scene::upload(recorder.device(), scene);
  scene::animate(recorder, target, scene, pose, {});
  recorder.submit();
  return target;
}

std::vector<Triangle> world_triangles(gpu::Recorder& recorder, const scene::GpuScene& scene) {
  const auto a = recorder.read<glm::vec4>(scene.corner_a, scene.triangle_count),
             b = recorder.read<glm::vec4>(scene.corner_b, scene.triangle_count),
             c = recorder.read<glm::vec4>(scene.corner_c, scene.triangle_count);
  std::vector<Triangle> triangles;
  for (size_t i = 0; i < a.size(); ++i) triangles.push_back({glm::vec3(a[i]), glm::vec3(b[i]), glm::vec3(c[i])});
  return triangles;
}

SortedBatch make_batch(gpu::Device& device, const std::vector<std::vector<shared::Ray>>& lists, Random* random) {
  SortedBatch out;
  std::vector<shared::Ray> created;
  for (const std::vector<shared::Ray>& list : lists) {
    const uint32_t kind = list.empty() ? 0 : uint32_t(list.front().direction.w);
    out.batch.segments.push_back(
        {kind, uint32_t(out.batch.segments.size()), uint32_t(created.size()), uint32_t(list.size())});
    created.insert(created.end(), list.begin(), list.end());
  }
  out.batch.count = uint32_t(created.size());
  std::vector<uint32_t> order(created.size());
  std::iota(order.begin(), order.end(), 0u);
  for (const rays::Segment& segment : out.batch.segments)
    if (random) shuffle(*random, order, segment.first, segment.count);
  for (const uint32_t ray : order) out.sorted_rays.push_back(created[ray]);
  out.batch.rays = gpu::upload(device, created, "rays");
  out.sorted = gpu::upload(device, out.sorted_rays, "sorted rays");
  out.order = gpu::upload(device, order, "order");
  out.order_of_rays = std::move(order);
  return out;
}

uint64_t Traced::counter(uint32_t kind, uint32_t which) const {
  return counters[kind * shared::counters_per_row + which];
}

trace::In Tracer::begin(const scene::GpuScene& scene, const SortedBatch& rays, const TraceOptions& options) {
  workspace_.hits.reserve(recorder_.device(), std::max(rays.batch.count, 1u) * sizeof(shared::Hit), "hits");
  counters_.clear(recorder_);
  intersection::clear(recorder_, rays.batch, workspace_.hits);  // Needs::empty_hits
  options_.algorithm = options.algorithm;
  options_.submit_work = options.submit_work;
  options_.mutation = options.mutation.empty() ? std::nullopt : std::optional(options.mutation);
  return {.scene = scene,
          .structures = structures_,
          .batch = rays.batch,
          .names = {rays.batch.rays, rays.batch.rays},  // whose rays these are makes no difference to a tracer
          .options = options_,
          .counters = counters_,
          .workspace = workspace_};
}

void Tracer::build_nodes(const gpu::Buffer& sorted_rays, const SortedBatch& rays, const TraceOptions& options) {
  hierarchy::build(recorder_,
                   {.sorted_rays = sorted_rays,
                    .segments = rays.batch.segments,
                    .options = options.algorithm,
                    .narrow_cones = options.mutation == "narrow-cones",
                    .extent = options.extent,
                    .cut_groups = trace::tracer_of(options.algorithm).needs.object_hierarchy},
                   workspace_.bundle.hierarchy);
}

void Tracer::bundle(const SortedBatch& rays, const TraceOptions& options) {
  trace::Bundle& bundle = workspace_.bundle;
  bundle.sorted_rays = gpu::upload(recorder_.device(), rays.sorted_rays, "sorted rays");
  bundle.order.order = gpu::upload(recorder_.device(), rays.order_of_rays, "order");
  build_nodes(bundle.sorted_rays, rays, options);
}

Traced Tracer::result(const SortedBatch& rays) {
  Traced traced;
  traced.hits = recorder_.read<glm::uvec4>(workspace_.hits, rays.batch.count);
  traced.counters = recorder_.read<uint64_t>(counters_.buffer(), kind_count * shared::counters_per_row);
  return traced;
}

Traced Tracer::trace(const scene::GpuScene& scene, const SortedBatch& rays, const TraceOptions& options) {
  const trace::In in = begin(scene, rays, options);
  build_nodes(rays.sorted, rays, options);
  std::vector<shared::HitPair> pairs;
  uint32_t slices = 0;
  for (size_t s = 0; s < rays.batch.segments.size(); ++s) {
    const uint32_t kind = rays.batch.segments[s].kind, depth = options.algorithm.levels[kind];
    if (rays.batch.segments[s].count == 0) continue;
    const intersection::In of_rays = trace::intersection_in(in, kind);
    const auto take = [&](const traversal::Candidates& candidates) {
      const auto part = recorder_.read<shared::HitPair>(candidates.pairs, candidates.count);
      ++slices;
      pairs.insert(pairs.end(), part.begin(), part.end());
      intersection::intersect(recorder_, of_rays, hierarchy(), rays.sorted, rays.order, candidates);
    };
    traversal::traverse(recorder_, trace::traversal_in(in, kind), depth, hierarchy().levels[depth - 1].segments[s],
                        scratch_, take);
  }
  Traced traced = result(rays);
  traced.pairs = std::move(pairs);
  traced.slices = slices;
  return traced;
}

Traced Tracer::trace_by_table(const scene::GpuScene& scene, const SortedBatch& rays, const TraceOptions& options) {
  const trace::Tracer& tracer = trace::tracer_of(options.algorithm);
  recorder_.submit();
  structures_ = {};  // of another scene
  trace::place(recorder_, {scene, {}, options.submit_work}, tracer.needs, structures_);
  const trace::In in = begin(scene, rays, options);
  if (tracer.needs.sorted_rays) bundle(rays, options);
  trace::Segments all(rays.batch.segments.size());
  std::iota(all.begin(), all.end(), size_t(0));
  trace::run(recorder_, in, tracer, all);
  return result(rays);
}

Traced Tracer::trace_all(const scene::GpuScene& scene, const SortedBatch& rays, uint64_t submit_work) {
  return trace_by_table(scene, rays, {preset("brute"), submit_work});
}

Traced Tracer::trace_single(const scene::GpuScene& scene, const SortedBatch& rays, uint64_t submit_work) {
  return trace_by_table(scene, rays, {preset("bvh"), submit_work});
}

Traced Tracer::trace_objects(const scene::GpuScene& scene, const SortedBatch& rays, TraceOptions options) {
  options.algorithm.tracer = "object-nodes";
  return trace_by_table(scene, rays, options);
}

std::vector<uint32_t> different_hits(const Traced& a, const Traced& b) {
  std::vector<uint32_t> different;
  for (uint32_t i = 0; i < a.hits.size(); ++i)
    if (a.hits[i] != b.hits[i]) different.push_back(i);
  return different;
}

bool same_pairs(const std::vector<shared::HitPair>& a, const std::vector<shared::HitPair>& b) {
  return std::ranges::equal(a, b,
                            [](const auto& x, const auto& y) { return x.node == y.node && x.triangle == y.triangle; });
}

}  // namespace crsh::test
