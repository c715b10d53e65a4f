#pragma once
// Section 3.2.5: the tree of ray nodes against the scene, from the top level down, in triangle batches.

#include <cstdint>
#include <functional>

#include "crsh/options.h"
#include "gpu/buffer.h"
#include "gpu/recorder.h"
#include "hierarchy/account.h"
#include "hierarchy/hierarchy.h"
#include "primitives/scan.h"
#include "scene/device/upload.h"

namespace crsh::traversal {

/// Candidates: pairs of a level-1 node and a triangle, node-major; node n of [first_node, end_node) owns pairs
/// [bases[b] - pairs_before, bases[b + 1] - pairs_before), b = first_base + n - first_node.
struct Candidates {
  const gpu::Buffer& pairs;  ///< shared::HitPair
  const gpu::Buffer& bases;  ///< uint, with sentinel
  uint32_t first_base = 0;   ///< element of `bases` that belongs to first_node
  uint32_t first_node = 0, end_node = 0;
  uint64_t count = 0;         ///< pairs
  uint32_t pairs_before = 0;  ///< value of bases[first_base]: pair 0 of `pairs`
};

/// Pairs, masks and bases of one level of the descent; kept between calls.
struct LevelScratch {
  gpu::Buffer masks;   ///< uint a block (top level) or a 32 candidates (below): which of them hit
  gpu::Buffer counts;  ///< uint a mask (top) or a node, scanned in place
  gpu::Buffer bases;   ///< uint a node, with sentinel: its first pair
  gpu::Buffer pairs;   ///< shared::HitPair
};

struct Scratch {
  std::vector<LevelScratch> levels;
  gpu::Buffer mesh_hits;  ///< bits a top node: which objects' spheres it may hit
  primitives::ScanScratch scan;
};

struct In {
  const hierarchy::Hierarchy& hierarchy;
  const scene::GpuScene& scene;
  const AlgorithmOptions& options;
  const gpu::Buffer& counters;  ///< uvec2, 64 bits each
  uint32_t counter_row = 0;     ///< first counter of this bounce and kind
  uint64_t submit_work = 0;     ///< tests a submit
  uint64_t most_pairs = 0;      ///< of a list; 0: what memory allows
  uint32_t drop_every = 0;      ///< test-only mutation: every so many-th pair is dropped; 0: none
  const hierarchy::Account& account = hierarchy::no_account;
};

/// Level `depth` nodes [first, end) of the hierarchy against all triangles. Calls `intersect` for every portion of
/// candidates that fits memory; each (level-1 node, triangle) pair comes exactly once, in the same order on every run.
void traverse(gpu::Recorder& recorder, const In& in, uint32_t depth, hierarchy::Range nodes, Scratch& scratch,
              const std::function<void(const Candidates&)>& intersect);

}  // namespace crsh::traversal
