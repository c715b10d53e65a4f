#include "objects/build.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "crsh/error.h"
#include "primitives/grow.h"
#include "primitives/scan.h"
#include "primitives/sort.h"
#include "shared/object.h"

namespace crsh::objects {
namespace {

using primitives::quad_bytes;

/// How many neighbours on either side a cluster may pair up with.
constexpr uint32_t search_radius = 16;
/// After so many rounds every cluster merges with the next one, whatever their boxes. There are scenes where each round
/// would merge a single pair, and a tree must not become deeper than the stack of a ray that walks it
/// (max_object_depth). (A usual scene of a million triangles takes about 30 rounds.)
constexpr uint32_t free_rounds = 64;

struct Clusters {
  gpu::Buffer low, high;  ///< vec4 a cluster (shaders/objects/clusters.glsl)
};

/// Lives as long as a build.
class Builder {
 public:
  Builder(gpu::Recorder& recorder, const In& in, Hierarchy& out)
      : recorder_(recorder), device_(recorder.device()), in_(in), out_(out), n_(in.scene.triangle_count) {}

  void run() {
    out_.triangle_count = n_;
    reserve_leaves();
    if (n_ < 2) return make_only_node();
    sort_triangles();
    begin_clusters();
    merge_clusters();
    recorder_.submit();  // first, because recorded commands may still use the buffers freed here
    sorted_ = {}, clusters_ = {}, next_ = {}, nearest_ = {}, raw_costs_ = {};
    place_triangles();
    number_nodes();
    emit_nodes();
    recorder_.submit();
  }

 private:
  void reserve_leaves() {
    const uint64_t corners = std::max(n_, 1u) * uint64_t(sizeof(glm::vec4));
    out_.leaf_a.reserve(device_, corners, "leaf corners a");
    out_.leaf_b.reserve(device_, corners, "leaf corners b");
    out_.leaf_c.reserve(device_, corners, "leaf corners c");
    out_.order.reserve(device_, quad_bytes(std::max(n_, 1u)), "leaf order");
    out_.root.reserve(device_, 2 * sizeof(glm::vec4), "root of the object hierarchy");
  }

  void reserve_nodes(uint32_t nodes) {
    const uint64_t bytes = 2 * uint64_t(nodes) * sizeof(glm::vec4);
    if (bytes > device_.limits().max_binding)
      throw UserError(
          fmt::format("the object hierarchy over {} triangles has {} nodes, and {} holds at most {} in one "
                      "buffer",
                      n_, nodes, device_.info().name, device_.limits().max_binding / (2 * sizeof(glm::vec4))),
          Mend::other_algorithm_or_device);
    out_.box_low.reserve(device_, bytes, "low corners of boxes");
    out_.box_high.reserve(device_, bytes, "high corners of boxes");
    out_.costs.reserve(device_, nodes * sizeof(float), "costs of nodes");
    out_.node_count = nodes;
  }

  /// Over one triangle or none: a root with at most one leaf; the other slots are empty.
  void make_only_node() {
    reserve_nodes(1);
    for (uint32_t slot = 0; slot < 2; ++slot) {
      recorder_.fill(out_.box_low, shared::child_is_leaf, 1, 4 * slot + 3);
      recorder_.fill(out_.box_high, slot < n_ ? 1 : 0, 1, 4 * slot + 3);
    }
    recorder_.fill(out_.order, 0, 1);
    out_.ranks = {{0, 1}};
  }

  /// Sorts triangles by Morton codes of two words: first by the low word, then by the high one, as the sort is stable.
  void sort_triangles() {
    gpu::Buffer pairs(device_, primitives::pair_bytes(n_), "Morton codes");
    primitives::SortScratch scratch;
    write_codes(pairs, false);
    primitives::sort_pairs(recorder_, scratch, pairs, n_, 30);
    write_codes(pairs, true);
    primitives::sort_values(recorder_, scratch, pairs, n_, 30, sorted_);
    recorder_.submit();
  }

  void write_codes(const gpu::Buffer& pairs, bool high_word) {
    const scene::Bounds& bounds = in_.scene.bounds;
    const glm::vec3 size = bounds.high - bounds.low;
    const float edge = std::max({size.x, size.y, size.z, 1e-30f});
    const struct {
      glm::vec3 low;
      float inverse;
      uint32_t count;
    } push{bounds.low, 1 / edge, n_};
    recorder_.dispatch({"objects/codes", {{0, high_word}}}, n_, push,
                       {{"corner_a", in_.scene.corner_a},
                        {"corner_b", in_.scene.corner_b},
                        {"corner_c", in_.scene.corner_c},
                        {"pairs", pairs}},
                       n_);
  }

  void begin_clusters() {
    const uint64_t bytes = n_ * uint64_t(sizeof(glm::vec4));
    for (Clusters* clusters : {&clusters_, &next_}) {
      clusters->low.reserve(device_, bytes, "low corners of clusters");
      clusters->high.reserve(device_, bytes, "high corners of clusters");
    }
    nearest_.reserve(device_, n_ * sizeof(uint32_t), "nearest clusters");
    places_.reserve(device_, quad_bytes(n_ + 1), "places");
    raw_nodes_.reserve(device_, n_ * sizeof(glm::uvec4), "raw nodes");
    raw_costs_.reserve(device_, n_ * sizeof(float), "costs of raw nodes");
    recorder_.dispatch("objects/begin", n_, n_,
                       {{"corner_a", in_.scene.corner_a},
                        {"corner_b", in_.scene.corner_b},
                        {"corner_c", in_.scene.corner_c},
                        {"order", sorted_},
                        {"cluster_low", clusters_.low},
                        {"cluster_high", clusters_.high}},
                       n_);
  }

