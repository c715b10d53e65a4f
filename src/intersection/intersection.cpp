#include "intersection/intersection.h"

#include <algorithm>

#include "shared/counters.h"
#include "shared/limits.h"

namespace crsh::intersection {

void clear(gpu::Recorder& recorder, const rays::Batch& batch, const gpu::Buffer& hits) {
  recorder.stage(Stage::final_intersection);
  recorder.dispatch("intersection/clear", batch.count, batch.count, {{"rays", batch.rays}, {"hits", hits}});
}

void intersect(gpu::Recorder& recorder, const In& in, const hierarchy::Hierarchy& hierarchy,
               const gpu::Buffer& sorted_rays, const gpu::Buffer& order, const traversal::Candidates& candidates) {
  recorder.stage(Stage::final_intersection);
  const hierarchy::Level& level = hierarchy.levels.front();
  const struct {
    uint32_t first_node, node_count, max_rays, first_base, pairs_before, tests_counter, first_account;
  } push{candidates.first_node,
         candidates.end_node - candidates.first_node,
         level.max_children,
         candidates.first_base,
         candidates.pairs_before,
         in.counter_row + shared::counter_triangle_tests,
         in.account.first(shared::tests_triangle, 0)};
  recorder.dispatch(in.account.kernel(std::string("intersection/candidates") + recorder.device().lane_variant(),
                                      in.scene.sheer_constants()),
                    uint64_t(push.node_count) * push.max_rays, push,
                    {in.scene.sheer_tables,
                     {"corner_a", in.scene.corner_a},
                     {"corner_b", in.scene.corner_b},
                     {"corner_c", in.scene.corner_c},
                     {"materials", in.scene.materials},
                     {"hits", in.hits},
                     {"rays", sorted_rays},
                     {"order", order},
                     {"rays_of", level.children},
                     {"bases", candidates.bases},
                     {"pairs", candidates.pairs},
                     {"counters", in.counters},
                     {"account", in.account.buffer_or(in.counters)}},
                    candidates.count * level.max_children);
  recorder.submit_past(in.submit_work);
  recorder.stage(Stage::hierarchy_traversal);
}

void intersect_all(gpu::Recorder& recorder, const In& in, const rays::Segment& segment) {
  if (segment.count == 0) return;
  recorder.stage(Stage::final_intersection);
  const uint32_t triangles = in.scene.triangle_count;
  const uint32_t loop =
      static_cast<uint32_t>(std::clamp<uint64_t>(in.submit_work / 64, 256, shared::max_loop_triangles));
  const uint32_t piece = static_cast<uint32_t>(std::clamp<uint64_t>(in.submit_work / loop, 1, segment.count));
  for (uint32_t first = 0; first < triangles; first += loop)
    for (uint32_t ray = 0; ray < segment.count; ray += piece) {
      const struct {
        uint32_t first_ray, ray_count, first_triangle, triangle_count, tests_counter, first_account;
      } push{segment.first + ray,
             std::min(piece, segment.count - ray),
             first,
             std::min(loop, triangles - first),
             in.counter_row + shared::counter_triangle_tests,
             in.account.first(shared::tests_triangle, 0)};
      recorder.dispatch(in.account.kernel(std::string("intersection/brute") + recorder.device().lane_variant(),
                                          in.scene.sheer_constants()),
                        push.ray_count, push,
                        {in.scene.sheer_tables,
                         {"corner_a", in.scene.corner_a},
                         {"corner_b", in.scene.corner_b},
                         {"corner_c", in.scene.corner_c},
                         {"materials", in.scene.materials},
                         {"hits", in.hits},
                         {"rays", in.batch.rays},
                         {"counters", in.counters},
                         {"account", in.account.buffer_or(in.counters)}},
                        uint64_t(push.ray_count) * push.triangle_count);
      recorder.submit_past(in.submit_work);
    }
}

void digest(gpu::Recorder& recorder, const In& in, const rays::Segment& segment, uint32_t first_surface,
            const gpu::Buffer& pixels, const gpu::Buffer& paths) {
  constexpr uint32_t rays_a_lane = 8;
  const uint32_t lanes = (segment.count + rays_a_lane - 1) / rays_a_lane;
  const struct {
    uint32_t first_ray, ray_count, lanes, surfaces, first_surface, kind, light, hits_counter, digest_counter,
        alpha_counter;
  } push{segment.first,
         segment.count,
         lanes,
         in.batch.surfaces,
         first_surface,
         segment.kind,
         segment.light,
         in.counter_row + shared::counter_ray_hits,
         in.counter_row + shared::counter_digest,
         in.counter_row + shared::counter_alpha_tests};
  recorder.dispatch("intersection/digest", lanes, push,
                    {{"slots", in.batch.slots},
                     {"hits", in.hits},
                     {"diffuse_pixel", pixels},
                     {"specular_path", paths},
                     {"counters", in.counters}});
}

}  // namespace crsh::intersection
