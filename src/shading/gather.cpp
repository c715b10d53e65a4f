#include "shading/gather.h"

#include "crsh/kinds.h"
#include "primitives/grow.h"

namespace crsh::shading {
namespace {

/// As shading/gather_own.comp declares it.
struct OwnPush {
  glm::vec3 background;
  uint32_t count;
};

/// As shading/gather.comp declares it.
struct Push {
  uint32_t first_surface, count, first_slot, first_ray;
};

/// Room for what each kind brought, and nothing in it.
void clear_brought(gpu::Recorder& recorder, uint32_t count, Gathered& out) {
  for (uint32_t kind = 0; kind < kind_count; ++kind) {
    if (ray_kinds[kind].any_hit) continue;
    primitives::grow(recorder, out.brought[kind], count * uint64_t(sizeof(glm::vec4)), "light by kind of ray");
    recorder.fill(out.brought[kind], 0, count * uint64_t(4));
  }
}

/// Adds what the batch's rays of one kind brought.
void add_kind(gpu::Recorder& recorder, const surfaces::Generation& generation, const surfaces::Children& children,
              uint32_t kind, const Gathered& out, Parts parts) {
  const surfaces::ChildRun& run = children.of_kind[kind];
  if (run.first_slot == shared::none || !children.totals || children.totals->bytes() == 0) return;
  const bool wanted = parts == Parts::wanted;
  const Push push{children.first_surface, children.surfaces, run.first_slot, run.first_ray - run.first_child};
  recorder.dispatch({"shading/gather", {{0, wanted}}}, push.count, push,
                    {{"weights", generation.weights[kind]},
                     {"ends", children.ends},
                     {"child_totals", *children.totals},
                     {"totals", out.total},
                     {"brought", wanted ? out.brought[kind] : out.total}});
}

}  // namespace

void gather(gpu::Recorder& recorder, const surfaces::Generation& generation, glm::vec3 background, Gathered& out,
            Parts parts) {
  primitives::grow(recorder, out.total, generation.count * uint64_t(sizeof(glm::vec4)), "gathered light");
  if (parts == Parts::wanted) clear_brought(recorder, generation.count, out);
  recorder.dispatch("shading/gather_own", generation.count, OwnPush{background, generation.count},
                    {{"emissions", generation.emission}, {"direct", generation.direct}, {"totals", out.total}});
  for (const surfaces::Children& children : generation.children)
    for (uint32_t kind = 0; kind < kind_count; ++kind) add_kind(recorder, generation, children, kind, out, parts);
}

}  // namespace crsh::shading
