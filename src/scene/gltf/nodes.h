#pragma once
// The node hierarchy of the chosen glTF scene.

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "scene/gltf/document.h"
#include "scene/scene.h"

namespace crsh::scene {

/// Which glTF node each of Scene::nodes is, and the other way round.
struct NodeMap {
  std::vector<int64_t> file_of;                  ///< of a node of the scene
  std::vector<std::optional<uint32_t>> node_of;  ///< of a node of the file: none where the scene does not reach it
};

/// Chooses the glTF scene (index or name; empty: the default one, else the first; a file without scenes: all its root
/// nodes) and fills `name`, `scene_names` and `nodes`: what the scene reaches, parents before their children.
[[nodiscard]] NodeMap read_nodes(Document& document, const std::string& which, Scene& scene);

}  // namespace crsh::scene
