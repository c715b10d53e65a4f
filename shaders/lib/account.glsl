// The account: tests by ray and by node, for the layers Tests.* (C++: hierarchy/account.h). The includer defines
// ACCOUNT_BINDING. Where a layer is not asked for, ACCOUNT of its tests compiles to nothing.

#include "shared/account.h"

layout(constant_id = 16) const uint accounted = 0u;  // a bit for each of tests_triangle, tests_node, tests_object
layout(binding = ACCOUNT_BINDING, scalar) buffer Account { uint account[]; };

/// Adds `tests` of this type to a slot: that of the level's first ray or node, which the host pushes, plus its own.
#define ACCOUNT(type, slot, tests)                                           \
  {                                                                          \
    if ((accounted & (1u << (type))) != 0u) atomicAdd(account[slot], tests); \
  }
