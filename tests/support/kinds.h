#pragma once
// Values by ray kind for tests, however many kinds there are.

#include <vector>

#include "crsh/kinds.h"

namespace crsh::test {

/// Kinds take one of the values each, in turn.
template <class T>
PerKind<T> in_turn(const std::vector<T>& values) {
  return PerKind<T>([&](uint32_t kind) { return values[kind % values.size()]; });
}

/// True for these kinds only.
inline PerKind<bool> only(const std::vector<uint32_t>& kinds) {
  PerKind<bool> chosen(false);
  for (const uint32_t kind : kinds) chosen[kind] = true;
  return chosen;
}

}  // namespace crsh::test
