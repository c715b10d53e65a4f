#include "scene/gltf/skins.h"

#include <algorithm>
#include <cmath>

#include "scene/gltf/accessor.h"
#include "scene/gltf/checked.h"

namespace crsh::scene {

namespace {

constexpr uint64_t joint_cost = 16;  // in units of Document::spend
constexpr float farthest = 1e15f;    // metres; squares and products stay within float
const char* const at_rest = " (its meshes are drawn at rest)";

bool is_usable(const glm::mat4& m) {
  for (int c = 0; c < 4; ++c)
    for (int r = 0; r < 4; ++r)
      if (!(std::abs(m[c][r]) <= farthest)) return false;
  return true;
}

bool has_unskinned(const Mesh& mesh) { return !mesh.joint_boxes.empty() && mesh.joint_boxes.back().joint == unskinned; }

}  // namespace

std::optional<uint32_t> SkinReader::place(int64_t index, const Mesh& mesh, uint32_t node) {
  if (mesh.influences.empty()) return {};
  const std::optional<uint32_t> skin = place_of(index);
  if (!skin) return {};
  if (mesh.joint_count > scene_.skins[*skin].joints.size()) {
    notes_.add(scene::place("skins", index) + ", which has fewer joints than a mesh of it names" + at_rest);
    return {};
  }
  return has_unskinned(mesh) ? with_own_node(*skin, node) : *skin;
}

std::optional<uint32_t> SkinReader::place_of(int64_t index) {
  const auto [found, fresh] = places_.try_emplace(index);
  if (!fresh) return found->second;
  try {
    scene_.skins.push_back(read(index));
    found->second = static_cast<uint32_t>(scene_.skins.size() - 1);
  } catch (const LimitFault&) {
    throw;
  } catch (const Fault& fault) {
    notes_.add(scene::place("skins", index) + ": " + fault.what() + at_rest);
  }
  return found->second;
}

Skin SkinReader::read(int64_t index) {
  const tinygltf::Skin& from = at(document_.model().skins, index, "skins");
  document_.spend(from.joints.size() * joint_cost);
  Skin out;
  for (const int joint : from.joints) {
    if (static_cast<size_t>(joint) >= nodes_.node_of.size()) throw Fault("a joint is not in the file");
    const std::optional<uint32_t> node = nodes_.node_of[static_cast<size_t>(joint)];
    if (!node) throw Fault("a joint is not in the scene");
    out.joints.push_back(*node);
  }
  out.inverse_bind.assign(out.joints.size(), glm::mat4(1));
  if (from.inverseBindMatrices < 0) return out;
  const Accessor matrices(document_, from.inverseBindMatrices);
  matrices.need_components({16});
  if (matrices.component() != Component::f32) throw Fault(matrices.where() + " does not hold floats");
  if (matrices.count() < out.joints.size()) throw Fault(matrices.where() + " has fewer matrices than joints");
  for (size_t j = 0; j < out.joints.size(); ++j) {
    out.inverse_bind[j] = matrices.matrix_at(j);
    if (!is_usable(out.inverse_bind[j])) throw Fault(matrices.where() + " has a matrix that is not finite");
  }
  return out;
}

/// A skin of the instance's own, because its last joint is the instance's node.
uint32_t SkinReader::with_own_node(uint32_t skin, uint32_t node) {
  Skin own = scene_.skins[skin];
  document_.spend(own.joints.size() * joint_cost);
  own.joints.push_back(node);
  own.inverse_bind.emplace_back(1);
  own.has_own_node = true;
  scene_.skins.push_back(std::move(own));
  return static_cast<uint32_t>(scene_.skins.size() - 1);
}

}  // namespace crsh::scene
