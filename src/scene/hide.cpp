#include "scene/hide.h"

#include <fmt/format.h>

#include <charconv>

#include "crsh/error.h"

namespace crsh::scene {
namespace {

std::optional<size_t> as_index(const std::string& word) {
  size_t index = 0;
  const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), index);
  if (error != std::errc{} || end != word.data() + word.size()) return std::nullopt;
  return index;
}

bool is_below(const Scene& scene, uint32_t node, const std::string& name) {
  for (std::optional<uint32_t> at = node; at; at = scene.nodes[*at].parent)
    if (scene.nodes[*at].name == name) return true;
  return false;
}

/// Returns whether there is any.
bool hide_named(const Scene& scene, const std::string& name, std::vector<bool>& hidden) {
  bool found = false;
  for (size_t i = 0; i < scene.instances.size(); ++i)
    if (is_below(scene, scene.instances[i].node, name)) hidden[i] = found = true;
  return found;
}

}  // namespace

std::vector<bool> hidden_instances(const Scene& scene, std::span<const std::string> words) {
  std::vector<bool> hidden(scene.instances.size());
  for (const std::string& word : words) {
    const std::optional<size_t> index = as_index(word);
    if (index && *index < hidden.size()) hidden[*index] = true;
    else if (!hide_named(scene, word, hidden))
      throw UserError(fmt::format("{}: no object to hide is called '{}', and there are {}, from 0 on",
                                  scene.path.string(), word, hidden.size()),
                      Mend::known_object);
  }
  return hidden;
}

void hide(Scene& scene, std::span<const std::string> words) {
  const std::vector<bool> hidden = hidden_instances(scene, words);
  std::vector<Instance> left;
  for (size_t i = 0; i < hidden.size(); ++i)
    if (!hidden[i]) left.push_back(scene.instances[i]);
  scene.instances = std::move(left);
}

}  // namespace crsh::scene
