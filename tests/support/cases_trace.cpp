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
  mesh.uv0.resize(corners, glm::vec2(0));
  mesh.uv1.resize(corners, glm::vec2(0));
  mesh.colours.resize(corners, 0xFFFFFFFFu);
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
  return out;
}

uint64_t Traced::counter(uint32_t kind, uint32_t which) const {
  return counters[kind * shared::counters_per_row + which];
}

void Tracer::begin(const SortedBatch& rays) {
  gpu::Device& device = recorder_.device();
  hits_.reserve(device, std::max(rays.batch.count, 1u) * sizeof(shared::Hit), "hits");
  counters_.reserve(device, kind_count * shared::counters_per_row * sizeof(uint64_t), "counters");
  recorder_.fill(counters_, 0, kind_count * shared::counters_per_row * 2);
  intersection::clear(recorder_, rays.batch, hits_);
}

Traced Tracer::result(const SortedBatch& rays) {
  Traced traced;
  traced.hits = recorder_.read<glm::uvec4>(hits_, rays.batch.count);
  traced.counters = recorder_.read<uint64_t>(counters_, kind_count * shared::counters_per_row);
  return traced;
}

Traced Tracer::trace(const scene::GpuScene& scene, const SortedBatch& rays, const TraceOptions& options) {
  begin(rays);
  hierarchy::build(recorder_, {rays.sorted, rays.batch.segments, options.algorithm, options.narrow_cones}, hierarchy_);
  std::vector<shared::HitPair> pairs;
  uint32_t portions = 0;
  for (size_t s = 0; s < rays.batch.segments.size(); ++s) {
    const rays::Segment& segment = rays.batch.segments[s];
    if (segment.count == 0) continue;
    const uint32_t row = segment.kind * shared::counters_per_row, depth = options.algorithm.levels[segment.kind];
    const traversal::In in{.hierarchy = hierarchy_,
                           .scene = scene,
                           .options = options.algorithm,
                           .counters = counters_,
                           .counter_row = row,
                           .submit_work = options.submit_work,
                           .drop_every = options.drop_every};
    traversal::traverse(recorder_, in, depth, hierarchy_.levels[depth - 1].segments[s], scratch_,
                        [&](const traversal::Candidates& candidates) {
                          const auto part = recorder_.read<shared::HitPair>(candidates.pairs, candidates.count);
                          ++portions;
                          pairs.insert(pairs.end(), part.begin(), part.end());
                          intersection::intersect(recorder_,
                                                  {scene, rays.batch, hits_, counters_, row, options.submit_work},
                                                  hierarchy_, rays.sorted, rays.order, candidates);
                        });
  }
  Traced traced = result(rays);
  traced.pairs = std::move(pairs);
  traced.portions = portions;
  return traced;
}

Traced Tracer::trace_all(const scene::GpuScene& scene, const SortedBatch& rays, uint64_t submit_work) {
  begin(rays);
  for (const rays::Segment& segment : rays.batch.segments)
    intersection::intersect_all(
        recorder_, {scene, rays.batch, hits_, counters_, segment.kind * shared::counters_per_row, submit_work},
        segment);
  return result(rays);
}

Traced Tracer::trace_single(const scene::GpuScene& scene, const SortedBatch& rays, uint64_t submit_work) {
  objects::Hierarchy objects;
  objects::update(recorder_, {scene, {}, submit_work}, objects);
  begin(rays);
  for (const rays::Segment& segment : rays.batch.segments)
    intersection::intersect_single(
        recorder_, {scene, rays.batch, hits_, counters_, segment.kind * shared::counters_per_row, submit_work}, objects,
        segment, single_);
  return result(rays);
}

Traced Tracer::trace_objects(const scene::GpuScene& scene, const SortedBatch& rays, const TraceOptions& options) {
  objects::Hierarchy objects;
  objects::update(recorder_, {scene, {}, options.submit_work}, objects);
  AlgorithmOptions algorithm = options.algorithm;
  algorithm.object_hierarchy = true;
  begin(rays);
  hierarchy::build(recorder_, {rays.sorted, rays.batch.segments, algorithm, options.narrow_cones, options.extent},
                   hierarchy_);
  for (size_t s = 0; s < rays.batch.segments.size(); ++s) {
    const traversal::In in{.hierarchy = hierarchy_,
                           .scene = scene,
                           .options = algorithm,
                           .counters = counters_,
                           .counter_row = rays.batch.segments[s].kind * shared::counters_per_row,
                           .submit_work = options.submit_work,
                           .drop_every = options.drop_every};
    intersection::intersect_nodes(recorder_, {in, objects, rays.batch, rays.sorted, rays.order, hits_}, s, nodes_,
                                  single_);
  }
  return result(rays);
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
