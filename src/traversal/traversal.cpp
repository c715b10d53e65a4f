#include "traversal/traversal.h"

#include <algorithm>

#include "primitives/grow.h"
#include "shared/counters.h"
#include "shared/limits.h"
#include "shared/node.h"

namespace crsh::traversal {
namespace {

using hierarchy::Level;
using hierarchy::Range;
using primitives::grow;
using primitives::quad_bytes;

/// Children to test or to emit, as shaders/traversal/descend.glsl has them.
struct Slice {
  uint32_t first_child, child_count, first_parent, parent_count, first_base, pairs_before, arity;
};

/// Bases of the pairs of consecutive nodes, on the host: where a list is cut into slices.
struct Bases {
  uint32_t first_node = 0;
  std::vector<uint32_t> values;  ///< with sentinel
  [[nodiscard]] uint32_t of(uint32_t node) const { return values[node - first_node]; }
  [[nodiscard]] uint32_t end() const { return first_node + static_cast<uint32_t>(values.size()) - 1; }
};

/// Blocks of triangles of one batch.
struct BlockRange {
  uint32_t first = 0, count = 0;
};

/// One walk down the tree. Level indices count from 0 (level 1 of the paper).
class Descent {
 public:
  Descent(gpu::Recorder& recorder, const In& in, Scratch& scratch,
          const std::function<void(const Candidates&)>& intersect)
      : recorder_(recorder), device_(recorder.device()), in_(in), scratch_(scratch), intersect_(intersect) {}

  void run(uint32_t depth, Range nodes) {
    if (scratch_.levels.size() < depth) scratch_.levels.resize(depth);
    top_ = depth - 1;
    give_back();
    const uint32_t blocks = std::min(blocks_a_batch(), in_.scene.block_count);
    const uint64_t tests_a_node = uint64_t(blocks) * shared::block_triangles;
    const uint32_t piece = static_cast<uint32_t>(std::clamp<uint64_t>(in_.submit_work / tests_a_node, 1, nodes.count));
    for (uint32_t first = nodes.first; first < nodes.end(); first += piece) {
      const Range piece_nodes{first, std::min(piece, nodes.end() - first)};
      cull_meshes(piece_nodes);
      for (uint32_t block = 0; block < in_.scene.block_count; block += blocks)
        test_top(piece_nodes, {block, std::min(blocks, in_.scene.block_count - block)});
    }
  }

 private:
  /// How many blocks of triangles are tested at a time. A lane loops over a node's list of them, so this bounds its
  /// loop; and small submits need few.
  [[nodiscard]] uint32_t blocks_a_batch() const {
    const uint64_t blocks = in_.submit_work / (shared::block_triangles * 64);
    return static_cast<uint32_t>(std::clamp<uint64_t>(blocks, 8, shared::max_loop_triangles / shared::block_triangles));
  }

  [[nodiscard]] const Level& level(uint32_t index) const { return in_.hierarchy.levels[index]; }
  [[nodiscard]] uint32_t counter(uint32_t which) const { return in_.counter_row + which; }
  [[nodiscard]] uint32_t first_account(uint32_t kind, uint32_t index) const {
    return in_.account.first(kind, index + 1);
  }
  /// The kernel's build for the bound at hand.
  [[nodiscard]] gpu::Kernel testing(const std::string& kernel) const {
    return in_.account.kernel(kernel + "@" + in_.options.bound, hierarchy::test_constants(in_.options));
  }
  [[nodiscard]] gpu::Kernel testing_with_lanes(const std::string& kernel) const {
    return testing(kernel + device_.lane_variant());
  }
  [[nodiscard]] uint32_t words() const { return in_.options.mesh_culling ? (in_.scene.instance_count + 31) / 32 : 0; }

  void cull_meshes(Range nodes) {
    const uint64_t count = uint64_t(nodes.count) * words();
    grow(recorder_, scratch_.mesh_hits, std::max<uint64_t>(count, 1) * sizeof(uint32_t), "mesh hits");
    const struct {
      uint32_t first_node, node_count, object_count, use_interval, counter, first_account;
    } push{nodes.first,
           nodes.count,
           in_.scene.instance_count,
           in_.options.interval,
           counter(shared::counter_mesh_tests),
           first_account(shared::tests_object, top_)};
    recorder_.dispatch(testing("traversal/mesh_spheres"), count, push,
                       {{"nodes", level(top_).nodes},
                        {"intervals", level(top_).intervals},
                        {"object_spheres", in_.scene.object_spheres},
                        {"mesh_hits", scratch_.mesh_hits},
                        {"counters", in_.counters},
                        {"account", in_.account.buffer_or(in_.counters)}},
                       count * 32);
    recorder_.submit_past(in_.submit_work);
  }

