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

/// A scene requires extensions that crsh does not do. Whoever asked for it may add how it is drawn all the same.
class ExtensionError : public UserError {
 public:
  using UserError::UserError;
};

/// What of a file is wanted, and how strictly it is read.
struct LoadOptions {
  std::string scene;            ///< index or name of the glTF scene; empty: the file's default scene, else the first
  Reach reach = Reach::folder;  ///< of the files that it names
  std::string variant;          ///< of its materials, by index or name; empty: those that primitives usually wear
  bool lenient = false;         ///< draw it without the extensions that it requires and crsh does not do
};

/// Loads .gltf or .glb. Throws UserError (one line: file, reason, mend) for anything broken, an OutsideError for
/// buffers beyond reach, an ExtensionError; what is merely unsupported goes to `unsupported`, and so do pictures beyond
/// reach.
[[nodiscard]] Scene load(const std::filesystem::path& path, const LoadOptions& options = {});
/// The same for one of the file's scenes.
[[nodiscard]] Scene load(const std::filesystem::path& path, const std::string& which, Reach reach = Reach::folder);

}  // namespace crsh::scene
