#pragma once
// How the rows of a table become batches of rays, as a frame would have made them.

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

/// Batches by rising number and bounce, none above what one may hold. Within a segment rows follow each other as
/// --ray-order makes them where the image's size is known, else as they stand in the table.
[[nodiscard]] std::vector<ReplayBatch> replay_batches(const RayTable& table, const AlgorithmOptions& options);

}  // namespace crsh
