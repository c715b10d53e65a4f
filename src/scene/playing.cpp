#include "scene/playing.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <numeric>
#include <set>

#include "crsh/error.h"

namespace crsh::scene {
namespace {

constexpr size_t max_names = 8;  // of a line

std::string names_of(const Scene& scene, const std::vector<uint32_t>& animations) {
  std::vector<std::string> names;
  for (size_t i = 0; i < std::min(animations.size(), max_names); ++i) {
    const std::string& name = scene.animations[animations[i]].name;
    names.push_back(name.empty() ? std::to_string(animations[i]) : fmt::format("'{}'", name));
  }
  return fmt::format("{}{}", fmt::join(names, ", "), animations.size() > max_names ? ", ..." : "");
}

std::vector<uint32_t> all_of(const Scene& scene) {
  std::vector<uint32_t> all(scene.animations.size());
  std::iota(all.begin(), all.end(), 0u);
  return all;
}

/// Takes the animation's targets where none of them is taken yet.
bool takes(const Animation& animation, std::set<Target>& taken) {
  const auto is_taken = [&](const Channel& channel) { return taken.contains(channel.target); };
  if (std::ranges::any_of(animation.channels, is_taken)) return false;
  for (const Channel& channel : animation.channels) taken.insert(channel.target);
  return true;
}

Playing chosen(const Scene& scene) {
  Playing out;
  std::set<Target> taken;
  std::vector<uint32_t> moving, left;
  for (const uint32_t i : all_of(scene)) {
    if (!takes(scene.animations[i], taken)) {
      left.push_back(i);
      continue;
    }
    out.animations.push_back(i);
    if (!scene.animations[i].channels.empty()) moving.push_back(i);
  }
  if (!left.empty())
    out.note = fmt::format("animations that play: {}; left out, because they move the same: {}",
                           names_of(scene, moving), names_of(scene, left));
  else if (moving.size() > 1)
    out.note = fmt::format("{} animations play together: {}", moving.size(), names_of(scene, moving));
  return out;
}

}  // namespace

Playing playing(const Scene& scene, const std::string& which) {
  if (which.empty()) return chosen(scene);
  for (uint32_t i = 0; i < scene.animations.size(); ++i)
    if (scene.animations[i].name == which || std::to_string(i) == which) return {{i}, {}};
  if (which == "all") return {all_of(scene), {}};
  std::string names;
  for (const Animation& animation : scene.animations) names += " '" + animation.name + "'";
  throw UserError(fmt::format("{}: has no animation '{}'; it has {}:{}", scene.path.string(), which,
                              scene.animations.size(), names.empty() ? " none" : names));
}

float duration(const Scene& scene, const std::vector<uint32_t>& animations) {
  float longest = 0;
  for (const uint32_t i : animations) longest = std::max(longest, scene.animations[i].duration);
  return longest;
}

}  // namespace crsh::scene
