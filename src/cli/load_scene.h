#pragma once
// Loads a scene for a command line.

#include <string>

#include "scene/scene.h"

namespace crsh::cli {

/// As scene::load does; `allow_outside`: the files that it names may lie outside its own folder (--allow-outside).
[[nodiscard]] scene::Scene load_scene(const std::string& path, const std::string& which, bool allow_outside);

}  // namespace crsh::cli
