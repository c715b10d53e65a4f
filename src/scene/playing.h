#pragma once
// Which of a scene's animations play (--animation).

#include <string>
#include <vector>

#include "scene/scene.h"

namespace crsh::scene {

struct Playing {
  std::vector<uint32_t> animations;
  std::string note;  ///< a line about what was chosen here; empty where there was no choice
};

/// The animation with this name or index, or `all` of them, of which the later change what the earlier have changed.
/// For an empty text those that drive different things: each that has nothing in common with one before it that plays.
/// Throws UserError that lists them.
[[nodiscard]] Playing playing(const Scene& scene, const std::string& which);

/// Of the longest of them; seconds.
[[nodiscard]] float duration(const Scene& scene, const std::vector<uint32_t>& animations);

}  // namespace crsh::scene
