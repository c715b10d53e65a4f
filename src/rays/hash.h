#pragma once
// The hash of every ray of a batch, and its key-value pair.

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "crsh/kinds.h"
#include "gpu/recorder.h"
#include "rays/batch.h"
#include "scene/scene.h"

namespace crsh::rays {

/// A sort key a ray kind: names of files below shaders/rays/keys/. Empty, or "creation": creation order. key_of_file:
/// the batch's given keys.
using Keys = PerKind<std::string>;

inline constexpr std::string_view key_of_file = "file";

/// Names of all sort keys that the build found, sorted.
[[nodiscard]] std::vector<std::string> key_names();

/// Bits of the hash that this key gives to the segment's rays (0: creation order), as its shader declares. The key must
/// exist.
[[nodiscard]] uint32_t hash_bits(std::string_view key, const Segment& segment);

/// Whether any rays of the batch are sorted by a key.
[[nodiscard]] bool any_sorted(const Batch& batch, const Keys& keys);

/// Writes for every ray of the batch the pair, uvec2 (key, ray), to `pairs`, which grows to hold them, and returns the
/// number of bits of the keys, 32 at most. A key is the number of the ray's segment above its hash; segments must come
/// in rising order of kind and light. Origins are placed within `bounds`, those of the scene. (Section 3.2.2, Figures 2
/// and 3.)
[[nodiscard]] uint32_t hash(gpu::Recorder& recorder, const Batch& batch, const Keys& keys, const scene::Bounds& bounds,
                            gpu::Buffer& pairs);

}  // namespace crsh::rays
