#pragma once
// Makes of a file's JSON what tinygltf may read: every type checked, and nothing in it that tinygltf would open, decode
// or refuse without naming the place.

#include <cstdint>
#include <map>
#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>
#include <vector>

#include "scene/gltf/meshopt.h"

namespace crsh::scene {

struct BufferSource {
  std::optional<uint64_t> length;
  std::string uri;  ///< empty: a GLB's BIN chunk
};

struct ImageSource {
  std::optional<uint64_t> view;
  std::string uri;
};

/// Why parts of the file cannot be read, by where they stand ("cameras[1]"). Something harmless is in their place.
using BrokenParts = std::map<std::string, std::string>;

struct Prepared {
  std::string text;                   ///< for tinygltf: what shape.h names, without buffers and images
  std::vector<BufferSource> buffers;  ///< of the file, read when first asked for
  std::vector<ImageSource> images;
  std::vector<uint64_t> strides;  ///< of the bufferViews, 0 where they have none: tinygltf takes multiples of 4 alone
  BrokenParts broken;
  std::map<int64_t, CompressedView> compressed;  ///< of the bufferViews, those that are
  std::vector<uint64_t> bare;  ///< accessors without a bufferView that tinygltf 2.7 wants one of: they name another,
                               ///< behind the file's own
};

/// A Fault where a field is of the wrong type or out of range, or a needed one is missing, but for the parts that may
/// be broken: cameras, lights, accessors and the indices of primitives.
[[nodiscard]] Prepared prepare(nlohmann::json root);

}  // namespace crsh::scene
