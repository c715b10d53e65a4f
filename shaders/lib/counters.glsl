#ifndef CRSH_LIB_COUNTERS_GLSL
#define CRSH_LIB_COUNTERS_GLSL
// Exact 64-bit counters without 64-bit atomics: a low and a high word, and a carry between them. Sums do not depend on
// the order of adding. The includer declares `buffer Counters { uvec2 counters[]; }`.

/// Adds what the active lanes of the subgroup pass, with a single atomic. A lane may pass at most 2^24.
#define ADD_COUNTER(slot, value)                                     \
  {                                                                  \
    uint sum_ = subgroupAdd(value);                                  \
    if (subgroupElect()) {                                           \
      uint before_ = atomicAdd(counters[slot].x, sum_);              \
      if (before_ + sum_ < before_) atomicAdd(counters[slot].y, 1u); \
    }                                                                \
  }

#endif
