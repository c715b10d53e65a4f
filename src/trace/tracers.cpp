#include "trace/tracers.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "crsh/assertion.h"
#include "crsh/error.h"
#include "objects/device_hierarchy.h"
#include "trace/brute.h"
#include "trace/in.h"
#include "trace/mesh_nodes.h"
#include "trace/object_nodes.h"
#include "trace/ray_query.h"
#include "trace/single_rays.h"

namespace crsh::trace {
namespace {

template <class Scratch>
using Run = void(gpu::Recorder&, const In&, const Segments&, Scratch&);

/// A row of the table, which forgets the type of the scratch.
template <class Scratch, Run<Scratch> function>
constexpr Tracer row(std::string_view name, Needs needs, std::string_view scattered = {}) {
  return {name, needs, scattered, [] { return std::shared_ptr<void>(std::make_shared<Scratch>()); },
          [](gpu::Recorder& recorder, const In& in, const Segments& segments, void* scratch) {
            function(recorder, in, segments, *static_cast<Scratch*>(scratch));
          }};
}

constexpr std::array table = {
    row<NoScratch, run_brute>("brute", {.empty_hits = true}),
    row<SingleRaysScratch, run_single_rays>("single-rays", {.object_hierarchy = true}),
    row<MeshNodesScratch, run_mesh_nodes>("mesh-nodes", {.empty_hits = true, .sorted_rays = true}),
    row<ObjectNodesScratch, run_object_nodes>(
        "object-nodes", {.object_hierarchy = true, .sorted_rays = true, .max_levels = 2}, "single-rays"),
    row<NoScratch, run_ray_query>("ray-query", {.device_hierarchy = true}),
};

}  // namespace

std::span<const Tracer> tracers() { return table; }

const Tracer& tracer_named(std::string_view name) {
  const auto found = std::ranges::find(table, name, &Tracer::name);
  CRSH_ASSERT(found != table.end(), "no tracer of this name");
  return *found;
}

const Tracer& tracer_of(const AlgorithmOptions& options) { return tracer_named(options.tracer); }

void require_sound(const AlgorithmOptions& options) {
  const Needs& needs = tracer_of(options).needs;
  if (!needs.sorted_rays || std::ranges::max(options.levels) <= needs.max_levels) return;
  throw UserError(fmt::format("the algorithm {} has at most {} levels of nodes", options.preset, needs.max_levels),
                  Mend::fewer_levels, Exit::usage);
}

void require_device(const gpu::Device& device, const AlgorithmOptions& options) {
  if (tracer_of(options).needs.device_hierarchy) objects::require_ray_queries(device);
}

void run(gpu::Recorder& recorder, const In& in, const Tracer& tracer, const Segments& segments) {
  std::shared_ptr<void>& scratch = in.workspace.scratch[&tracer];
  if (!scratch) scratch = tracer.scratch();
  tracer.run(recorder, in, segments, scratch.get());
}

}  // namespace crsh::trace
