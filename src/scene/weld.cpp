#include "scene/weld.h"

#include <algorithm>
#include <array>
#include <bit>
#include <utility>

namespace crsh::scene {
namespace {

using Key = std::array<uint32_t, 8>;

uint32_t bits(float value) { return std::bit_cast<uint32_t>(value + 0.0f); }  // -0 becomes 0, which it equals

Key key_of(const TangentMesh& mesh, uint32_t vertex) {
  const glm::vec3 &p = mesh.positions[vertex], &n = mesh.normals[vertex];
  const glm::vec2& uv = mesh.uv[vertex];
  return {bits(p.x), bits(p.y), bits(p.z), bits(n.x), bits(n.y), bits(n.z), bits(uv.x), bits(uv.y)};
}

uint64_t hash_of(const Key& key) {
  uint64_t hash = 0;
  for (const uint32_t word : key) {
    hash = (hash ^ word) * 0x9E3779B97F4A7C15u;
    hash ^= hash >> 32;
  }
  return hash;
}

/// Vertices by their hash.
using Hashed = std::pair<uint64_t, uint32_t>;

/// Welds vertices whose hashes are the same, which nearly always are the same in all.
void weld_run(const TangentMesh& mesh, Hashed* begin, Hashed* end, std::vector<uint32_t>& first) {
  std::sort(begin, end, [&](const Hashed& a, const Hashed& b) {
    return std::pair(key_of(mesh, a.second), a.second) < std::pair(key_of(mesh, b.second), b.second);
  });
  for (Hashed* at = begin + 1; at < end; ++at) {
    const uint32_t before = at[-1].second, vertex = at->second;
    if (key_of(mesh, before) == key_of(mesh, vertex)) first[vertex] = first[before];
  }
}

}  // namespace

// By sorting: a table of hashes would let a file made for it take quadratic time.
std::vector<uint32_t> welded(const TangentMesh& mesh) {
  const auto count = static_cast<uint32_t>(mesh.positions.size());
  std::vector<uint32_t> first(count);
  std::vector<Hashed> sorted(count);
  for (uint32_t v = 0; v < count; ++v) {
    first[v] = v;
    sorted[v] = {hash_of(key_of(mesh, v)), v};
  }
  std::sort(sorted.begin(), sorted.end());
  for (size_t begin = 0, end = 0; begin < count; begin = end) {
    while (end < count && sorted[end].first == sorted[begin].first) ++end;
    if (end - begin > 1) weld_run(mesh, sorted.data() + begin, sorted.data() + end, first);
  }
  return first;
}

}  // namespace crsh::scene
