#pragma once
// Who is whose parent, in plain C++ (src/hierarchy).

#include <algorithm>
#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

#include "crsh/options.h"
#include "rays/batch.h"
#include "shared/limits.h"

namespace crsh::test {

struct TwinLevel {
  std::vector<glm::uvec2> children, rays;  ///< ranges a node
  std::vector<uint32_t> parents;           ///< a child; a child without one has `none`
  std::vector<uint32_t> nodes;             ///< a segment
};

/// Groups of `arity` neighbours, level by level, as far as a segment's kind wants levels.
inline std::vector<TwinLevel> twin_levels(const std::vector<rays::Segment>& segments, const AlgorithmOptions& options) {
  std::vector<TwinLevel> levels;
  std::vector<uint32_t> counts;
  uint32_t depth = 0;
  for (const rays::Segment& segment : segments) {
    counts.push_back(segment.count);
    if (segment.count) depth = std::max(depth, options.levels[segment.kind]);
  }
  for (uint32_t number = 1; number <= depth; ++number) {
    TwinLevel level;
    uint32_t first = 0;
    for (size_t s = 0; s < segments.size(); ++s) {
      const uint32_t count = counts[s];
      counts[s] = 0;
      for (uint32_t i = 0; i < count; ++i) {
        const bool wanted = options.levels[segments[s].kind] >= number;
        level.parents.push_back(wanted ? uint32_t(level.children.size()) + (i % options.arity ? -1 : 0) : shared::none);
        if (!wanted || i % options.arity) continue;
        const uint32_t child = first + i, end = first + std::min(i + options.arity, count);
        level.children.emplace_back(child, end);
        level.rays.emplace_back(number == 1 ? glm::uvec2(child, end)
                                            : glm::uvec2(levels.back().rays[child].x, levels.back().rays[end - 1].y));
        ++counts[s];
      }
      first += count;
    }
    level.nodes = counts;
    levels.push_back(std::move(level));
  }
  return levels;
}

}  // namespace crsh::test
