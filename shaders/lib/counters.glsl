#ifndef CRSH_LIB_COUNTERS_GLSL
#define CRSH_LIB_COUNTERS_GLSL
// Exact 64-bit counters without 64-bit atomics: a low and a high word, and a carry between them. Sums do not depend on
// the order of adding. The includer declares `buffer Counters { uvec2 counters[]; }`.

/// Whether lanes that part in a branch or a loop are together again behind it (src/gpu/promises.h, which sets it). Else
/// the lanes over which a sum is taken need not be those of which one is elected to add it.
layout(constant_id = 17) const bool lanes_reconverge = true;

/// Adds what the active lanes of the subgroup pass, with a single atomic where that is safe. A lane may pass at most
/// 2^24.
#define ADD_COUNTER(slot, value)                                     \
  {                                                                  \
    uint sum_ = value;                                               \
    bool adds_ = sum_ != 0u;                                         \
    if (lanes_reconverge) {                                          \
      sum_ = subgroupAdd(sum_);                                      \
      adds_ = subgroupElect();                                       \
    }                                                                \
    if (adds_) {                                                     \
      uint before_ = atomicAdd(counters[slot].x, sum_);              \
      if (before_ + sum_ < before_) atomicAdd(counters[slot].y, 1u); \
    }                                                                \
  }

#endif
