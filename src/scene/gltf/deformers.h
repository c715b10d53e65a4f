#pragma once
// What deforms a mesh: the influences of joints and the morph targets of its primitives.

#include <tiny_gltf.h>
#include <array>
#include <compare>
#include <optional>
#include <vector>

#include "scene/gltf/document.h"
#include "scene/gltf/fault.h"
#include "scene/scene.h"

namespace crsh::scene {

/// The accessors that deform a primitive. Primitives share vertices only where these are the same, too.
struct DeformLayout {
  std::vector<std::array<int, 2>> influences;              ///< JOINTS_n and WEIGHTS_n
  std::vector<std::array<std::optional<int>, 3>> targets;  ///< POSITION, NORMAL and TANGENT
  auto operator<=>(const DeformLayout&) const = default;
};

[[nodiscard]] DeformLayout deform_layout(const tinygltf::Primitive& primitive);

/// Gathers the influences and displacements of a mesh's vertices, primitive by primitive. What is broken is left out
/// with a note, and what it would move stays at rest.
class DeformReader {
 public:
  DeformReader(Document& document, Notes& notes) : document_(document), notes_(notes) {}

  /// `kept`: for each vertex of the file its place in the mesh, or unused_vertex.
  void add(const DeformLayout& layout, const std::vector<uint32_t>& kept, const std::string& where);
  /// Gives the mesh all of it. `weights`: the file's, of the mesh.
  void finish(const std::vector<double>& weights, Mesh& mesh);

  static constexpr uint32_t unused_vertex = 0xFFFFFFFFu;

 private:
  template <class T>
  using ByVertex = std::vector<std::pair<uint32_t, T>>;

  void add_influences(const std::array<int, 2>& set, const std::vector<uint32_t>& kept);
  void add_target(uint32_t target, const std::array<std::optional<int>, 3>& accessors,
                  const std::vector<uint32_t>& kept);

  Document& document_;
  Notes& notes_;
  ByVertex<Influence> influences_;
  ByVertex<Displacement> displacements_;
  uint32_t target_count_ = 0;
};

}  // namespace crsh::scene
