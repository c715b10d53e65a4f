#include "intersection/single.h"

#include <algorithm>
#include <iterator>
#include <vector>

#include "primitives/grow.h"
#include "shared/counters.h"
#include "shared/object.h"

namespace crsh::intersection {
namespace {

/// Tests of a ray, for a submit's account: most rays need fewer. None takes more than `max_tests`, or about, in one
/// dispatch (shaders/intersection/walk.glsl).
constexpr uint64_t usual_tests = 256, max_tests = 1280;
/// Rays that are walked in pieces together.
constexpr uint64_t max_resumed = 4096;

/// An empty list with room for so many rays.
void begin_list(gpu::Recorder& recorder, uint32_t rays, gpu::Buffer& list, const char* name) {
  primitives::grow(recorder, list, primitives::quad_bytes(uint64_t(rays) + 1), name);
  recorder.fill(list, 0, 1);
}

class SingleRays {
 public:
  SingleRays(gpu::Recorder& recorder, const In& in, const objects::Hierarchy& objects, const rays::Segment& segment,
             SingleScratch& scratch)
      : recorder_(recorder), in_(in), objects_(objects), segment_(segment), scratch_(scratch) {}

  /// All rays of the segment.
  void run() {
    begin_left(recorder_, segment_, scratch_);
    walk_all(segment_.count, nullptr, scratch_.unfinished);
  }

  /// The first so many of scratch.unfinished.
  void run_unfinished(uint32_t count) {
    begin_list(recorder_, count, scratch_.still_unfinished, "rays still unfinished");
    walk_all(count, &scratch_.unfinished, scratch_.still_unfinished);
  }

 private:
  /// As both kernels declare them.
  struct Push {
    uint32_t first_ray, first, end_or_count, box_counter, triangle_counter, box_account, triangle_account;
  };

  [[nodiscard]] Push push_of(uint32_t first, uint32_t end_or_count) const {
    return {segment_.first,
            first,
            end_or_count,
            in_.counter_row + shared::counter_box_tests,
            in_.counter_row + shared::counter_triangle_tests,
            in_.account.first(shared::tests_object, 0),
            in_.account.first(shared::tests_triangle, 0)};
  }

  /// These and what every walk reads and counts: the object hierarchy, its triangles, the rays and their hits.
  [[nodiscard]] std::vector<gpu::Argument> with_scene(std::vector<gpu::Argument> arguments) const {
    const gpu::Argument common[] = {in_.scene.sheer_tables,
                                    {"corner_a", objects_.leaf_a},
                                    {"corner_b", objects_.leaf_b},
                                    {"corner_c", objects_.leaf_c},
                                    {"materials", in_.scene.materials},
                                    {"hits", in_.hits},
                                    {"rays", in_.batch.rays},
                                    {"counters", in_.counters},
                                    {"box_low", objects_.box_low},
                                    {"box_high", objects_.box_high},
                                    {"account", in_.account.buffer_or(in_.counters)}};
    arguments.insert(arguments.end(), std::begin(common), std::end(common));
    return arguments;
  }

  /// So many rays, of the list if there is one; what they leave goes to `unfinished`, which is empty.
  void walk_all(uint32_t count, const gpu::Buffer* list, const gpu::Buffer& unfinished) {
    const uint32_t piece = uint32_t(std::clamp<uint64_t>(in_.submit_work / usual_tests, 1, count));
    for (uint32_t first = 0; first < count; first += piece)
      walk(first, std::min(piece, count - first), list, unfinished);
    if (const uint32_t still = recorder_.read<uint32_t>(unfinished, 1)[0]) walk_unfinished(unfinished, still);
  }

  void walk(uint32_t first, uint32_t count, const gpu::Buffer* list, const gpu::Buffer& unfinished) {
    const struct {
      Push push;
      uint32_t listed;
    } push{push_of(first, first + count), list != nullptr};
    recorder_.dispatch(in_.account.kernel("intersection/single", in_.scene.sheer_constants()), count, push,
                       with_scene({{"unfinished", unfinished}, {"list", list ? *list : in_.counters}}),
                       count * usual_tests);
    recorder_.submit_past(in_.submit_work);
  }

  void walk_unfinished(const gpu::Buffer& list, uint32_t count) {
    const uint32_t piece = uint32_t(std::clamp<uint64_t>(in_.submit_work / max_tests, 1, max_resumed));
    primitives::grow(recorder_, scratch_.walking, sizeof(uint32_t), "number of rays walked");
    primitives::grow(recorder_, scratch_.states, piece * sizeof(glm::uvec2), "states of rays");
    primitives::grow(recorder_, scratch_.stacks, piece * shared::max_object_depth * sizeof(glm::uvec2),
                     "stacks of rays");
    for (uint32_t first = 0; first < count; first += piece) walk_in_pieces(list, first, std::min(piece, count - first));
  }

  /// Walks these rays from the root again, dispatch after dispatch, until all have ended.
  void walk_in_pieces(const gpu::Buffer& list, uint32_t first, uint32_t count) {
    recorder_.fill(scratch_.states, 0, 2 * uint64_t(count));
    do {
      recorder_.fill(scratch_.walking, 0, 1);
      recorder_.dispatch(in_.account.kernel("intersection/single_resume", in_.scene.sheer_constants()), count,
                         push_of(first, count),
                         with_scene({{"list", list},
                                     {"walking", scratch_.walking},
                                     {"states", scratch_.states},
                                     {"stacks", scratch_.stacks}}),
                         count * max_tests);
    } while (recorder_.read<uint32_t>(scratch_.walking, 1)[0]);
  }

  gpu::Recorder& recorder_;
  const In& in_;
  const objects::Hierarchy& objects_;
  const rays::Segment& segment_;
  SingleScratch& scratch_;
};

}  // namespace

void intersect_single(gpu::Recorder& recorder, const In& in, const objects::Hierarchy& objects,
                      const rays::Segment& segment, SingleScratch& scratch) {
  if (segment.count == 0) return;
  recorder.stage(Stage::final_intersection);
  SingleRays(recorder, in, objects, segment, scratch).run();
}

void begin_left(gpu::Recorder& recorder, const rays::Segment& segment, SingleScratch& scratch) {
  begin_list(recorder, segment.count, scratch.unfinished, "unfinished rays");
}

void intersect_unfinished(gpu::Recorder& recorder, const In& in, const objects::Hierarchy& objects,
                          const rays::Segment& segment, SingleScratch& scratch) {
  const uint32_t unfinished = recorder.read<uint32_t>(scratch.unfinished, 1)[0];
  if (unfinished == 0) return;
  recorder.stage(Stage::final_intersection);
  SingleRays(recorder, in, objects, segment, scratch).run_unfinished(unfinished);
}

}  // namespace crsh::intersection
