#pragma once
// Section 3.2.3 again in plain C++: chunks, their sort, and the order that comes out.

#include <algorithm>
#include <cstdint>
#include <glm/glm.hpp>
#include <numeric>
#include <vector>

namespace crsh::test {

struct ChunksTwin {
  std::vector<uint32_t> keys, bases, sizes;
};

inline ChunksTwin compress_twin(const std::vector<uint32_t>& keys) {
  ChunksTwin chunks;
  for (uint32_t i = 0; i < keys.size(); ++i) {
    if (i == 0 || keys[i] != keys[i - 1])
      chunks.keys.push_back(keys[i]), chunks.bases.push_back(i), chunks.sizes.push_back(0);
    ++chunks.sizes.back();
  }
  return chunks;
}

/// Places sorted by key, equal keys in the order they came.
inline std::vector<uint32_t> order_twin(const std::vector<uint32_t>& keys) {
  std::vector<uint32_t> order(keys.size());
  std::iota(order.begin(), order.end(), 0u);
  std::stable_sort(order.begin(), order.end(), [&](uint32_t a, uint32_t b) { return keys[a] < keys[b]; });
  return order;
}

}  // namespace crsh::test
