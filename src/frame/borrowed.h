#pragma once
// For callers inside this project that keep a device or a scene themselves.

#include <memory>

namespace crsh {

/// A pointer to what somebody else keeps, and keeps for longer than the renderer that gets it.
template <class Thing>
[[nodiscard]] std::shared_ptr<Thing> borrowed(Thing& thing) {
  return {std::shared_ptr<void>(), &thing};
}

}  // namespace crsh
