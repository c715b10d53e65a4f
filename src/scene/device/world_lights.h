#pragma once
// Lights in the drawn world, as shaders see them.

#include <span>
#include <vector>

#include "crsh/options.h"
#include "scene/scene.h"
#include "shared/scene.h"

namespace crsh::scene {

/// The lights of a run, the same for all its frames.
struct LightRig {
  std::vector<shared::Light> fixed;  ///< from the options, or the default light; empty: the file's, which nodes carry
  /// Lights whose intensity or place was chosen here, as options for the same, in the file's coordinates.
  std::vector<LightOption> chosen;
};

/// Where the eye is and what it calls right and up, for the light of a scene that has none.
struct Viewpoint {
  glm::vec3 eye{0}, right{1, 0, 0}, up{0, 1, 0};
};

/// `bounds`: the scene's at time 0. A light of the options without intensity gets π·d² ÷ their number candela, d from
/// the centre of the bounds. Where neither the options nor the file have lights, one hangs beside the viewpoint,
/// and shines past backs.
[[nodiscard]] LightRig resolve_lights(const Scene& scene, std::span<const LightOption> options, const Bounds& bounds,
                                      const Viewpoint& viewpoint);

/// The rig's lights in this pose. `bounds` hold all geometry: a directional light's rays start outside of them.
[[nodiscard]] std::vector<shared::Light> world_lights(const Scene& scene, const Pose& pose, const LightRig& rig,
                                                      const Bounds& bounds);

}  // namespace crsh::scene
