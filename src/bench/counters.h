#pragma once
// Arithmetic on a run's counters.

#include <cstdint>
#include <string>

#include "crsh/statistics.h"

namespace crsh::bench {

/// What was counted since `before`, with the times of those frames.
[[nodiscard]] Statistics difference(const Statistics& after, const Statistics& before);

/// The counters of so many frames like this one, as `crsh render --stats` would have them.
[[nodiscard]] Statistics times(const Statistics& one, uint64_t frames);

/// The name of the first counter that differs; empty where none does. Means over nodes are not compared.
[[nodiscard]] std::string first_difference(const Statistics& a, const Statistics& b);

/// What brute force would count for these rays: the same hits, and a test of each ray against every triangle.
[[nodiscard]] Statistics as_brute_force(Statistics statistics);

/// Rays times triangles, summed over kinds and bounces.
[[nodiscard]] uint64_t brute_force_tests(const Statistics& statistics);

}  // namespace crsh::bench