  void test_top(Range nodes, BlockRange blocks) {
    LevelScratch& lists = scratch_.levels[top_];
    const uint64_t masks = uint64_t(nodes.count) * blocks.count;
    grow(recorder_, lists.masks, masks * sizeof(uint32_t), "top level masks");
    grow(recorder_, lists.counts, quad_bytes(masks + 1), "top level counts");
    grow(recorder_, lists.bases, (nodes.count + 1) * sizeof(uint32_t), "pair bases");
    const uint32_t lanes = device_.info().subgroup_size;
    const uint32_t padded = (nodes.count + lanes - 1) / lanes * lanes;
    const struct {
      uint32_t first_node, node_count, padded_nodes, first_block, block_count, words, use_interval, tests, hits,
          first_account;
    } push{nodes.first,
           nodes.count,
           padded,
           blocks.first,
           blocks.count,
           words(),
           in_.options.interval,
           counter(shared::counter_level_tests + top_),
           counter(shared::counter_level_hits + top_),
           first_account(shared::tests_node, top_)};
    recorder_.dispatch(testing_with_lanes("traversal/top"), uint64_t(padded) * blocks.count, push,
                       {{"nodes", level(top_).nodes},
                        {"intervals", level(top_).intervals},
                        {"blocks", in_.scene.blocks},
                        {"triangle_spheres", in_.scene.triangle_spheres},
                        {"mesh_hits", scratch_.mesh_hits},
                        {"masks", lists.masks},
                        {"counts", lists.counts},
                        {"counters", in_.counters},
                        {"account", in_.account.buffer_or(in_.counters)},
                        {"corner_a", in_.scene.corner_a},
                        {"corner_b", in_.scene.corner_b},
                        {"corner_c", in_.scene.corner_c}},
                       masks * shared::block_triangles);
    primitives::scan(recorder_, scratch_.scan, lists.counts, lists.counts, masks + 1, primitives::ScanType::exclusive);
    const struct {
      uint32_t count;
      uint32_t stride;
    } bases_push{nodes.count + 1, blocks.count};
    recorder_.dispatch("traversal/bases", nodes.count + 1, bases_push,
                       {{"scanned", lists.counts}, {"bases", lists.bases}});
    const Bases bases{nodes.first, recorder_.read<uint32_t>(lists.bases, nodes.count + 1)};
    for_slices(bases, level(top_).max_children, [&](Range slice) {
      emit_top(nodes, slice, blocks, bases);
      go_on(top_, slice, slice.first - nodes.first, bases);
    });
  }

  void emit_top(Range piece, Range slice, BlockRange blocks, const Bases& bases) {
    LevelScratch& lists = scratch_.levels[top_];
    const struct {
      uint32_t first_node, node_offset, node_count, first_block, block_count, pairs_before;
    } push{piece.first, slice.first - piece.first, slice.count, blocks.first, blocks.count, bases.of(slice.first)};
    reserve_pairs(lists, bases.of(slice.end()) - bases.of(slice.first));
    recorder_.dispatch(
        {"traversal/emit_top", drop()}, uint64_t(slice.count) * blocks.count, push,
        {{"blocks", in_.scene.blocks}, {"masks", lists.masks}, {"scanned", lists.counts}, {"pairs", lists.pairs}});
  }

  /// Tests the pairs of `nodes` (all in levels[index].pairs) against the nodes' children; at level 1 hands them to the
  /// final intersection.
  void go_on(uint32_t index, Range nodes, uint32_t first_base, const Bases& bases) {
    LevelScratch& lists = scratch_.levels[index];
    const uint32_t pairs = bases.of(nodes.end()) - bases.of(nodes.first);
    if (index == 0) {
      intersect_(
          {lists.pairs, bases_of(lists, index), first_base, nodes.first, nodes.end(), pairs, bases.of(nodes.first)});
      return;
    }
    const Range children = level(index).children_of(nodes);
    const Slice all{children.first,        children.count,           nodes.first, nodes.count, first_base,
                    bases.of(nodes.first), level(index).max_children};
    test_children(index - 1, all, pairs);
    const Bases below{children.first, recorder_.read<uint32_t>(scratch_.levels[index - 1].counts, children.count + 1)};
    for_slices(below, level(index - 1).max_children, [&](Range slice) {
      emit_children(index - 1, all, slice, below);
      go_on(index - 1, slice, slice.first - children.first, below);
    });
  }

