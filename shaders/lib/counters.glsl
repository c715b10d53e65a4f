#ifndef CRSH_LIB_COUNTERS_GLSL
#define CRSH_LIB_COUNTERS_GLSL
// Exact 64-bit counters without 64-bit atomics: low and high word with carry. The includer declares
// `buffer Counters { uvec2 counters[]; }`. Sums do not depend on the order of adding.

/// Adds what the subgroup's active lanes pass, in one go. A lane may pass at most 2^24.
#define ADD_COUNTER(slot, value)                                     \
  {                                                                  \
    uint sum_ = subgroupAdd(value);                                  \
    if (subgroupElect()) {                                           \
      uint before_ = atomicAdd(counters[slot].x, sum_);              \
      if (before_ + sum_ < before_) atomicAdd(counters[slot].y, 1u); \
    }                                                                \
  }

#endif
