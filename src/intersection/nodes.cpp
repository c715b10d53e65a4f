#include "intersection/nodes.h"

#include <algorithm>
#include <bit>
#include <iterator>

#include "gpu/clusters.h"

namespace crsh::intersection {
namespace {

using hierarchy::Range;

/// An estimate of the tests of a node and its rays, from which submits are sized.
constexpr uint64_t usual_tests = 256;
/// Groups whose frontiers are in memory at the same time: 16 MiB.
constexpr uint32_t max_groups = 16384;
/// Lanes of a cluster: with more of them each has too little to do (measured on Mesa 22.3 and 25). Then the most rays a
/// lane may have (shaders/intersection/node_rays.glsl).
constexpr uint32_t usual_cluster = 4, max_rows = 8;

class Nodes {
 public:
  Nodes(gpu::Recorder& recorder, const NodesIn& in, const rays::Segment& segment, NodeScratch& scratch,
        SingleScratch& single)
      : recorder_(recorder), in_(in), segment_(segment), scratch_(scratch), single_(single) {}

  void run(Range nodes, Range groups) {
    begin_left(recorder_, segment_, single_);
    if (groups.count == 0) {
      traversal::start_at_root(recorder_, scratch_.frontiers);
      walk(nodes, groups);
    }
    for (uint32_t first = groups.first; first < groups.end(); first += max_groups) {
      const Range some{first, std::min(max_groups, groups.end() - first)};
      traversal::walk_groups(recorder_, in_.traversal, in_.objects, some, scratch_.frontiers);
      walk(in_.traversal.hierarchy.levels[1].children_of(some), some);
    }
    intersect_unfinished(recorder_, in_, in_.objects, segment_, single_);
  }

 private:
  /// Nodes of these groups.
  void walk(Range nodes, Range groups) {
    const uint32_t piece = uint32_t(std::clamp<uint64_t>(in_.traversal.submit_work / usual_tests, 1, nodes.count));
    for (uint32_t first = nodes.first; first < nodes.end(); first += piece)
      walk_piece({first, std::min(piece, nodes.end() - first)}, groups);
  }

  void walk_piece(Range nodes, Range groups) {
    const traversal::In& t = in_.traversal;
    const hierarchy::Level& level = t.hierarchy.levels[0];
    const uint32_t clusters = (nodes.count + nodes_a_cluster() - 1) / nodes_a_cluster();
    const gpu::Buffer& parents = groups.count ? t.hierarchy.levels[1].parents : level.parents;
    const struct {
      uint32_t first_node, node_count, first_group, grouped, clusters, first_ray, use_interval, counter_row,
          box_account, node_account, triangle_account;
    } push{nodes.first,
           nodes.count,
           groups.first,
           groups.count != 0,
           clusters,
           segment_.first,
           t.options.interval,
           t.counter_row,
           t.account.first(shared::tests_object, 1),
           t.account.first(shared::tests_node, 1),
           t.account.first(shared::tests_triangle, 0)};
    recorder_.dispatch(kernel(), uint64_t(clusters) * cluster(), push,
                       {t.scene.sheer_tables,
                        {"corner_a", in_.objects.leaf_a},
                        {"corner_b", in_.objects.leaf_b},
                        {"corner_c", in_.objects.leaf_c},
                        {"materials", t.scene.materials},
                        {"hits", in_.hits},
                        {"rays", in_.sorted_rays},
                        {"order", in_.order},
                        {"box_low", in_.objects.box_low},
                        {"box_high", in_.objects.box_high},
                        {"node_words", level.nodes},
                        {"rays_of", level.rays},
                        {"parents", parents},
                        {"frontier", scratch_.frontiers},
                        {"unfinished", single_.unfinished},
                        {"counters", t.counters},
                        {"account", t.account.buffer_or(t.counters)}},
                       nodes.count * usual_tests);
    recorder_.submit_past(t.submit_work);
  }

  /// How many nodes each cluster takes, one after the other.
  [[nodiscard]] uint32_t nodes_a_cluster() const {
    return cluster() > 1 ? recorder_.device().tuning().nodes_a_cluster : 1;
  }

  /// How many lanes take a node; 1 where lanes cannot pass values to each other, or a subgroup has too few for a node's
  /// rays.
  [[nodiscard]] uint32_t cluster() const {
    const uint32_t rays = std::bit_ceil(in_.traversal.options.arity);
    const uint32_t lanes = std::min(rays, std::max(usual_cluster, rays / max_rows));
    return gpu::may_cluster(recorder_.device(), lanes) ? lanes : 1;
  }

  [[nodiscard]] gpu::Kernel kernel() const {
    const std::string variant = cluster() == 1 ? "-no-shuffle" : "";
    std::vector<std::pair<uint32_t, uint32_t>> constants = hierarchy::test_constants(in_.traversal.options);
    constants.emplace_back(0, in_.traversal.drop_every);
    std::ranges::copy(in_.traversal.scene.sheer_constants(), std::back_inserter(constants));
    const uint32_t lanes = cluster(), arity = in_.traversal.options.arity;
    if (lanes > 1) constants.insert(constants.end(), {{2, lanes}, {3, (arity + lanes - 1) / lanes}});
    return in_.traversal.account.kernel("intersection/node_walk" + variant + "@" + in_.traversal.options.bound,
                                        constants);
  }

  gpu::Recorder& recorder_;
  const NodesIn& in_;
  const rays::Segment& segment_;
  NodeScratch& scratch_;
  SingleScratch& single_;
};

}  // namespace

void intersect_nodes(gpu::Recorder& recorder, const NodesIn& in, size_t segment, NodeScratch& scratch,
                     SingleScratch& single) {
  const rays::Segment& rays = in.batch.segments[segment];
  if (rays.count == 0) return;
  const hierarchy::Hierarchy& hierarchy = in.traversal.hierarchy;
  const Range groups = in.traversal.options.levels[rays.kind] > 1 ? hierarchy.levels[1].segments[segment] : Range{};
  recorder.stage(Stage::hierarchy_traversal);
  Nodes(recorder, in, rays, scratch, single).run(hierarchy.levels[0].segments[segment], groups);
}

}  // namespace crsh::intersection