  void test_children(uint32_t index, const Slice& slice, uint32_t pairs) {
    LevelScratch& lists = scratch_.levels[index];
    const LevelScratch& above = scratch_.levels[index + 1];
    grow(recorder_, lists.masks, uint64_t(pairs / 32 + slice.parent_count) * slice.arity * sizeof(uint32_t), "masks");
    grow(recorder_, lists.counts, quad_bytes(slice.child_count + 1), "pair bases");
    const struct {
      Slice slice;
      uint32_t use_interval, tests, hits, first_account;
    } push{slice, in_.options.interval, counter(shared::counter_level_tests + index),
           counter(shared::counter_level_hits + index), first_account(shared::tests_node, index)};
    recorder_.dispatch(testing_with_lanes("traversal/descend"), uint64_t(slice.parent_count) * slice.arity, push,
                       {{"nodes", level(index).nodes},
                        {"intervals", level(index).intervals},
                        {"children_of", level(index + 1).children},
                        {"bases", bases_of(above, index + 1)},
                        {"pairs", above.pairs},
                        {"triangle_spheres", in_.scene.triangle_spheres},
                        {"masks", lists.masks},
                        {"counts", lists.counts},
                        {"counters", in_.counters},
                        {"account", in_.account.buffer_or(in_.counters)},
                        {"corner_a", in_.scene.corner_a},
                        {"corner_b", in_.scene.corner_b},
                        {"corner_c", in_.scene.corner_c}},
                       uint64_t(pairs) * slice.arity);
    primitives::scan(recorder_, scratch_.scan, lists.counts, lists.counts, slice.child_count + 1,
                     primitives::ScanType::exclusive);
  }

  void emit_children(uint32_t index, const Slice& all, Range children, const Bases& bases) {
    LevelScratch& lists = scratch_.levels[index];
    const LevelScratch& above = scratch_.levels[index + 1];
    Slice slice = all;
    slice.first_child = children.first;
    slice.child_count = children.count;
    const struct {
      Slice slice;
      uint32_t first_scanned, emitted_before;
    } push{slice, children.first - all.first_child, bases.of(children.first)};
    reserve_pairs(lists, bases.of(children.end()) - bases.of(children.first));
    recorder_.dispatch({"traversal/emit", drop()}, children.count, push,
                       {{"parents", level(index + 1).parents},
                        {"children_of", level(index + 1).children},
                        {"bases", bases_of(above, index + 1)},
                        {"pairs_above", above.pairs},
                        {"masks", lists.masks},
                        {"scanned", lists.counts},
                        {"pairs", lists.pairs}});
  }

  /// The top level's bases are gathered from its blocks; below, the scanned counts are the bases.
  [[nodiscard]] const gpu::Buffer& bases_of(const LevelScratch& lists, uint32_t index) const {
    return index == top_ ? lists.bases : lists.counts;
  }

  /// Cuts the nodes into slices whose pairs fit memory and whose tests against `children` a node fit a submit.
  template <class Function>
  void for_slices(const Bases& bases, uint32_t children, const Function& function) {
    const uint64_t most = std::max<uint64_t>(1, std::min(pair_capacity(), in_.submit_work / children));
    for (uint32_t first = bases.first_node; first < bases.end();) {
      uint32_t end = first + 1;
      while (end < bases.end() && bases.of(end + 1) - bases.of(first) <= most) ++end;
      if (bases.of(end) > bases.of(first)) function(Range{first, end - first});
      first = end;
    }
  }

  /// How many pairs a list may have: as many as a binding holds, and as fit into an equal share of the free memory for
  /// each level.
  [[nodiscard]] uint64_t pair_capacity() const {
    if (in_.max_pairs) return in_.max_pairs;
    constexpr uint64_t bytes_a_pair = sizeof(shared::HitPair) + 8;  // masks and growth besides
    uint64_t held = 0;
    for (const LevelScratch& lists : scratch_.levels) held += lists.pairs.bytes();
    const uint64_t available = device_.available_bytes();
    const uint64_t budget = available > UINT64_MAX - held ? UINT64_MAX : available + held;
    return std::min(device_.limits().max_binding / sizeof(shared::HitPair), budget / (top_ + 1) / bytes_a_pair);
  }

  /// Frees lists larger than a level's share: an earlier descent with fewer levels may have made them.
  void give_back() {
    const uint64_t most = pair_capacity() * sizeof(shared::HitPair);
    const auto holds_more = [&](const LevelScratch& lists) {
      return std::max(lists.pairs.bytes(), lists.masks.bytes()) > most;
    };
    if (std::ranges::none_of(scratch_.levels, holds_more)) return;
    recorder_.submit();
    for (LevelScratch& lists : scratch_.levels) lists = {};
  }

  void reserve_pairs(LevelScratch& lists, uint64_t pairs) {
    grow(recorder_, lists.pairs, pairs * sizeof(shared::HitPair), "pairs");
  }

  [[nodiscard]] std::vector<std::pair<uint32_t, uint32_t>> drop() const { return {{0, in_.drop_every}}; }

  gpu::Recorder& recorder_;
  gpu::Device& device_;
  const In& in_;
  Scratch& scratch_;
  const std::function<void(const Candidates&)>& intersect_;
  uint32_t top_ = 0;
};

}  // namespace

void traverse(gpu::Recorder& recorder, const In& in, uint32_t depth, Range nodes, Scratch& scratch,
              const std::function<void(const Candidates&)>& intersect) {
  if (nodes.count == 0 || in.scene.block_count == 0) return;
  recorder.stage(Stage::hierarchy_traversal);
  Descent(recorder, in, scratch, intersect).run(depth, nodes);
}

}  // namespace crsh::traversal
