// Traces rays of a table in place of a frame's: uploads each batch, and takes it through the same steps.

#include <algorithm>
#include <bit>
#include <numeric>

#include "frame/replay_batches.h"
#include "frame/trace.h"
#include "primitives/grow.h"
#include "rays/hash.h"
#include "shared/ray.h"

namespace crsh {
namespace {

/// A batch's rays as shaders read them, each with a slot and a surface of its own.
struct Uploaded {
  std::vector<shared::Ray> rays;
  std::vector<uint32_t> slots;
  std::vector<glm::vec4> pixels, paths;  ///< in w, as surfaces::Surfaces have them
};

/// Where the ray begins, measured from `centre`: to the last bit as in the table where that measures from there, too.
glm::vec3 begin_of(const RayTable& table, uint32_t row, const glm::dvec3& centre) {
  if (table.centre == centre) return table.origin[row];
  return glm::vec3(glm::dvec3(table.origin[row]) + (table.centre - centre));
}

/// Kind, and past_backs, as shared::Ray has them.
float word_of(const RayTable& table, uint32_t row) {
  const bool passes = !table.past_backs.empty() && table.past_backs[row];
  return float(table.kind[row]) + (passes ? shared::past_backs : 0);
}

Uploaded uploaded(const RayTable& table, const ReplayBatch& batch, const glm::dvec3& centre) {
  Uploaded data;
  for (const uint32_t row : batch.rows) {
    data.rays.push_back({glm::vec4(begin_of(table, row, centre), table.tmax[row]),
                         glm::vec4(table.direction[row], word_of(table, row))});
    data.pixels.push_back({0, 0, 0, std::bit_cast<float>(table.pixel[row])});
    data.paths.push_back({0, 0, 0, std::bit_cast<float>(table.path[row])});
  }
  data.slots.resize(batch.rows.size());
  std::iota(data.slots.begin(), data.slots.end(), 0u);
  return data;
}

/// The keys' ranks in the batch in place of the keys, which may be wider than 32 bits: sorting by ranks gives the same
/// order.
std::vector<uint32_t> ranks_of_keys(const RayTable& table, const ReplayBatch& batch, uint32_t& bits) {
  std::vector<uint64_t> values;
  for (const uint32_t row : batch.rows) values.push_back(table.key[row]);
  std::ranges::sort(values);
  values.erase(std::unique(values.begin(), values.end()), values.end());
  std::vector<uint32_t> ranks;
  for (const uint32_t row : batch.rows)
    ranks.push_back(static_cast<uint32_t>(std::ranges::lower_bound(values, table.key[row]) - values.begin()));
  bits = std::bit_width(values.size() - 1);
  return ranks;
}

template <class T>
void put(gpu::Recorder& recorder, gpu::Buffer& buffer, const std::vector<T>& values, std::string_view name) {
  primitives::grow(recorder, buffer, (values.size() * sizeof(T) + 15) / 16 * 16, name);
  gpu::upload_bytes(recorder.device(), buffer, 0, values.data(), values.size() * sizeof(T));
}

/// Puts what was traced in the order of batches back into the rows that it belongs to. Keys from a file stay as they
/// are.
void restore_rows(const RayTable& given, const std::vector<uint32_t>& rows, const rays::Keys& keys, RayTable& table) {
  std::vector<uint32_t> places(rows.size());
  for (uint32_t place = 0; place < rows.size(); ++place) places[rows[place]] = place;
  table = rows_of(table, places);
  table.batch = given.batch;
  for (uint32_t row = 0; row < table.size(); ++row)
    if (keys[table.kind[row]] == rays::key_of_file) table.key[row] = given.key[row];
  table.width = given.width, table.height = given.height;
}

}  // namespace

void replay_rays(Renderer::State& s, const RayTable& table, double seconds) {
  place_objects(s, s.scene.pose(seconds, s.animations));
  s.film.layers = {};  // no pixels, no layers of tests
  gpu::Buffer &pixels = s.paths.first.diffuse, &paths = s.paths.first.specular;
  std::vector<uint32_t> rows;
  rows.reserve(table.size());
  for (const ReplayBatch& part : replay_batches(table, s.options.algorithm)) {
    CRSH_ASSERT(part.bounce <= s.options.bounces, "a ray of a bounce without counters");
    rays::Batch& batch = s.batch.rays;
    s.recorder.submit();
    const Uploaded data = uploaded(table, part, s.scene.origin);
    batch.segments = part.segments;
    batch.surfaces = batch.count = static_cast<uint32_t>(part.rows.size());
    put(s.recorder, batch.rays, data.rays, "rays.rays");
    put(s.recorder, batch.slots, data.slots, "rays.slots");
    put(s.recorder, pixels, data.pixels, "pixels");
    put(s.recorder, paths, data.paths, "paths");
    if (!table.key.empty())
      put(s.recorder, batch.given_keys, ranks_of_keys(table, part, batch.given_bits), "given keys");
    trace_rays(s, part.bounce, {pixels, paths, 0});
    rows.insert(rows.end(), part.rows.begin(), part.rows.end());
  }
  s.recorder.submit();
  if (!s.dump.rays) return;
  restore_rows(table, rows, s.options.algorithm.keys, *s.dump.rays);
  s.dump.rays->centre = s.scene.origin;
}

}  // namespace crsh
