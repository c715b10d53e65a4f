#include "objects/hierarchy.h"

#include <algorithm>

#include "objects/build.h"

namespace crsh::objects {
namespace {

/// Builds the tree, whose scratch memory is free again afterwards, then fits its boxes.
void build(gpu::Recorder& recorder, const In& in, Hierarchy& hierarchy) {
  recorder.submit();  // first, because recorded commands may still use the buffers freed here
  hierarchy = {.builds = hierarchy.builds, .refits = hierarchy.refits};
  build_tree(recorder, in, hierarchy);
  fit(recorder, in, hierarchy);
  hierarchy.built_cost = hierarchy.cost;
  ++hierarchy.builds;
}

void refit(gpu::Recorder& recorder, const In& in, Hierarchy& hierarchy) {
  fit(recorder, in, hierarchy);
  ++hierarchy.refits;
}

/// Fits the boxes of one rank, a piece of it at a time.
void fit_rank(gpu::Recorder& recorder, const In& in, Hierarchy& h, Rank rank) {
  constexpr uint32_t tests = 4;  // a node's boxes, or its leaves' triangles
  const uint32_t piece = uint32_t(std::clamp<uint64_t>(in.submit_work / tests, 1, UINT32_MAX / 2));
  for (uint32_t done = 0; done < rank.count; done += piece) {
    const struct {
      uint32_t first;
      uint32_t count;
    } push{rank.first + done, std::min(piece, rank.count - done)};
    recorder.dispatch("objects/fit", push.count, push,
                      {{"leaf_a", h.leaf_a},
                       {"leaf_b", h.leaf_b},
                       {"leaf_c", h.leaf_c},
                       {"box_low", h.box_low},
                       {"box_high", h.box_high},
                       {"costs", h.costs},
                       {"root", h.root}},
                      uint64_t(push.count) * tests);
    recorder.submit_past(in.submit_work);
  }
}

}  // namespace

void fit(gpu::Recorder& recorder, const In& in, Hierarchy& h) {
  recorder.stage(Stage::object_hierarchy);
  const uint32_t push = h.triangle_count;
  recorder.dispatch("objects/corners", h.triangle_count, push,
                    {{"corner_a", in.scene.corner_a},
                     {"corner_b", in.scene.corner_b},
                     {"corner_c", in.scene.corner_c},
                     {"order", h.order},
                     {"leaf_a", h.leaf_a},
                     {"leaf_b", h.leaf_b},
                     {"leaf_c", h.leaf_c}},
                    h.triangle_count);
  for (size_t r = h.ranks.size(); r-- > 0;) fit_rank(recorder, in, h, h.ranks[r]);
  const auto root = recorder.read<glm::vec4>(h.root, 2);
  h.cost = root[1].w > 0 ? double(root[0].w) / double(root[1].w) : 0;
  h.pose = in.pose;
}

void update(gpu::Recorder& recorder, const In& in, Hierarchy& hierarchy) {
  recorder.stage(Stage::object_hierarchy);
  if (hierarchy.node_count == 0) return build(recorder, in, hierarchy);
  if (hierarchy.pose == in.pose) return;
  refit(recorder, in, hierarchy);
  if (hierarchy.cost > loose * hierarchy.built_cost) build(recorder, in, hierarchy);
}

}  // namespace crsh::objects
