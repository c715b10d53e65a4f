#include "hierarchy/account.h"

#include <algorithm>

#include "crsh/assertion.h"
#include "primitives/grow.h"
#include "shared/limits.h"

namespace crsh::hierarchy {
namespace {

/// The specialisation constant of lib/account.glsl.
constexpr uint32_t accounted_id = 16;

/// Whether rays (level 0) or nodes make tests of this type.
bool makes(uint32_t level, uint32_t type) { return type != (level == 0 ? shared::tests_node : shared::tests_triangle); }

}  // namespace

void Account::begin(gpu::Recorder& recorder, WantedTests wanted, uint32_t rays, const Hierarchy& hierarchy) {
  wanted_ = wanted;
  first_.assign(hierarchy.depth + 1, {shared::none, shared::none, shared::none});
  uint32_t slots = 0;
  for (uint32_t level = 0; level <= hierarchy.depth; ++level)
    for (uint32_t type = 0; type < shared::tests_count; ++type) {
      if (!wanted_[type] || !makes(level, type)) continue;
      first_[level][type] = slots;
      slots += level == 0 ? rays : hierarchy.levels[level - 1].count;
    }
  if (slots == 0) return;
  primitives::grow(recorder, buffer_, uint64_t(slots) * sizeof(uint32_t), "tests by ray and node");
  recorder.fill(buffer_, 0, slots);
}

gpu::Kernel Account::kernel(std::string path, std::vector<std::pair<uint32_t, uint32_t>> constants) const {
  uint32_t accounted = 0;
  for (uint32_t type = 0; type < shared::tests_count; ++type) accounted |= wanted_[type] ? 1u << type : 0u;
  if (accounted) constants.emplace_back(accounted_id, accounted);
  return {std::move(path), std::move(constants)};
}

const gpu::Buffer& Account::buffer_or(const gpu::Buffer& stand_in) const {
  return std::ranges::find(wanted_, true) == wanted_.end() ? stand_in : buffer_;
}

uint32_t Account::first(uint32_t type, uint32_t level) const {
  if (!wanted_[type]) return 0;
  CRSH_ASSERT(level < first_.size() && first_[level][type] != shared::none, "no slots for these tests");
  return first_[level][type];
}

void Account::share(gpu::Recorder& recorder, const AccountIn& in, uint32_t type, const gpu::Buffer& tests) const {
  for (uint32_t level = 0; level < first_.size(); ++level) {
    if (first_[level][type] == shared::none) continue;
    level == 0 ? share_rays(recorder, in, type, tests) : share_nodes(recorder, in, type, level, tests);
  }
}

void Account::share_rays(gpu::Recorder& recorder, const AccountIn& in, uint32_t type, const gpu::Buffer& tests) const {
  const struct {
    uint32_t rays, surfaces, first_surface, first_account;
  } push{in.batch.count, in.batch.surfaces, in.first_surface, first(type, 0)};
  recorder.dispatch("hierarchy/share_rays", push.rays, push,
                    {{"slots", in.batch.slots}, {"pixels", in.pixels}, {"account", buffer_}, {"tests", tests}});
}

void Account::share_nodes(gpu::Recorder& recorder, const AccountIn& in, uint32_t type, uint32_t level,
                          const gpu::Buffer& tests) const {
  const Level& nodes = in.hierarchy.levels[level - 1];
  for (size_t s = 0; s < in.batch.segments.size(); ++s) {
    if (nodes.segments[s].count == 0) continue;
    const struct {
      uint32_t first_ray, rays, surfaces, first_surface, first_node, nodes, first_account;
    } push{in.batch.segments[s].first, in.batch.segments[s].count, in.batch.surfaces, in.first_surface,
           nodes.segments[s].first,    nodes.segments[s].count,    first(type, level)};
    recorder.dispatch("hierarchy/share_nodes", push.rays, push,
                      {{"slots", in.batch.slots},
                       {"pixels", in.pixels},
                       {"order", in.order},
                       {"rays_of", nodes.rays},
                       {"account", buffer_},
                       {"tests", tests}});
  }
}

}  // namespace crsh::hierarchy
