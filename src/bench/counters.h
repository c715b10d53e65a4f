#pragma once
// Arithmetic on a run's counters.

#include <cstdint>
#include <string>

#include "crsh/statistics.h"

namespace crsh::bench {

/// What was counted after `before`, and the times of those frames.
[[nodiscard]] Statistics difference(const Statistics& after, const Statistics& before);

/// As if so many frames had been counted: what `crsh render --stats` says of them.
[[nodiscard]] Statistics times(const Statistics& one, uint64_t frames);

/// The first counter that differs, by its name; empty: none does. Means over nodes are no counters.
[[nodiscard]] std::string first_difference(const Statistics& a, const Statistics& b);

/// The same rays and hits, found by testing each ray against every triangle.
[[nodiscard]] Statistics as_brute_force(Statistics statistics);

/// Rays times triangles, of all kinds and bounces.
[[nodiscard]] uint64_t brute_force_tests(const Statistics& statistics);

}  // namespace crsh::bench
