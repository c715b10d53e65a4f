#include "bench/budget.h"

#include <algorithm>

namespace crsh::bench {

Rounds rounds_that_fit(const Rounds& asked, double seconds, double seconds_a_round) {
  const double most = std::clamp(seconds / std::max(seconds_a_round, 1e-9), 1.0, double(asked.sum()));
  const auto rounds = static_cast<uint32_t>(most);
  if (rounds >= asked.sum()) return asked;
  const uint32_t warmup = std::min(asked.warmup, rounds / 8);
  return {warmup, std::min(asked.repeat, rounds - warmup)};
}

}  // namespace crsh::bench
