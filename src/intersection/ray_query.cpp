#include "intersection/ray_query.h"

#include <algorithm>

namespace crsh::intersection {

void query(gpu::Recorder& recorder, const In& in, const objects::DeviceHierarchy& objects, bool plain,
           const rays::Segment& segment) {
  constexpr uint64_t usual_tests = 256;  // an estimate for a ray, from which submits are sized
  if (segment.count == 0 || !objects.structure) return;
  recorder.stage(Stage::final_intersection);
  const uint32_t piece = uint32_t(std::clamp<uint64_t>(in.submit_work / usual_tests, 1, segment.count));
  for (uint32_t done = 0; done < segment.count; done += piece) {
    const uint32_t count = std::min(piece, segment.count - done);
    const struct {
      uint32_t first;
      uint32_t end;
    } push{segment.first + done, segment.first + done + count};
    std::vector<std::pair<uint32_t, uint32_t>> constants = in.scene.sheer_constants();
    constants.emplace_back(0, plain && constants.empty());
    recorder.dispatch({"intersection/ray_query", constants}, count, push,
                      {in.scene.sheer_tables,
                       {"scene", *objects.structure},
                       {"rays", in.batch.rays},
                       {"hits", in.hits},
                       {"corner_a", in.scene.corner_a},
                       {"materials", in.scene.materials}},
                      count * usual_tests);
    recorder.submit_past(in.submit_work);
  }
}

}  // namespace crsh::intersection
