#pragma once
// Loads a scene for a command line.

#include <string>

#include "scene/gltf/load.h"

namespace crsh::cli {

/// As scene::load does; where an option lets the scene be read, the error's line names it.
[[nodiscard]] scene::Scene load_scene(const std::string& path, const scene::LoadOptions& options);

/// How far the files may lie that a scene names: --allow-outside.
[[nodiscard]] inline scene::Reach reach_of(bool allow_outside) {
  return allow_outside ? scene::Reach::anywhere : scene::Reach::folder;
}

}  // namespace crsh::cli
