#include "shading/gather.h"

#include "primitives/grow.h"
#include "shared/ray.h"

namespace crsh::shading {
namespace {

/// As shading/gather.comp declares them.
struct Link {
  uint32_t first_slot = 0, first_ray = 0, any = 0;
};
struct Push {
  uint32_t first_surface, count;
  Link reflection, refraction;
  glm::vec3 background;
};

/// The surfaces [first, first + count) and where their children of each kind are.
struct Portion {
  uint32_t first = 0, count = 0;
  const surfaces::Children* reflection = nullptr;
  const surfaces::Children* refraction = nullptr;
};

/// Batches split surfaces at the same places, so children of different batches cover the same surfaces, or none in
/// common.
std::vector<Portion> portions_of(const surfaces::Generation& generation) {
  std::vector<Portion> portions;
  for (const surfaces::Children& children : generation.children) {
    if (portions.empty() || portions.back().first != children.first_surface)
      portions.push_back({children.first_surface, children.surfaces});
    if (children.first_slot[shared::kind_reflection] != shared::none) portions.back().reflection = &children;
    if (children.first_slot[shared::kind_refraction] != shared::none) portions.back().refraction = &children;
  }
  if (portions.empty()) portions.push_back({0, generation.count});
  return portions;
}

Link link_of(const surfaces::Children* children, uint32_t kind) {
  if (!children || !children->totals) return {};
  return {children->first_slot[kind], children->first_ray - children->first_child, 1};
}

/// Something that can be bound stands in where there is nothing to read.
const gpu::Buffer& or_else(const gpu::Buffer& buffer, const gpu::Buffer& stand_in) {
  return buffer.bytes() ? buffer : stand_in;
}

void gather_portion(gpu::Recorder& recorder, const surfaces::Generation& g, const Portion& portion,
                    glm::vec3 background, const Gathered& out, Parts parts) {
  const Link reflection = link_of(portion.reflection, shared::kind_reflection);
  const Link refraction = link_of(portion.refraction, shared::kind_refraction);
  const gpu::Buffer& nothing = g.emission;
  const auto ends = [&](const Link& link, const surfaces::Children* c) -> const gpu::Buffer& {
    return link.any ? c->ends : nothing;
  };
  const auto totals = [&](const Link& link, const surfaces::Children* c) -> const gpu::Buffer& {
    return link.any ? or_else(*c->totals, nothing) : nothing;
  };
  recorder.dispatch({"shading/gather", {{0, parts == Parts::wanted}}}, portion.count,
                    Push{portion.first, portion.count, reflection, refraction, background},
                    {{"emissions", g.emission},
                     {"direct", g.direct},
                     {"reflection_weights", or_else(g.reflection_weight, nothing)},
                     {"refraction_weights", or_else(g.refraction_weight, nothing)},
                     {"reflection_ends", ends(reflection, portion.reflection)},
                     {"refraction_ends", ends(refraction, portion.refraction)},
                     {"reflection_totals", totals(reflection, portion.reflection)},
                     {"refraction_totals", totals(refraction, portion.refraction)},
                     {"totals", out.total},
                     {"reflected", or_else(out.reflection, out.total)},
                     {"refracted", or_else(out.refraction, out.total)}});
}

}  // namespace

void gather(gpu::Recorder& recorder, const surfaces::Generation& generation, glm::vec3 background, Gathered& out,
            Parts parts) {
  const uint64_t bytes = generation.count * uint64_t(sizeof(glm::vec4));
  primitives::grow(recorder, out.total, bytes, "gathered light");
  if (parts == Parts::wanted) {
    primitives::grow(recorder, out.reflection, bytes, "reflected light");
    primitives::grow(recorder, out.refraction, bytes, "refracted light");
  }
  for (const Portion& portion : portions_of(generation))
    gather_portion(recorder, generation, portion, background, out, parts);
}

}  // namespace crsh::shading
