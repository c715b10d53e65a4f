#pragma once
// Loops whose rounds do not touch each other, on several cores.

#include <cstddef>
#include <functional>

namespace crsh::scene {

/// How many threads the machine runs at once, at least 1.
[[nodiscard]] unsigned threads_here();

/// Calls `work` with each of 0 to count - 1, each once, on so many threads, this one among them. Returns when all are
/// done; throws what the lowest of them threw, so that it does not depend on timing.
void in_parallel(size_t count, unsigned threads, const std::function<void(size_t)>& work);

}  // namespace crsh::scene
