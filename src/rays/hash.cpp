#include "rays/hash.h"

#include <algorithm>
#include <bit>
#include <map>

#include "crsh/assertion.h"
#include "primitives/grow.h"
#include "primitives/sort.h"

namespace crsh::rays {
namespace {

constexpr std::string_view prefix = "rays/hash@", suffix = ".comp";

/// As hash.comp declares it.
struct Push {
  glm::vec3 scene_low;
  uint32_t first;
  glm::vec3 scene_inverse_extent;
  uint32_t count, segment, shared_origin;
};

/// As given_keys.comp declares it.
struct GivenPush {
  uint32_t first, count, segment;
};

std::string kernel_of(std::string_view key) {
  return std::string(prefix) + std::string(key.empty() ? "creation" : key);
}

uint32_t bits_of(const Batch& batch, const std::string& key, const Segment& segment) {
  return key == key_of_file ? batch.given_bits : hash_bits(key, segment);
}

/// The widest hash of the batch's rays.
uint32_t widest_hash(const Batch& batch, const Keys& keys) {
  uint32_t bits = 0;
  for (const Segment& segment : batch.segments)
    if (segment.count > 0) bits = std::max(bits, bits_of(batch, keys[segment.kind], segment));
  return bits;
}

/// Asserts that segments come in rising order of kind and light. So a segment keeps its place when its rays are sorted,
/// on which every pass over the batch relies.
void require_rising(const std::vector<Segment>& segments) {
  for (size_t i = 1; i < segments.size(); ++i) {
    const Segment &before = segments[i - 1], &after = segments[i];
    CRSH_ASSERT(std::pair(before.kind, before.light) <= std::pair(after.kind, after.light), "segments out of order");
    CRSH_ASSERT(before.first + before.count == after.first, "segments with gaps");
  }
}

/// The push constants: the low corner of the scene's bounds, and 1 / their extent, 0 along axes without extent.
Push push_of(const scene::Bounds& bounds) {
  Push push{};
  if (bounds.empty()) return push;
  push.scene_low = bounds.low;
  const glm::vec3 extent = bounds.high - bounds.low;
  for (int axis = 0; axis < 3; ++axis) push.scene_inverse_extent[axis] = extent[axis] > 0 ? 1 / extent[axis] : 0;
  return push;
}

}  // namespace

std::vector<std::string> key_names() {
  std::vector<std::string> names;
  for (std::string_view file : gpu::embedded_files())
    if (file.starts_with(prefix))
      names.emplace_back(file.substr(prefix.size(), file.size() - prefix.size() - suffix.size()));
  return names;
}

namespace {

/// Of every kernel that hashes: the bits where rays share their origin, and where not. Read once, for renderers of all
/// threads.
std::map<std::string, std::array<uint32_t, 2>> all_hash_bits() {
  std::map<std::string, std::array<uint32_t, 2>> bits;
  for (const std::string& key : key_names()) {
    const std::string kernel = kernel_of(key), file = kernel + std::string(suffix);
    bits[kernel] = {gpu::declared_constant(file, 0), gpu::declared_constant(file, 1)};
  }
  return bits;
}

}  // namespace

uint32_t hash_bits(std::string_view key, const Segment& segment) {
  static const std::map<std::string, std::array<uint32_t, 2>> known = all_hash_bits();
  const auto found = known.find(kernel_of(key));
  CRSH_ASSERT(found != known.end(), "no key is called " + std::string(key));
  return found->second[segment.shares_origin ? 0 : 1];
}

bool any_sorted(const Batch& batch, const Keys& keys) { return widest_hash(batch, keys) > 0; }

uint32_t hash(gpu::Recorder& recorder, const Batch& batch, const Keys& keys, const scene::Bounds& bounds,
              gpu::Buffer& pairs) {
  require_rising(batch.segments);
  primitives::grow(recorder, pairs, primitives::pair_bytes(batch.count), "rays.pairs");
  const uint32_t bits = widest_hash(batch, keys);
  const uint32_t segment_bits = batch.segments.empty() ? 0 : std::bit_width(batch.segments.size() - 1);
  CRSH_ASSERT(bits + segment_bits <= 32, "keys of more than 32 bits");
  Push push = push_of(bounds);
  for (uint32_t i = 0; i < batch.segments.size(); ++i) {
    const Segment& segment = batch.segments[i];
    push.first = segment.first, push.count = segment.count;
    push.shared_origin = segment.shares_origin ? 1 : 0;
    push.segment = bits < 32 ? i << bits : 0;
    if (keys[segment.kind] == key_of_file) {
      recorder.dispatch("rays/given_keys", segment.count, GivenPush{push.first, push.count, push.segment},
                        {{"given", batch.given_keys}, {"pairs", pairs}}, segment.count);
      continue;
    }
    recorder.dispatch(kernel_of(keys[segment.kind]), segment.count, push, {{"rays", batch.rays}, {"pairs", pairs}},
                      segment.count);
  }
  return bits + segment_bits;
}

}  // namespace crsh::rays
