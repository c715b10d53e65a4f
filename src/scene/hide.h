#pragma once
// Objects that are left out of a scene (--hide).

#include <span>
#include <string>
#include <vector>

#include "scene/scene.h"

namespace crsh::scene {

/// For each instance, whether one of these words means it. A word is an index into Scene::instances, else the name of
/// nodes, which means all below them, too. Throws UserError for a word that means none.
[[nodiscard]] std::vector<bool> hidden_instances(const Scene& scene, std::span<const std::string> words);

/// Removes these instances from the scene.
void hide(Scene& scene, std::span<const std::string> words);

}  // namespace crsh::scene