  /// Merges pairs of clusters, round by round, until one is left. Each round's nodes are a rank of the raw tree.
  void merge_clusters() {
    uint32_t first_node = n_ - 1;
    for (uint32_t count = n_, round = 0; count > 1; ++round) {
      find_nearest(count, round < free_rounds ? search_radius : 0);
      const uint32_t left = find_places(count);
      first_node -= count - left;
      merge_pairs(count, first_node);
      raw_ranks_.push_back({first_node, count - left});
      std::swap(clusters_, next_);
      count = left;
    }
    std::ranges::reverse(raw_ranks_);
  }

  void find_nearest(uint32_t count, uint32_t radius) {
    const uint32_t tests = 2 * radius + 1;
    const uint32_t piece = uint32_t(std::clamp<uint64_t>(in_.submit_work / tests, 1, count));
    for (uint32_t first = 0; first < count; first += piece) {
      const struct {
        uint32_t first, end, count, radius;
      } push{first, first + std::min(piece, count - first), count, radius};
      recorder_.dispatch("objects/nearest", push.end - first, push,
                         {{"cluster_low", clusters_.low}, {"cluster_high", clusters_.high}, {"nearest", nearest_}},
                         uint64_t(push.end - first) * tests);
      recorder_.submit_past(in_.submit_work);
    }
  }

  /// Finds each cluster's place in the next round. Returns how many clusters that has.
  uint32_t find_places(uint32_t count) {
    recorder_.dispatch("objects/pair", count, count, {{"nearest", nearest_}, {"stays", places_}}, count);
    primitives::scan(recorder_, scan_, places_, places_, count + 1, primitives::ScanType::exclusive);
    return recorder_.read<uint32_t>(places_, 1, count)[0];
  }

  void merge_pairs(uint32_t count, uint32_t first_node) {
    const struct {
      uint32_t count;
      uint32_t first_node;
    } push{count, first_node};
    recorder_.dispatch("objects/merge", count, push,
                       {{"nearest", nearest_},
                        {"places", places_},
                        {"cluster_low", clusters_.low},
                        {"cluster_high", clusters_.high},
                        {"next_low", next_.low},
                        {"next_high", next_.high},
                        {"raw_nodes", raw_nodes_},
                        {"costs", raw_costs_}},
                       count);
  }

  /// Gives each raw node the place of its first triangle in leaf order, from the root down.
  void place_triangles() {
    firsts_.reserve(device_, n_ * sizeof(uint32_t), "first triangles of raw nodes");
    recorder_.fill(firsts_, 0, 1);
    recorder_.fill(places_, 1, 1);
    for (const Rank& rank : raw_ranks_)
      recorder_.dispatch("objects/place", rank.count, rank,
                         {{"raw_nodes", raw_nodes_}, {"firsts", firsts_}, {"kept", places_}, {"order", out_.order}},
                         rank.count);
  }

  /// Numbers the nodes that are kept, those that do not become leaves. They stay in the raw tree's order, the root
  /// first, so that its ranks become the hierarchy's.
  void number_nodes() {
    const uint32_t raw_nodes = n_ - 1;
    primitives::scan(recorder_, scan_, places_, places_, raw_nodes + 1, primitives::ScanType::exclusive);
    const gpu::Buffer firsts(device_, (raw_ranks_.size() + 1) * sizeof(uint32_t), "first nodes of ranks");
    for (size_t r = 0; r <= raw_ranks_.size(); ++r) {
      const uint32_t raw = r < raw_ranks_.size() ? raw_ranks_[r].first : raw_nodes;
      recorder_.copy(places_, raw * sizeof(uint32_t), firsts, r * sizeof(uint32_t), sizeof(uint32_t));
    }
    const auto first = recorder_.read<uint32_t>(firsts, raw_ranks_.size() + 1);
    for (size_t r = 0; r < raw_ranks_.size(); ++r)
      if (first[r + 1] > first[r]) out_.ranks.push_back({first[r], first[r + 1] - first[r]});
    reserve_nodes(first.back());
  }

  void emit_nodes() {
    const uint32_t count = n_ - 1;
    recorder_.dispatch("objects/emit", count, count,
                       {{"raw_nodes", raw_nodes_},
                        {"firsts", firsts_},
                        {"places", places_},
                        {"box_low", out_.box_low},
                        {"box_high", out_.box_high}},
                       count);
  }

  gpu::Recorder& recorder_;
  gpu::Device& device_;
  const In& in_;
  Hierarchy& out_;
  const uint32_t n_;
  gpu::Buffer sorted_;  ///< triangles in Morton order
  Clusters clusters_, next_;
  gpu::Buffer nearest_, places_;  ///< uint a cluster, then (places) a raw node
  gpu::Buffer raw_nodes_, raw_costs_, firsts_;
  std::vector<Rank> raw_ranks_;
  primitives::ScanScratch scan_;
};

}  // namespace

void build_tree(gpu::Recorder& recorder, const In& in, Hierarchy& hierarchy) { Builder(recorder, in, hierarchy).run(); }

}  // namespace crsh::objects
