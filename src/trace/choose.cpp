#include "trace/choose.h"

#include "hierarchy/sample.h"

namespace crsh::trace {
namespace {

/// A scene of no more is small for nodes of rays.
constexpr uint32_t few_triangles = 128;

/// By segment: whether its rays are too scattered for nodes, where these end with coherence.
std::vector<bool> scattered_segments(gpu::Recorder& recorder, const In& in) {
  const AlgorithmOptions& options = in.options.algorithm;
  std::vector<bool> scattered(in.batch.segments.size());
  if (options.nodes != NodeCut::cut || options.least_rays <= 0) return scattered;
  const std::vector<float> means =
      hierarchy::rays_a_node(recorder, {in.batch, options, in.scene.bounds.longest_edge()}, in.workspace.sampled);
  for (size_t s = 0; s < means.size(); ++s) scattered[s] = means[s] < options.least_rays;
  return scattered;
}

}  // namespace

std::vector<const Tracer*> choose_tracers(gpu::Recorder& recorder, const In& in) {
  const Tracer& own = tracer_of(in.options.algorithm);
  std::vector<const Tracer*> chosen(in.batch.segments.size(), &own);
  if (own.scattered.empty()) return chosen;
  const Tracer& other = tracer_named(own.scattered);
  if (in.scene.triangle_count <= few_triangles) return std::vector(chosen.size(), &other);
  const std::vector<bool> scattered = scattered_segments(recorder, in);
  for (size_t s = 0; s < chosen.size(); ++s)
    if (scattered[s]) chosen[s] = &other;
  return chosen;
}

}  // namespace crsh::trace
