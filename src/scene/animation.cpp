#include "scene/animation.h"

#include <algorithm>
#include <cmath>

namespace crsh::scene {
namespace {

glm::vec4 unit_rotation(const glm::vec4& v) {
  const double length = glm::length(glm::dvec4(v));
  return length > 0 ? glm::vec4(glm::dvec4(v) / length) : glm::vec4(0, 0, 0, 1);
}

/// Spherical interpolation by the shorter way (glTF 2.0, appendix C.4); a and b are unit.
glm::vec4 slerp(const glm::vec4& a, glm::vec4 b, float t) {
  float cosine = glm::dot(a, b);
  if (cosine < 0) {
    b = -b;
    cosine = -cosine;
  }
  if (cosine > 0.9995f)
    return unit_rotation(glm::mix(a, b, t));  // so near that dividing by the sine would lose precision
  const float angle = std::acos(cosine);
  return unit_rotation((a * std::sin((1 - t) * angle) + b * std::sin(t * angle)) / std::sin(angle));
}

/// Hermite spline (glTF 2.0, appendix C.5) between keys k and k + 1, `span` seconds apart.
glm::vec4 spline(const std::vector<glm::vec4>& values, size_t k, float t, float span) {
  const glm::vec4 &from = values[3 * k + 1], &leaving = values[3 * k + 2], &arriving = values[3 * k + 3],
                  &to = values[3 * k + 4];
  const float t2 = t * t, t3 = t2 * t;
  return from * (2 * t3 - 3 * t2 + 1) + leaving * (span * (t3 - 2 * t2 + t)) + to * (3 * t2 - 2 * t3) +
         arriving * (span * (t3 - t2));
}

glm::vec4 key_value(const Channel& channel, size_t k) {
  return channel.values[channel.interpolation == Interpolation::cubic_spline ? 3 * k + 1 : k];
}

glm::vec4 between_keys(const Channel& channel, size_t k, double seconds) {
  const double first = channel.times[k], span = channel.times[k + 1] - first;
  const auto t = static_cast<float>((seconds - first) / span);
  if (channel.interpolation == Interpolation::step) return key_value(channel, k);
  if (channel.interpolation == Interpolation::cubic_spline)
    return spline(channel.values, k, t, static_cast<float>(span));
  if (channel.path == Path::rotation)
    return slerp(unit_rotation(key_value(channel, k)), unit_rotation(key_value(channel, k + 1)), t);
  return glm::mix(key_value(channel, k), key_value(channel, k + 1), t);
}

}  // namespace

glm::vec4 sample(const Channel& channel, double seconds) {
  const auto after = std::upper_bound(channel.times.begin(), channel.times.end(), seconds,
                                      [](double time, float key) { return time < static_cast<double>(key); });
  const auto keys_before = static_cast<size_t>(after - channel.times.begin());
  const bool inside = keys_before > 0 && keys_before < channel.times.size();
  const glm::vec4 value = inside ? between_keys(channel, keys_before - 1, seconds)
                                 : key_value(channel, keys_before > 0 ? keys_before - 1 : 0);
  return channel.path == Path::rotation ? unit_rotation(value) : value;
}

}  // namespace crsh::scene
