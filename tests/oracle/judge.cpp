#include "oracle/judge.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "crsh/kinds.h"
#include "shared/limits.h"
#include "shared/ray.h"

namespace crsh::test {
namespace {

constexpr double margin = 1e-5;
const glm::uvec3 blocked(0xFFFFFFFFu);

/// What the GPU made of a ray.
struct Traced {
  OracleRay ray;
  bool shadow = false, past_backs = false;
  uint32_t hit = shared::none;
  float t = 0;
  glm::uvec3 transmittance{0};
};

Traced traced(const RayTable& rays, uint32_t row) {
  return {{rays.origin[row], rays.direction[row], rays.tmax[row]},
          ray_kinds[rays.kind[row]].any_hit,
          !rays.past_backs.empty() && rays.past_backs[row] != 0,
          rays.hit[row],
          rays.t[row],
          rays.transmittance[row]};
}

/// Within the margin, or where the ray is too short for that, within `resolution`.
bool same_distance(double a, double b, double resolution) {
  return std::abs(a - b) <= std::max(margin * std::max(a, b), resolution);
}

double largest(const glm::dvec3& v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); }

/// How well barycentric coordinates can be known in float32: the margin; and where the triangle looks thin, half a unit
/// in the last place of its corners as seen from the ray's origin, against how high it looks.
double barycentric_resolution(const OracleRay& ray, const OracleTriangle& triangle, double cosine) {
  const glm::dvec3 a(triangle.a), b(triangle.b), c(triangle.c), origin(ray.origin);
  const double reach = std::max({largest(a - origin), largest(b - origin), largest(c - origin)});
  const double longest = std::max({glm::distance(a, b), glm::distance(b, c), glm::distance(c, a)});
  const double height = glm::length(glm::cross(b - a, c - a)) / longest * cosine;
  return std::max(margin, 0x1p-24 * reach / std::max(height, 1e-30));
}

double cosine_between(const OracleRay& ray, const OracleTriangle& triangle) {
  const glm::dvec3 a(triangle.a), b(triangle.b), c(triangle.c);
  return std::abs(glm::dot(glm::normalize(glm::cross(b - a, c - a)), glm::dvec3(ray.direction)));
}

double weights_off(const OracleRay& ray, const OracleTriangle& triangle) {
  return barycentric_resolution(ray, triangle, cosine_between(ray, triangle));
}

/// How well a distance can be known in float32, however short it is: four units in the last place of the largest
/// coordinate, along the ray; and as far as the triangle's depths differ, what is known of the barycentric coordinates
/// that weigh them.
double resolution(const OracleRay& ray, const OracleTriangle& triangle) {
  const glm::dvec3 a(triangle.a), b(triangle.b), c(triangle.c), direction(ray.direction);
  const double cosine = cosine_between(ray, triangle);
  const double size = std::max({largest(ray.origin), largest(a), largest(b), largest(c)});
  const auto [nearest, farthest] =
      std::minmax({glm::dot(a, direction), glm::dot(b, direction), glm::dot(c, direction)});
  return std::max(4 * 0x1p-23 * size / std::max(cosine, 1e-6),
                  barycentric_resolution(ray, triangle, cosine) * (farthest - nearest));
}

glm::uvec3 saturating_sum(const glm::uvec3& a, const glm::uvec3& b) {
  glm::uvec3 sum = a + b;
  for (int channel = 0; channel < 3; ++channel)
    if (sum[channel] < a[channel]) sum[channel] = blocked[channel];
  return sum;
}

/// -log2 of what is let through, of which the GPU's words may be any.
struct Words {
  glm::uvec3 low{0}, high{0};
};

bool holds(const Words& words, const glm::uvec3& found) {
  return glm::all(glm::lessThanEqual(words.low, found)) && glm::all(glm::lessThanEqual(found, words.high));
}

/// Rounded down, and 0 where all is let through.
uint32_t minus_log2(double through) {
  return through > 0 ? uint32_t(std::max(std::log2(through) * -65536, 0.0)) : blocked.x;
}

/// What a sheet of this alpha lets through: all beside it, and of what meets it the tint, known to 10 bits.
Words sheet(const Range& alpha, const OracleTriangle& triangle) {
  Words words;
  for (int channel = 0; channel < 3; ++channel) {
    const uint32_t tint = triangle.tint[channel];
    const double share = tint == blocked.x ? 0 : std::exp2(tint / -65536.0), off = share > 0 ? 0.51 / 1023 : 0;
    const double most = 1 - alpha.low * (1 - std::min(share + off, 1.0));
    const double least = 1 - alpha.high * (1 - std::max(share - off, 0.0));
    const uint32_t low = minus_log2(most), high = minus_log2(least);
    words.low[channel] = low == blocked.x || low == 0 ? low : low - 1;
    words.high[channel] = high == blocked.x ? high : high + 2;
  }
  return words;
}

/// After what lies `before` it, where alpha is known to a range.
Words passed(const Words& before, const OracleTriangle& triangle, const Range& alpha) {
  if (triangle.alpha && triangle.alpha->blends) {
    const Words own = sheet(alpha, triangle);
    return {saturating_sum(before.low, own.low), saturating_sum(before.high, own.high)};
  }
  if (!triangle.transmissive) return {blocked, blocked};
  return {saturating_sum(before.low, triangle.tint), saturating_sum(before.high, triangle.tint)};
}

Range alpha_around(const OracleTriangle& triangle, const glm::dvec2& weights, double off) {
  return triangle.alpha ? triangle.alpha->around(weights, off) : Range{1, 1};
}

/// Whether the ray passes the triangle, whose back it meets or of which alpha leaves nothing there.
bool passes(const Traced& traced, const OracleTriangle& triangle, const glm::dvec2& weights) {
  if (triangle.alpha && triangle.alpha->at(weights) < triangle.alpha->least) return true;
  const glm::dvec3 a(triangle.a), normal = glm::cross(glm::dvec3(triangle.b) - a, glm::dvec3(triangle.c) - a);
  return traced.past_backs && triangle.single_sided && glm::dot(normal, glm::dvec3(traced.ray.direction)) > 0;
}

bool agrees(const Traced& traced, const Embree& embree, const std::vector<OracleTriangle>& triangles) {
  if (traced.shadow) {
    Words words;
    for (const Crossing& crossing : embree.all(traced.ray))
      if (const OracleTriangle& triangle = triangles[crossing.triangle]; !passes(traced, triangle, crossing.weights))
        words = passed(words, triangle, alpha_around(triangle, crossing.weights, margin));
    return holds(words, traced.transmittance);
  }
  const auto closest = embree.closest(traced.ray);
  if (!closest) return traced.hit == shared::none;
  return traced.hit != shared::none && same_distance(traced.t, closest->t, 0);
}

enum class Meeting { none, sure, doubtful };

struct Met {
  uint32_t triangle = 0;
  double t = 0, resolution = 0;
  Meeting meeting = Meeting::none;
  Range alpha{1, 1};
};

/// What alpha leaves of a meeting.
Meeting left(Meeting meeting, const OracleTriangle& triangle, const Range& alpha) {
  if (!triangle.alpha) return meeting;
  if (alpha.high < triangle.alpha->least) return Meeting::none;
  return alpha.low < triangle.alpha->least ? Meeting::doubtful : meeting;
}

/// In double precision (Möller and Trumbore). Doubtful within the margin of an edge, of the ray's end or of
/// what alpha cuts away.
Met meet(const Traced& traced, const OracleTriangle& triangle, uint32_t number) {
  const glm::dvec3 origin(traced.ray.origin), direction(traced.ray.direction), a(triangle.a);
  const glm::dvec3 ab = glm::dvec3(triangle.b) - a, ac = glm::dvec3(triangle.c) - a, from_a = origin - a;
  const glm::dvec3 p = glm::cross(direction, ac), q = glm::cross(from_a, ab);
  const double determinant = glm::dot(ab, p);  // positive: the ray meets the front
  const bool passes_backs = !traced.shadow || traced.past_backs;
  if (determinant == 0 || (passes_backs && triangle.single_sided && determinant < 0)) return {};
  const double v = glm::dot(from_a, p) / determinant, w = glm::dot(direction, q) / determinant;
  const double t = glm::dot(ac, q) / determinant, inside = std::min({v, w, 1 - v - w}), end = traced.ray.tmax;
  if (inside < -margin || t <= 0 || t > end * (1 + margin)) return {};
  const bool doubtful = inside <= margin || t >= end * (1 - margin);
  const Range alpha = alpha_around(triangle, {v, w}, triangle.alpha ? weights_off(traced.ray, triangle) : 0);
  const Meeting meeting = left(doubtful ? Meeting::doubtful : Meeting::sure, triangle, alpha);
  return {number, t, resolution(traced.ray, triangle), meeting, alpha};
}

enum class Finding { right, exception, wrong };

/// The closest hit, if any doubtful meeting may be left out.
Finding find_closest(const Traced& traced, const std::vector<Met>& met) {
  const Met* own = nullptr;
  double sure = std::numeric_limits<double>::infinity(), any = sure;
  for (const Met& m : met) {
    if (m.triangle == traced.hit) own = &m;
    if (m.meeting == Meeting::sure) sure = std::min(sure, m.t);
    any = std::min(any, m.t);
  }
  if (traced.hit == shared::none)
    return std::isfinite(sure) ? Finding::wrong : met.empty() ? Finding::right : Finding::exception;
  if (!own || !same_distance(own->t, traced.t, own->resolution)) return Finding::wrong;
  const double nearest = own->t - std::max(margin * own->t, own->resolution);
  if (sure < nearest) return Finding::wrong;
  const bool beyond_doubt = own->meeting == Meeting::sure && any >= nearest;
  return beyond_doubt ? Finding::right : Finding::exception;
}

/// Whether any choice among the doubtful meetings from `first` on makes up the words.
bool made_up(const Words& words, const Traced& traced, const std::vector<Met>& doubtful,
             const std::vector<OracleTriangle>& triangles, size_t first) {
  if (first == doubtful.size()) return holds(words, traced.transmittance);
  const Met& m = doubtful[first];
  return made_up(words, traced, doubtful, triangles, first + 1) ||
         made_up(passed(words, triangles[m.triangle], m.alpha), traced, doubtful, triangles, first + 1);
}

Finding find_shadow(const Traced& traced, const std::vector<Met>& met, const std::vector<OracleTriangle>& triangles) {
  Words words;
  std::vector<Met> doubtful;
  for (const Met& m : met) {
    if (m.meeting == Meeting::sure) words = passed(words, triangles[m.triangle], m.alpha);
    else doubtful.push_back(m);
  }
  if (doubtful.empty() && holds(words, traced.transmittance)) return Finding::right;
  return made_up(words, traced, doubtful, triangles, 0) ? Finding::exception : Finding::wrong;
}

/// Against every triangle.
Finding find(const Traced& traced, const std::vector<OracleTriangle>& triangles) {
  std::vector<Met> met;
  for (uint32_t i = 0; i < triangles.size(); ++i)
    if (const Met m = meet(traced, triangles[i], i); m.meeting != Meeting::none) met.push_back(m);
  return traced.shadow ? find_shadow(traced, met, triangles) : find_closest(traced, met);
}

std::string sentence(const RayTable& rays, uint32_t row) {
  const glm::vec3 &o = rays.origin[row], &d = rays.direction[row];
  return fmt::format(
      "ray {} of kind {} and bounce {}, from ({}, {}, {}) along ({}, {}, {}) to {}: triangle {} at {}, "
      "transmittance ({:x}, {:x}, {:x})",
      row, rays.kind[row], rays.bounce[row], o.x, o.y, o.z, d.x, d.y, d.z, rays.tmax[row], int(rays.hit[row]),
      rays.t[row], rays.transmittance[row].x, rays.transmittance[row].y, rays.transmittance[row].z);
}

}  // namespace

Verdict judged(const RayTable& rays, const std::vector<OracleTriangle>& triangles) {
  const Embree embree(triangles);
  Verdict verdict{.rays = rays.size(), .first_wrong = {}};
  for (uint32_t row = 0; row < rays.size(); ++row) {
    const Traced ray = traced(rays, row);
    if (agrees(ray, embree, triangles)) continue;
    ++verdict.disagreed;
    const Finding finding = find(ray, triangles);
    verdict.exceptions += finding == Finding::exception;
    verdict.wrong += finding == Finding::wrong;
    if (finding == Finding::wrong && verdict.first_wrong.empty()) verdict.first_wrong = sentence(rays, row);
  }
  return verdict;
}

}  // namespace crsh::test
