#pragma once
// Reads a scene from a glTF file.

#include <filesystem>
#include <string>

#include "crsh/error.h"
#include "scene/gltf/uri.h"
#include "scene/scene.h"

namespace crsh::scene {

/// A scene names a file outside its own folder. Whoever asked for the scene may add how that is allowed.
class OutsideError : public UserError {
 public:
  using UserError::UserError;
};

/// Loads .gltf or .glb. `which`: index or name of the glTF scene, empty: the file's default scene, else the first.
/// Throws UserError (one line: file, reason, mend) for anything broken, an OutsideError for buffers beyond `reach`;
/// what is merely unsupported goes to `unsupported`, and so do pictures beyond `reach`.
[[nodiscard]] Scene load(const std::filesystem::path& path, const std::string& which = {}, Reach reach = Reach::folder);

}  // namespace crsh::scene
