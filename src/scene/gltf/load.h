#pragma once
// Reads a scene from a glTF file.

#include <filesystem>
#include <string>

#include "scene/scene.h"

namespace crsh::scene {

/// Loads .gltf or .glb. `which`: index or name of the glTF scene, empty: the file's default scene, else the first.
/// Throws UserError (one line: file, reason, mend) for anything broken; what is merely unsupported goes to
/// `unsupported`.
[[nodiscard]] Scene load(const std::filesystem::path& path, const std::string& which = {});

}  // namespace crsh::scene
