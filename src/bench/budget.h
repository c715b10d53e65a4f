#pragma once
// How many frames fit the time that a bench may take.

#include <cstdint>

namespace crsh::bench {

/// A round is a pass of each variant.
struct Rounds {
  uint32_t warmup = 0, repeat = 0;
  bool operator==(const Rounds&) const = default;
  [[nodiscard]] uint64_t sum() const { return uint64_t(warmup) + repeat; }
};

/// Of the rounds that are asked for, those that fit `seconds` at `seconds_a_round` each: an eighth of them for warming
/// up, and at least one that counts.
[[nodiscard]] Rounds rounds_that_fit(const Rounds& asked, double seconds, double seconds_a_round);

}  // namespace crsh::bench
