#pragma once
// Objects that are left out of a scene (--hide).

#include <span>
#include <string>
#include <vector>

#include "scene/scene.h"

namespace crsh::scene {

/// Which instances these words mean: an index into Scene::instances, else the name of nodes, with all below them.
/// Throws UserError for a word that means none.
[[nodiscard]] std::vector<bool> hidden_instances(const Scene& scene, std::span<const std::string> words);

/// Takes them out of the scene.
void hide(Scene& scene, std::span<const std::string> words);

}  // namespace crsh::scene
