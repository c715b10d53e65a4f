// What every sort key promises, those of the build's own besides, and those with a C++ twin bit for bit.

#include <doctest/doctest.h>

#include <algorithm>
#include <numeric>
#include <random>
#include <set>

#include "batches.h"
#include "crsh/options.h"
#include "keys_twin.h"
#include "rays/hash.h"

using namespace crsh;

namespace {

/// The hashes of `rays`, all of one kind.
std::vector<uint32_t> hashes(const std::string& key, const std::vector<shared::Ray>& rays, uint32_t kind) {
  gpu::Recorder recorder(test::device());
  gpu::Buffer pairs;
  const rays::Batch batch = test::make_batch(rays, {{kind, 0, 0, uint32_t(rays.size())}});
  const uint32_t bits = rays::hash(recorder, batch, rays::Keys(key), test::unit_bounds(), pairs);
  CHECK(bits == rays::hash_bits(key, {.kind = kind}));
  std::vector<uint32_t> result;
  uint32_t misplaced = 0;
  for (const glm::uvec2& pair : recorder.read<glm::uvec2>(pairs, rays.size())) {
    misplaced += pair.y != result.size();
    result.push_back(pair.x);
  }
  CHECK(misplaced == 0);
  return result;
}

glm::vec3 place_of(const shared::Ray& ray) { return (glm::vec3(ray.origin) + 1.0f) * 0.5f; }

/// The direction whose octahedral map is the middle of a cell.
glm::vec3 direction_of_cell(uint32_t x, uint32_t y, uint32_t bits) {
  const glm::vec2 p = (glm::vec2(x, y) + 0.5f) / float(1u << bits) * 2.0f - 1.0f;
  const float down = 1 - std::abs(p.x) - std::abs(p.y), fold = std::max(-down, 0.0f);
  return glm::normalize(glm::vec3(p.x - std::copysign(fold, p.x), -down, p.y - std::copysign(fold, p.y)));
}

}  // namespace

