#include "surfaces/surfaces.h"

#include "crsh/assertion.h"
#include "primitives/grow.h"

namespace crsh::surfaces {
namespace {

/// As surfaces/from_raster.comp declares it.
struct RasterPush {
  glm::vec3 eye;
  float orthographic;
  glm::vec3 forward;
  uint32_t tiles;
  glm::uvec2 size;
  uint32_t first, count;
  float cone_spread, cone_width;
  uint32_t sheets;
};

/// As surfaces/from_hits.comp declares it.
struct HitsPush {
  uint32_t first_ray, count, slots, first_parent, first_out, turn;
  float cone_spread;
  uint32_t sheets;
};

constexpr uint64_t word_bytes = sizeof(glm::vec4);

void clear_direct(gpu::Recorder& recorder, const Generation& generation, uint32_t first, uint32_t count) {
  recorder.fill(generation.direct, 0, uint64_t(count) * 4, uint64_t(first) * 4);
}

/// What a kernel reads, and where it puts the surfaces that it finds (shaders/surfaces/surfaces.glsl).
std::vector<gpu::Argument> with_outputs(std::vector<gpu::Argument> read, const Surfaces& surfaces,
                                        const Generation& generation) {
  const gpu::Argument outputs[] = {{"out_position", surfaces.position},   {"out_normal", surfaces.normal},
                                   {"out_geometric", surfaces.geometric}, {"out_incoming", surfaces.incoming},
                                   {"out_diffuse", surfaces.diffuse},     {"out_specular", surfaces.specular},
                                   {"out_emission", generation.emission}, {"out_footprint", surfaces.footprint},
                                   {"out_lobes", surfaces.lobes}};
  read.insert(read.end(), std::begin(outputs), std::end(outputs));
  return read;
}

/// What solids take of the light of one kind's rays.
void absorb(gpu::Recorder& recorder, const FromHitsIn& in, uint32_t kind, const Surfaces& surfaces) {
  const ChildRun& run = in.children.of_kind[kind];
  const struct {
    uint32_t first_ray, count, slots, first_parent, first_out;
  } push{run.first_ray, run.count, in.children.surfaces, in.children.first_surface, run.first_child};
  recorder.dispatch("surfaces/absorb", push.count, push,
                    {in.scene.tables,
                     {"slot_of", in.slots},
                     {"hits", in.hits},
                     {"weights", in.parent_weights[kind]},
                     {"surface_lobes", surfaces.lobes}});
}

/// Where the rays of one kind hit.
void add_hits(gpu::Recorder& recorder, const FromHitsIn& in, uint32_t kind, const Surfaces& surfaces,
              const Generation& generation) {
  const Children& children = in.children;
  const ChildRun& run = children.of_kind[kind];
  clear_direct(recorder, generation, run.first_child, run.count);
  const HitsPush push{run.first_ray,        run.count,      children.surfaces, children.first_surface, run.first_child,
                      ray_kinds[kind].turn, in.cone_spread, in.sheets};
  recorder.dispatch(in.scene.with_lobes("surfaces/from_hits"), push.count, push,
                    with_outputs({in.scene.tables,
                                  {"rays", in.rays},
                                  {"slot_of", in.slots},
                                  {"hits", in.hits},
                                  {"parent_diffuse", in.parents.diffuse},
                                  {"parent_specular", in.parents.specular},
                                  {"parent_footprint", in.parents.footprint}},
                                 surfaces, generation));
  if (in.scene.has_lobes && run.count) absorb(recorder, in, kind, surfaces);
}

}  // namespace

void reserve(gpu::Recorder& recorder, Surfaces& surfaces, Generation& generation, uint32_t count, bool lobes) {
  const uint64_t bytes = count * word_bytes;
  primitives::grow(recorder, surfaces.position, bytes, "surface positions");
  primitives::grow(recorder, surfaces.normal, bytes, "surface normals");
  primitives::grow(recorder, surfaces.geometric, bytes, "geometric normals");
  primitives::grow(recorder, surfaces.incoming, bytes, "incoming directions");
  primitives::grow(recorder, surfaces.diffuse, bytes, "diffuse properties");
  primitives::grow(recorder, surfaces.specular, bytes, "specular properties");
  primitives::grow(recorder, surfaces.footprint, count * uint64_t(sizeof(glm::vec2)), "footprints");
  primitives::grow(recorder, surfaces.lobes, lobes ? bytes * shared::surface_lobe_words : word_bytes, "surface lobes");
  primitives::grow(recorder, generation.emission, bytes, "emission");
  primitives::grow(recorder, generation.direct, bytes, "direct light");
}

void from_raster(gpu::Recorder& recorder, const FromRasterIn& in, Surfaces& surfaces, Generation& generation) {
  reserve(recorder, surfaces, generation, in.count, in.scene.has_lobes);
  surfaces.count = generation.count = in.count;
  clear_direct(recorder, generation, 0, in.count);
  const raster::CameraView& view = in.view;
  const raster::PixelCone cone = raster::pixel_cone(view, in.size);
  const RasterPush push{view.eye,
                        view.orthographic ? 1.0f : 0.0f,
                        view.forward,
                        in.order == RayOrder::tiles ? 1u : 0u,
                        {in.size.width, in.size.height},
                        in.first,
                        in.count,
                        cone.spread,
                        cone.width,
                        in.sheets};
  const raster::GBuffer& g = in.gbuffer;
  recorder.dispatch(in.scene.with_lobes("surfaces/from_raster"), in.count, push,
                    with_outputs({in.scene.tables,
                                  {"positions", g.position},
                                  {"normals", g.normal},
                                  {"diffuses", g.diffuse},
                                  {"speculars", g.specular},
                                  {"ids", g.triangle}},
                                 surfaces, generation));
}

void from_hits(gpu::Recorder& recorder, const FromHitsIn& in, Surfaces& surfaces, Generation& generation) {
  const Children& children = in.children;
  CRSH_ASSERT(surfaces.position.bytes() >= children.end * word_bytes, "surfaces without room for a batch's hits");
  surfaces.count = generation.count = children.end;
  for (uint32_t kind = 0; kind < kind_count; ++kind) add_hits(recorder, in, kind, surfaces, generation);
}

}  // namespace crsh::surfaces
