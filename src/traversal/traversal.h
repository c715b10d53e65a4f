#pragma once
// Section 3.2.5: tests ray nodes against the scene's triangles, from the top level down, as many at a time as memory
// holds.

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

/// Candidates: pairs of a level-1 node and a triangle, node by node. Node n of [first_node, end_node) has the pairs
/// [bases[b] - pairs_before, bases[b + 1] - pairs_before), with b = first_base + n - first_node.
struct Candidates {
  const gpu::Buffer& pairs;  ///< shared::HitPair
  const gpu::Buffer& bases;  ///< uint, with one element more at the end
  uint32_t first_base = 0;   ///< element of `bases` that belongs to first_node
  uint32_t first_node = 0, end_node = 0;
  uint64_t count = 0;         ///< pairs
  uint32_t pairs_before = 0;  ///< value of bases[first_base]: pair 0 of `pairs`
};

/// Pairs, masks and bases of one level of the descent; kept between calls.
struct LevelScratch {
  gpu::Buffer masks;   ///< uint a block (top level) or 32 candidates (below): which of them may be hit
  gpu::Buffer counts;  ///< uint a mask (top) or a node, scanned in place
  gpu::Buffer bases;   ///< uint a node, and one element more: its first pair
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
  uint64_t max_pairs = 0;       ///< in a list; 0: as many as memory allows
  uint32_t drop_every = 0;      ///< test-only mutation: one of so many pairs is dropped; 0: none is
  const hierarchy::Account& account = hierarchy::no_account;
};

/// Tests nodes of level `depth` against all triangles, and what they hit against the nodes below, down to level 1.
/// Calls `intersect` for one slice of the candidates after the other, each as large as memory allows. Each pair of a
/// level-1 node and a triangle comes exactly once, in the same order on every run.
void traverse(gpu::Recorder& recorder, const In& in, uint32_t depth, hierarchy::Range nodes, Scratch& scratch,
              const std::function<void(const Candidates&)>& intersect);

}  // namespace crsh::traversal