TEST_CASE("every key that has a C++ twin agrees with it bit for bit") {
  std::set<std::string> compared;
  for (const std::string& key : rays::key_names())
    for (uint32_t kind = 0; kind < shared::kind_count; ++kind) {
      const std::vector<shared::Ray> rays = test::key_rays(20'000, kind);
      if (!test::key_twin(key, place_of(rays[0]), rays[0].direction, kind)) continue;
      const std::vector<uint32_t> found = hashes(key, rays, kind);
      uint32_t different = 0;
      for (size_t i = 0; i < rays.size(); ++i)
        different += found[i] != test::key_twin(key, place_of(rays[i]), rays[i].direction, kind);
      CAPTURE(key);
      CAPTURE(kind);
      CHECK(different == 0);
      compared.insert(key);
    }
  for (const AlgorithmOptions& algorithm : {preset("crsh-2017"), preset("crsh"), preset("crsh-bvh")})
    for (const std::string& key : algorithm.keys) CHECK(compared.contains(key));  // what is used unasked has one
}

TEST_CASE("the spherical key's angles are right to a millionth of a radian") {
  double worst = 0;
  for (const shared::Ray& ray : test::key_rays(50'000, 0)) {
    const double x = ray.direction.x, z = ray.direction.z;
    worst = std::max(worst, std::abs(std::atan2(z, x) - double(test::atan_twin(ray.direction.z, ray.direction.x))));
  }
  CHECK(worst < 1e-6);
}

TEST_CASE("a key depends on the ray alone: not on the rays around it, nor on its place among them") {
  for (const std::string& key : rays::key_names())
    for (uint32_t kind = 0; kind < shared::kind_count; ++kind) {
      std::vector<shared::Ray> rays = test::key_rays(3'000, kind);
      const std::vector<uint32_t> before = hashes(key, rays, kind);
      std::vector<uint32_t> order(rays.size());
      std::iota(order.begin(), order.end(), 0);
      std::shuffle(order.begin(), order.end(), std::mt19937(5));
      std::vector<shared::Ray> shuffled;
      for (const uint32_t i : order) shuffled.push_back(rays[i]);
      const std::vector<uint32_t> after = hashes(key, shuffled, kind);
      uint32_t different = 0;
      for (size_t i = 0; i < order.size(); ++i) different += after[i] != before[order[i]];
      CAPTURE(key);
      CHECK(different == 0);
    }
}

TEST_CASE("places beyond the scene's bounds have the key of the nearest place on them") {
  for (const std::string& key : rays::key_names())
    for (uint32_t kind = 0; kind < shared::kind_count; ++kind) {
      std::vector<shared::Ray> rays = test::key_rays(3'000, kind), clamped = rays;
      for (shared::Ray& ray : clamped) ray.origin = glm::vec4(glm::clamp(glm::vec3(ray.origin), -1.0f, 1.0f), INFINITY);
      CAPTURE(key);
      CHECK(hashes(key, rays, kind) == hashes(key, clamped, kind));
    }
}

TEST_CASE("every key keeps to its bits, and to 26, so that 64 segments fit beside it") {
  for (const std::string& key : rays::key_names())
    for (uint32_t kind = 0; kind < shared::kind_count; ++kind) {
      const uint32_t bits = rays::hash_bits(key, {.kind = kind});
      CAPTURE(key);
      CHECK(bits <= 26);
      for (uint32_t hash : hashes(key, test::key_rays(5'000, kind), kind)) REQUIRE((uint64_t(hash) >> bits) == 0);
    }
}

TEST_CASE("keys are the same on every run") {
  for (const std::string& key : rays::key_names())
    for (uint32_t kind = 0; kind < shared::kind_count; ++kind) {
      const std::vector<shared::Ray> rays = test::key_rays(10'000, kind);
      CAPTURE(key);
      CHECK(hashes(key, rays, kind) == hashes(key, rays, kind));
    }
}

TEST_CASE("the paper's key is theta and phi, 5 bits each, theta above phi") {
  CHECK(rays::hash_bits("spherical", {.kind = shared::kind_shadow}) == 10);
  std::vector<shared::Ray> rays(4);
  rays[0].direction = {0, 1, 0, 0};
  rays[1].direction = {0, -1, 0, 0};
  rays[2].direction = {0.7071f, -0.001f, 0.7071f, 0};
  rays[3].direction = {-0.7071f, -0.001f, -0.7071f, 0};
  const std::vector<uint32_t> found = hashes("spherical", rays, shared::kind_shadow);
  CHECK((found[0] >> 5) == 0);
  CHECK((found[1] >> 5) == 31);
  CHECK(found[2] == (16 << 5 | 20));  // phi = 45 degrees: (45 + 180) / 360 of 32
  CHECK(found[3] == (16 << 5 | 4));   // phi = -135 degrees
}

TEST_CASE("the Hilbert key walks the octahedral square from neighbour to neighbour") {
  constexpr uint32_t bits = 12, side = 256;  // an aligned square of cells is one stretch of the curve
  for (const glm::uvec2 corner : {glm::uvec2(0, 0), glm::uvec2(2048, 1792), glm::uvec2(3840, 256)}) {
    std::vector<shared::Ray> rays;
    for (uint32_t y = 0; y < side; ++y)
      for (uint32_t x = 0; x < side; ++x)
        rays.push_back({{0, 0, 0, 1}, glm::vec4(direction_of_cell(corner.x + x, corner.y + y, bits), 0)});
    const std::vector<uint32_t> found = hashes("hilbert", rays, shared::kind_shadow);
    std::vector<uint32_t> cell_at(side * side, UINT32_MAX);
    const uint32_t first = *std::min_element(found.begin(), found.end());
    for (uint32_t cell = 0; cell < found.size(); ++cell) {
      REQUIRE(found[cell] - first < cell_at.size());
      cell_at[found[cell] - first] = cell;
    }
    uint32_t jumps = 0;
    for (uint32_t i = 1; i < cell_at.size(); ++i) {
      REQUIRE(cell_at[i] != UINT32_MAX);  // every place on the stretch is taken, so none twice
      const int dx = int(cell_at[i] % side) - int(cell_at[i - 1] % side),
                dy = int(cell_at[i] / side) - int(cell_at[i - 1] / side);
      jumps += std::abs(dx) + std::abs(dy) != 1;
    }
    CHECK(jumps == 0);
  }
}

TEST_CASE("rays that are neighbours in key order are nearer in direction than in creation order") {
  const std::vector<shared::Ray> rays = test::key_rays(20'000, shared::kind_shadow);
  const auto mean_angle = [&](const std::vector<uint32_t>& order) {
    double sum = 0;
    for (size_t i = 1; i < order.size(); ++i)
      sum += std::acos(std::clamp(
          double(glm::dot(glm::vec3(rays[order[i]].direction), glm::vec3(rays[order[i - 1]].direction))), -1.0, 1.0));
    return sum / double(order.size() - 1);
  };
  std::vector<uint32_t> created(rays.size());
  for (uint32_t i = 0; i < created.size(); ++i) created[i] = i;
  for (const std::string key : {"hilbert", "octahedral", "spherical", "direction-origin"}) {
    const std::vector<uint32_t> found = hashes(key, rays, shared::kind_shadow);
    std::vector<uint32_t> order = created;
    std::stable_sort(order.begin(), order.end(), [&](uint32_t a, uint32_t b) { return found[a] < found[b]; });
    CAPTURE(key);
    CHECK(mean_angle(order) < mean_angle(created) / 10);
  }
}

TEST_CASE("directions that have no key of their own still get one") {
  std::vector<shared::Ray> rays(3);
  rays[0].direction = {0, 0, 0, 0};
  rays[1].direction = {NAN, 1, 0, 0};
  rays[2].origin = {INFINITY, -INFINITY, NAN, 1};
  for (const std::string& key : rays::key_names())
    for (uint32_t kind = 0; kind < shared::kind_count; ++kind)
      for (uint32_t hash : hashes(key, rays, kind)) {
        CAPTURE(key);
        CHECK((uint64_t(hash) >> rays::hash_bits(key, {.kind = kind})) == 0);
      }
}
