#pragma once
// What of a scene is drawn in another way than glTF means it.

#include <string>
#include <vector>

#include "scene/scene.h"

namespace crsh::scene {

/// A short clause each, with the number of materials that it is about; only of materials that something is made of.
[[nodiscard]] std::vector<std::string> approximated(const Scene& scene);

}  // namespace crsh::scene
