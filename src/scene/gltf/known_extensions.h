#pragma once
// Which glTF extensions crsh knows, and what becomes of a file that asks for others.

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <set>
#include <string>
#include <string_view>

#include "scene/gltf/fault.h"

namespace crsh::scene {

/// What an extension is to crsh.
enum class Support {
  done,              ///< crsh does what it says
  harmless,          ///< says nothing of what a picture shows
  adds,              ///< not done: the picture lacks something, and the rest of it is right
  changes_geometry,  ///< not done: without it, shapes or places are wrong or missing
};

/// None: crsh does not know it.
[[nodiscard]] std::optional<Support> support_of(std::string_view extension);

/// The extensions of a file, by name.
struct ExtensionNames {
  std::set<std::string> used;  ///< listed as used or required, or standing somewhere in the file without being listed
  std::set<std::string> required;  ///< listed as required
};

/// Collects them from the whole file but its `extras`. A Fault where a list holds something that is not a string.
[[nodiscard]] ExtensionNames extensions_in(const nlohmann::json& root);

/// A Fault that names all required extensions without which the picture is wrong, or may be: those that are unknown and
/// those that change geometry.
void check_required(const ExtensionNames& names);

/// Adds a note for each extension that is not done and that a picture would show.
void note_extensions(const ExtensionNames& names, Notes& notes);

}  // namespace crsh::scene
