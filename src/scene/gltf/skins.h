#pragma once
// Skins: the joints that place a mesh.

#include <map>
#include <optional>

#include "scene/gltf/document.h"
#include "scene/gltf/fault.h"
#include "scene/gltf/nodes.h"
#include "scene/scene.h"

namespace crsh::scene {

/// Reads skins when a node first uses them.
class SkinReader {
 public:
  SkinReader(Document& document, const NodeMap& nodes, Scene& scene, Notes& notes)
      : document_(document), nodes_(nodes), scene_(scene), notes_(notes) {}

  /// The skin's place in the scene for a mesh at this node; none where one of them is broken, with a note: the mesh is
  /// then drawn at rest, where its node is.
  std::optional<uint32_t> place(int64_t index, const Mesh& mesh, uint32_t node);

 private:
  std::optional<uint32_t> place_of(int64_t index);
  Skin read(int64_t index);
  uint32_t with_own_node(uint32_t skin, uint32_t node);

  Document& document_;
  const NodeMap& nodes_;
  Scene& scene_;
  Notes& notes_;
  std::map<int64_t, std::optional<uint32_t>> places_;
};

}  // namespace crsh::scene
