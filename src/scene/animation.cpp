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

/// Whether a frame at `seconds` shows the key. Files keep the times of keys as floats: frame N at F a second is N ÷ F,
/// rounded, or N times 1 ÷ F, rounded twice. A frame at N ÷ F shows either, so a key counts as reached two units in its
/// last place early.
bool reached(float key, double seconds) {
  constexpr double slack = 1.0 / (1 << 22);
  return static_cast<double>(key) - std::abs(static_cast<double>(key)) * slack <= seconds;
}

bool is_rotation(const Target& target) { return target.driven == Driven::node && target.property == node_rotation; }

glm::vec4 quaternion(std::span<const float> v) { return {v[0], v[1], v[2], v[3]}; }

std::vector<float> numbers(const glm::vec4& v) { return {v.x, v.y, v.z, v.w}; }

/// Value `i` of the list; a cubic spline has three a key.
std::span<const float> value(const Channel& channel, size_t i) {
  return std::span(channel.values).subspan(i * channel.width, channel.width);
}

std::span<const float> key_value(const Channel& channel, size_t k) {
  return value(channel, channel.interpolation == Interpolation::cubic_spline ? 3 * k + 1 : k);
}

/// Hermite spline (glTF 2.0, appendix C.5) between keys k and k + 1, `span` seconds apart.
std::vector<float> spline(const Channel& channel, size_t k, float t, float span) {
  const auto from = value(channel, 3 * k + 1), leaving = value(channel, 3 * k + 2),
             arriving = value(channel, 3 * k + 3), to = value(channel, 3 * k + 4);
  const float t2 = t * t, t3 = t2 * t;
  std::vector<float> out(channel.width);
  for (size_t i = 0; i < out.size(); ++i)
    out[i] = from[i] * (2 * t3 - 3 * t2 + 1) + leaving[i] * (span * (t3 - 2 * t2 + t)) + to[i] * (3 * t2 - 2 * t3) +
             arriving[i] * (span * (t3 - t2));
  return out;
}

std::vector<float> between_keys(const Channel& channel, size_t k, double seconds) {
  const double first = channel.times[k], span = channel.times[k + 1] - first;
  const auto t = std::max(static_cast<float>((seconds - first) / span), 0.0f);
  const auto from = key_value(channel, k), to = key_value(channel, k + 1);
  if (channel.interpolation == Interpolation::step) return {from.begin(), from.end()};
  if (channel.interpolation == Interpolation::cubic_spline) return spline(channel, k, t, static_cast<float>(span));
  if (is_rotation(channel.target))
    return numbers(slerp(unit_rotation(quaternion(from)), unit_rotation(quaternion(to)), t));
  std::vector<float> out(channel.width);
  for (size_t i = 0; i < out.size(); ++i) out[i] = glm::mix(from[i], to[i], t);
  return out;
}

/// Sets a property of one element of a list; what is changed is a copy.
template <class Object, class Table>
void change(const Table& table, const std::vector<Object>& list, std::map<uint32_t, Object>& changed,
            const Target& target, std::span<const float> numbers) {
  const auto place = changed.try_emplace(target.object, list[target.object]).first;
  table[target.property].set(place->second, numbers);
}

void apply(const Scene& scene, const Channel& channel, double seconds, Animated& out) {
  const Target& target = channel.target;
  const std::vector<float> now = sample(channel, seconds);
  switch (target.driven) {
    case Driven::node: return node_properties[target.property].set(out.nodes[target.object], now);
    case Driven::light: return change(light_properties, scene.lights, out.changes.lights, target, now);
    case Driven::camera: return change(camera_properties, scene.cameras, out.changes.cameras, target, now);
    case Driven::material: return change(material_properties, scene.materials, out.changes.materials, target, now);
  }
}

}  // namespace

std::vector<float> sample(const Channel& channel, double seconds) {
  const auto after = std::upper_bound(channel.times.begin(), channel.times.end(), seconds,
                                      [](double time, float key) { return !reached(key, time); });
  const auto keys_before = static_cast<size_t>(after - channel.times.begin());
  const bool inside = keys_before > 0 && keys_before < channel.times.size();
  std::vector<float> now;
  if (inside) {
    now = between_keys(channel, keys_before - 1, seconds);
  } else {
    const auto key = key_value(channel, keys_before > 0 ? keys_before - 1 : 0);
    now.assign(key.begin(), key.end());
  }
  return is_rotation(channel.target) ? numbers(unit_rotation(quaternion(now))) : now;
}

Animated animated(const Scene& scene, double seconds, const std::vector<uint32_t>& animations) {
  Animated out;
  out.nodes.reserve(scene.nodes.size());
  for (const Node& node : scene.nodes) out.nodes.push_back({node.transform, node.weights, node.visible});
  for (const uint32_t animation : animations)
    for (const Channel& channel : scene.animations.at(animation).channels) apply(scene, channel, seconds, out);
  return out;
}

}  // namespace crsh::scene
