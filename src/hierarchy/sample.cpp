#include "hierarchy/sample.h"

#include <algorithm>
#include <limits>

#include "hierarchy/grouping.h"
#include "primitives/grow.h"
#include "shared/limits.h"
#include "shared/ray.h"

namespace crsh::hierarchy {
namespace {

/// About how many runs of a segment are looked at: some ten thousand rays.
constexpr uint32_t max_runs = 256;

/// Which runs of a segment's rays are looked at: every `stride`-th one, by a lane each, with so many rays in all.
struct Sample {
  uint32_t stride, lanes, rays;
};

Sample sample_of(uint32_t rays) {
  const uint32_t runs = (rays + shared::cut_run - 1) / shared::cut_run, stride = (runs + max_runs - 1) / max_runs;
  const uint32_t lanes = (runs + stride - 1) / stride;
  const uint32_t last = (lanes - 1) * stride * shared::cut_run;
  return {stride, lanes, (lanes - 1) * shared::cut_run + std::min(shared::cut_run, rays - last)};
}

bool is_sampled(const rays::Segment& segment) { return !segment.shares_origin && segment.count > 0; }

}  // namespace

std::vector<float> rays_a_node(gpu::Recorder& recorder, const SampleIn& in, gpu::Buffer& sums) {
  const std::vector<rays::Segment>& segments = in.batch.segments;
  std::vector<float> means(segments.size(), std::numeric_limits<float>::infinity());
  if (std::ranges::none_of(segments, is_sampled)) return means;
  recorder.stage(Stage::hierarchy_creation);
  primitives::grow(recorder, sums, primitives::quad_bytes(segments.size()), "sampled nodes");
  recorder.fill(sums, 0, segments.size());
  const CutLimits limits = cut_limits(in.options, in.extent, 0);
  for (uint32_t s = 0; s < segments.size(); ++s) {
    if (!is_sampled(segments[s])) continue;
    const Sample sample = sample_of(segments[s].count);
    const struct {
      uint32_t first_ray, ray_count, arity, stride, slot;
      CutLimits limits;
    } push{segments[s].first, segments[s].count, in.options.arity, sample.stride, s, limits};
    recorder.dispatch("hierarchy/sample", sample.lanes, push, {{"rays", in.batch.rays}, {"sums", sums}}, sample.rays);
  }
  const auto nodes = recorder.read<uint32_t>(sums, segments.size());
  for (size_t s = 0; s < segments.size(); ++s)
    if (is_sampled(segments[s])) means[s] = float(sample_of(segments[s].count).rays) / float(nodes[s]);
  return means;
}

}  // namespace crsh::hierarchy
