#include "frame/dump.h"

#include <bit>
#include <numeric>

#include "rays/hash.h"
#include "shared/limits.h"
#include "shared/ray.h"

namespace crsh {
namespace {

/// A word of each surface's vec4, as bits.
std::vector<uint32_t> read_w(gpu::Recorder& recorder, const gpu::Buffer& buffer, uint32_t first, uint32_t count) {
  std::vector<uint32_t> words;
  for (const glm::vec4& value : recorder.read<glm::vec4>(buffer, count, first))
    words.push_back(std::bit_cast<uint32_t>(value.w));
  return words;
}

/// The hash of each ray, which is its key without the number of its segment. It is computed again, because sorting
/// overwrites it.
std::vector<uint32_t> read_keys(gpu::Recorder& recorder, const trace::Traced& traced) {
  const rays::Batch& batch = traced.in.batch;
  if (!traced.sorted()) return std::vector<uint32_t>(batch.count);
  gpu::Buffer& pairs = traced.bundle->sort.pairs;
  const uint32_t bits = rays::hash(recorder, batch, traced.in.options.algorithm.keys, traced.in.scene.bounds, pairs) -
                        std::bit_width(batch.segments.size() - 1);
  std::vector<uint32_t> hashes;
  for (const glm::uvec2& pair : recorder.read<glm::uvec2>(pairs, batch.count))
    hashes.push_back(pair.x & static_cast<uint32_t>((uint64_t(1) << bits) - 1));
  return hashes;
}

/// The sorted place of each ray of the batch.
std::vector<uint32_t> read_places(gpu::Recorder& recorder, const trace::Traced& traced) {
  const uint32_t count = traced.in.batch.count;
  std::vector<uint32_t> places(count);
  std::iota(places.begin(), places.end(), 0u);
  if (!traced.bundle) return places;
  const auto order = recorder.read<uint32_t>(traced.bundle->order.order, count);
  for (uint32_t place = 0; place < count; ++place) places[order[place]] = place;
  return places;
}

void set_ray(RayTable& table, size_t row, const shared::Ray& ray) {
  table.origin[row] = glm::vec3(ray.origin);
  table.direction[row] = glm::vec3(ray.direction);
  table.tmax[row] = ray.origin.w;
  table.kind[row] = static_cast<uint32_t>(ray.direction.w);
  table.past_backs[row] = ray.direction.w != float(table.kind[row]);
}

void set_hit(RayTable& table, size_t row, const glm::uvec4& words) {
  const bool any_hit = ray_kinds[table.kind[row]].any_hit;
  table.hit[row] = any_hit ? shared::none : words.y;
  table.t[row] = any_hit ? std::numeric_limits<float>::infinity() : std::bit_cast<float>(words.x);
  table.transmittance[row] = any_hit ? glm::uvec3(words) : glm::uvec3(0);
}

}  // namespace

void dump_rays(gpu::Recorder& recorder, const trace::Traced& traced, RayTable& table) {
  const rays::Batch& batch = traced.in.batch;
  const trace::RayNames& names = traced.in.names;
  const auto rays = recorder.read<shared::Ray>(batch.rays, batch.count);
  const auto hits = recorder.read<glm::uvec4>(traced.in.workspace.hits, batch.count);
  const auto slots = recorder.read<uint32_t>(batch.slots, batch.count);
  const std::vector<uint32_t> keys = read_keys(recorder, traced), places = read_places(recorder, traced);
  const std::vector<uint32_t> pixels = read_w(recorder, names.pixels, names.first_surface, batch.surfaces);
  const std::vector<uint32_t> paths = read_w(recorder, names.paths, names.first_surface, batch.surfaces);
  const uint32_t first = table.size(), number = first ? table.batch.back() + 1 : 0;
  resize(table, size_t(first) + batch.count);
  for (const rays::Segment& segment : batch.segments)
    for (uint32_t ray = segment.first; ray < segment.first + segment.count; ++ray) {
      const size_t row = size_t(first) + ray;
      set_ray(table, row, rays[ray]);
      set_hit(table, row, hits[ray]);
      table.bounce[row] = traced.in.bounce;
      table.light[row] = segment.light;
      table.pixel[row] = pixels[slots[ray] % batch.surfaces];
      table.path[row] = paths[slots[ray] % batch.surfaces];
      table.batch[row] = number;
      table.key[row] = keys[ray];
      table.sorted[row] = first + places[ray];
    }
}

}  // namespace crsh
