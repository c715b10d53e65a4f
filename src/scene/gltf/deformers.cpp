#include "scene/gltf/deformers.h"

#include <algorithm>
#include <cmath>

#include "scene/deform.h"
#include "scene/gltf/accessor.h"
#include "scene/gltf/checked.h"

namespace crsh::scene {

namespace {

// In units of Document::spend, as a triangle's 16.
constexpr uint64_t influence_cost = 3, displacement_cost = 8;
// A kernel goes through all that moves a vertex in one loop, and lavapipe 22.3 ends loops after 65,535 turns.
constexpr size_t max_targets = 16384, max_sets = 1024;
constexpr float farthest = 1e15f;  // metres; squares and products stay within float

std::optional<int> accessor_of(const std::map<std::string, int>& attributes, const std::string& name) {
  const auto found = attributes.find(name);
  return found == attributes.end() ? std::nullopt : std::optional(found->second);
}

/// Whether all components are numbers that can be drawn.
bool is_usable(const glm::vec3& v) {
  const glm::vec3 size = glm::abs(v);
  return size.x <= farthest && size.y <= farthest && size.z <= farthest;
}

/// A target's accessor of one attribute, as long as the vertices.
class Deltas {
 public:
  Deltas(Document& document, const std::optional<int>& index, uint64_t count) {
    if (!index) return;
    source_.emplace(document, *index);
    source_->need_components({3});
    if (source_->count() != count) throw Fault(source_->where() + " has not as many elements as the positions");
    document.spend(count);
  }
  [[nodiscard]] glm::vec3 at(uint64_t i) const {
    if (!source_) return glm::vec3(0);
    const glm::vec3 delta(source_->at(i));
    return is_usable(delta) ? delta : glm::vec3(0);
  }

 private:
  std::optional<Accessor> source_;
};

bool is_zero(const Displacement& d) {
  return d.position == glm::vec3(0) && d.normal == glm::vec3(0) && d.tangent == glm::vec3(0);
}

/// Sorted by vertex, in the order in which they came.
template <class T>
Rows<T> rows_of(std::vector<std::pair<uint32_t, T>>& list, size_t vertices) {
  Rows<T> out;
  if (list.empty()) return out;
  std::ranges::stable_sort(list, {}, [](const auto& entry) { return entry.first; });
  out.first.assign(vertices + 1, 0);
  for (const auto& [vertex, item] : list) ++out.first[vertex + 1];
  for (size_t v = 0; v < vertices; ++v) out.first[v + 1] += out.first[v];
  out.items.reserve(list.size());
  for (const auto& [vertex, item] : list) out.items.push_back(item);
  list = {};
  return out;
}

/// What is no whole number from 0 on is no joint of any skin.
uint32_t joint_of(float number) {
  return number >= 0 && number < 65536 ? static_cast<uint32_t>(number) : unskinned - 1;
}

/// Whether a weight does anything: those below 0 or not finite are taken for 0.
bool has_weight(const Influence& influence) { return influence.weight > 0 && std::isfinite(influence.weight); }

/// One vertex's influences, so that they sum to 1. Where none has weight the first joint has all of it, as in other
/// viewers; where there is none at all the mesh's own node has.
void settle(std::span<const Influence> all, std::vector<Influence>& out) {
  double sum = 0;
  for (const Influence& influence : all) sum += has_weight(influence) ? double(influence.weight) : 0;
  for (const Influence& influence : all)
    if (has_weight(influence)) out.push_back({influence.joint, static_cast<float>(influence.weight / sum)});
  if (sum == 0) out.push_back({all.empty() ? unskinned : all.front().joint, 1});
}

Rows<Influence> settled(const Rows<Influence>& from, size_t vertices) {
  Rows<Influence> out;
  if (from.empty()) return out;
  out.items.reserve(from.items.size());
  for (size_t v = 0; v < vertices; ++v) {
    out.first.push_back(static_cast<uint32_t>(out.items.size()));
    settle(from.of(v), out.items);
  }
  out.first.push_back(static_cast<uint32_t>(out.items.size()));
  return out;
}

}  // namespace

DeformLayout deform_layout(const tinygltf::Primitive& primitive) {
  DeformLayout out;
  for (size_t set = 0; set < max_sets; ++set) {
    const auto joints = accessor_of(primitive.attributes, "JOINTS_" + std::to_string(set)),
               weights = accessor_of(primitive.attributes, "WEIGHTS_" + std::to_string(set));
    if (!joints || !weights) break;
    out.influences.push_back({*joints, *weights});
  }
  for (const auto& target : primitive.targets) {
    if (out.targets.size() == max_targets) break;
    out.targets.push_back(
        {accessor_of(target, "POSITION"), accessor_of(target, "NORMAL"), accessor_of(target, "TANGENT")});
  }
  return out;
}

void DeformReader::add(const DeformLayout& layout, const std::vector<uint32_t>& kept, const std::string& where) {
  const auto reading = [&](const char* what, const auto& read) {
    try {
      read();
    } catch (const LimitFault&) {
      throw;
    } catch (const Fault& fault) {
      notes_.add(std::string(what) + " of " + where + " (" + fault.what() + ")");
    }
  };
  for (const auto& set : layout.influences) reading("joints", [&] { add_influences(set, kept); });
  for (uint32_t t = 0; t < layout.targets.size(); ++t)
    reading("a morph target", [&] { add_target(t, layout.targets[t], kept); });
  target_count_ = std::max(target_count_, static_cast<uint32_t>(layout.targets.size()));
}

void DeformReader::add_influences(const std::array<int, 2>& set, const std::vector<uint32_t>& kept) {
  const Accessor joints(document_, set[0]), weights(document_, set[1]);
  for (const Accessor* accessor : {&joints, &weights}) {
    accessor->need_components({4});
    if (accessor->count() != kept.size()) throw Fault(accessor->where() + " has not as many elements as the positions");
  }
  document_.spend(kept.size() * 4 * influence_cost);
  for (size_t i = 0; i < kept.size(); ++i) {
    if (kept[i] == unused_vertex) continue;
    const glm::vec4 joint = joints.at(i), weight = weights.at(i);
    for (int c = 0; c < 4; ++c)
      if (c == 0 || weight[c] != 0) influences_.push_back({kept[i], {joint_of(joint[c]), weight[c]}});
  }
}

void DeformReader::add_target(uint32_t target, const std::array<std::optional<int>, 3>& accessors,
                              const std::vector<uint32_t>& kept) {
  const Deltas positions(document_, accessors[0], kept.size()), normals(document_, accessors[1], kept.size()),
      tangents(document_, accessors[2], kept.size());
  for (size_t i = 0; i < kept.size(); ++i) {
    if (kept[i] == unused_vertex) continue;
    const Displacement one{target, positions.at(i), normals.at(i), tangents.at(i)};
    if (is_zero(one)) continue;
    document_.spend(displacement_cost);
    displacements_.push_back({kept[i], one});
  }
}

void DeformReader::finish(const std::vector<double>& weights, Mesh& mesh) {
  const size_t vertices = mesh.positions.size();
  mesh.influences = settled(rows_of(influences_, vertices), vertices);
  mesh.displacements = rows_of(displacements_, vertices);
  mesh.target_count = target_count_;
  mesh.weights.assign(target_count_, 0.0f);
  for (size_t t = 0; t < std::min(weights.size(), mesh.weights.size()); ++t)
    mesh.weights[t] = finite(weights[t], "a weight of mesh " + in_quotes(mesh.name, 40));
  fill_deform_bounds(mesh);
}

}  // namespace crsh::scene
