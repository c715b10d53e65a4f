#pragma once
// Batches of rays made by hand.

#include <cstdint>
#include <vector>

#include "gpu/buffer.h"
#include "rays/batch.h"
#include "scene/scene.h"
#include "shared/ray.h"
#include "support/device.h"

namespace crsh::test {

inline scene::Bounds unit_bounds() { return {glm::vec3(-1), glm::vec3(1)}; }

/// A batch that holds `rays`, cut into segments (kind and light given) of `counts` rays.
inline rays::Batch make_batch(const std::vector<shared::Ray>& rays, std::vector<rays::Segment> segments) {
  rays::Batch batch;
  batch.rays = gpu::upload(device(), rays, "rays");
  batch.segments = std::move(segments);
  for (rays::Segment& segment : batch.segments) segment.first = batch.count, batch.count += segment.count;
  return batch;
}

}  // namespace crsh::test
