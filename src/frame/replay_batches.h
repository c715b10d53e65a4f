#pragma once
// Makes batches of the rows of a table of rays, as a frame would have made them.

#include <cstdint>
#include <vector>

#include "crsh/options.h"
#include "crsh/ray_table.h"
#include "rays/batch.h"

namespace crsh {

struct ReplayBatch {
  uint32_t bounce = 0;
  std::vector<uint32_t> rows;  ///< of the table, in order of creation
  std::vector<rays::Segment> segments;
};

/// Batches by rising number and bounce, none with more rays than allowed. Within a segment rows are in the order of
/// --ray-order where the image's size is known, else in the table's.
[[nodiscard]] std::vector<ReplayBatch> replay_batches(const RayTable& table, const AlgorithmOptions& options);

}  // namespace crsh
