#include "traversal/groups.h"

#include "gpu/clusters.h"
#include "primitives/grow.h"
#include "shared/counters.h"
#include "shared/walk.h"

namespace crsh::traversal {
namespace {

/// An estimate of the tests of a group, from which submits are sized.
constexpr uint64_t usual_tests = 256;
/// How many groups walk together: lanes of a cluster (shaders/traversal/group_walk.comp).
constexpr uint32_t cluster = 4;

void reserve(gpu::Recorder& recorder, gpu::Buffer& frontiers, uint64_t lists) {
  primitives::grow(recorder, frontiers, lists * shared::frontier_room * sizeof(glm::uvec2), "frontiers");
}

}  // namespace

void walk_groups(gpu::Recorder& recorder, const In& in, const objects::Hierarchy& objects, hierarchy::Range groups,
                 gpu::Buffer& frontiers) {
  recorder.stage(Stage::hierarchy_traversal);
  reserve(recorder, frontiers, groups.count);
  const hierarchy::Level& level = in.hierarchy.levels[1];
  const struct {
    uint32_t first_group, group_count, use_interval, box_counter, first_account;
  } push{groups.first, groups.count, in.options.interval, in.counter_row + shared::counter_box_tests,
         in.account.first(shared::tests_object, 2)};
  const std::string variant = gpu::may_cluster(recorder.device(), cluster) ? "" : "-no-shuffle";
  recorder.dispatch(in.account.kernel("traversal/group_walk" + variant + "@" + in.options.bound,
                                      hierarchy::test_constants(in.options)),
                    groups.count, push,
                    {{"nodes", level.nodes},
                     {"intervals", level.intervals},
                     {"box_low", objects.box_low},
                     {"box_high", objects.box_high},
                     {"frontier", frontiers},
                     {"counters", in.counters},
                     {"account", in.account.buffer_or(in.counters)}},
                    groups.count * usual_tests);
  recorder.submit_past(in.submit_work);
}

void start_at_root(gpu::Recorder& recorder, gpu::Buffer& frontiers) {
  reserve(recorder, frontiers, 1);
  recorder.fill(frontiers, 0, 6);
  recorder.fill(frontiers, 2, 1);     // entries
  recorder.fill(frontiers, 1, 1, 4);  // the second one's slot
}

}  // namespace crsh::traversal
