#include "crsh/statistics.h"

namespace crsh {

uint64_t RayStatistics::paper_tests() const {
  uint64_t sum = triangle_tests;
  for (const LevelStatistics& level : levels) sum += level.tests;
  return sum;
}

}  // namespace crsh
