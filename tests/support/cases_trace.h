#pragma once
// Scenes and batches on the device out of plain lists, and the way of the rays through hierarchy, traversal and
// intersection.

#include <array>
#include <cstdint>
#include <limits>
#include <vector>

#include "crsh/options.h"
#include "gpu/recorder.h"
#include "rays/batch.h"
#include "scene/device/upload.h"
#include "shared/node.h"
#include "support/cases.h"
#include "trace/in.h"

namespace crsh::test {

struct Object {
  std::vector<Triangle> triangles;
  glm::mat4 transform{1};
  bool transmissive = false, single_sided = false;
};

/// One instance an object, in this order; moved and given spheres by scene::animate.
[[nodiscard]] scene::GpuScene make_scene(gpu::Recorder& recorder, const std::vector<Object>& objects);
/// The triangles as they stand in the world, bit for bit.
[[nodiscard]] std::vector<Triangle> world_triangles(gpu::Recorder& recorder, const scene::GpuScene& scene);

/// A batch, sorted: each segment's rays in an order of their own.
struct SortedBatch {
  rays::Batch batch;
  gpu::Buffer sorted, order;
  std::vector<shared::Ray> sorted_rays;
  std::vector<uint32_t> order_of_rays;  ///< as `order` has it
};

/// A segment for each list; all rays of a list are of one kind. `random`, if any, shuffles the order within segments.
[[nodiscard]] SortedBatch make_batch(gpu::Device& device, const std::vector<std::vector<shared::Ray>>& lists,
                                     Random* random = nullptr);

struct TraceOptions {
  AlgorithmOptions algorithm;
  uint64_t submit_work = uint64_t(1) << 26;
  std::string mutation = {};                              ///< "narrow-cones", "dropped-pairs"
  float extent = std::numeric_limits<float>::infinity();  ///< metres; cut_distance is a share of it
};

struct Traced {
  std::vector<glm::uvec4> hits;        ///< in creation order
  std::vector<uint64_t> counters;      ///< a row a kind (shared/counters.h)
  std::vector<shared::HitPair> pairs;  ///< level-1 candidates, segment after segment
  uint32_t slices = 0;                 ///< in which they came
  [[nodiscard]] uint64_t counter(uint32_t kind, uint32_t which) const;
};

/// Runs rows of the table of tracers, with a sort and an object hierarchy of its own. Keeps its buffers between calls,
/// as a frame does.
class Tracer {
 public:
  explicit Tracer(gpu::Device& device) : recorder_(device), counters_(device, 0) {}

  /// Nodes against all triangles, by traversal and intersection themselves, so that candidates can be looked at.
  [[nodiscard]] Traced trace(const scene::GpuScene& scene, const SortedBatch& rays, const TraceOptions& options);
  /// By the tracer that the algorithm names. Nodes are built over the rays as `rays` has them sorted.
  [[nodiscard]] Traced trace_by_table(const scene::GpuScene& scene, const SortedBatch& rays,
                                      const TraceOptions& options);
  /// Every ray against every triangle.
  [[nodiscard]] Traced trace_all(const scene::GpuScene& scene, const SortedBatch& rays,
                                 uint64_t submit_work = uint64_t(1) << 26);

  /// Every ray by itself through an object hierarchy.
  [[nodiscard]] Traced trace_single(const scene::GpuScene& scene, const SortedBatch& rays,
                                    uint64_t submit_work = uint64_t(1) << 26);

  /// Nodes of one or two levels through an object hierarchy.
  [[nodiscard]] Traced trace_objects(const scene::GpuScene& scene, const SortedBatch& rays, TraceOptions options);

  [[nodiscard]] gpu::Recorder& recorder() { return recorder_; }
  /// As the last trace() built it.
  [[nodiscard]] const hierarchy::Hierarchy& hierarchy() const { return workspace_.bundle.hierarchy; }

 private:
  /// What the batch is traced with; counters are 0, and no ray has hit anything. Valid until the next call.
  [[nodiscard]] trace::In begin(const scene::GpuScene& scene, const SortedBatch& rays, const TraceOptions& options);
  void build_nodes(const gpu::Buffer& sorted_rays, const SortedBatch& rays, const TraceOptions& options);
  /// Makes the workspace hold the batch's sorted rays and nodes over them.
  void bundle(const SortedBatch& rays, const TraceOptions& options);
  [[nodiscard]] Traced result(const SortedBatch& rays);

  gpu::Recorder recorder_;
  trace::Counters counters_;
  trace::Structures structures_;
  trace::Workspace workspace_;
  traversal::Scratch scratch_;
  RenderOptions options_;
};

/// The rays whose hits differ.
[[nodiscard]] std::vector<uint32_t> different_hits(const Traced& a, const Traced& b);

/// The same pairs in the same order.
[[nodiscard]] bool same_pairs(const std::vector<shared::HitPair>& a, const std::vector<shared::HitPair>& b);

}  // namespace crsh::test
