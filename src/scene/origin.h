#pragma once
// Scenes far from the file's own origin. Floats tell places there apart by centimetres or worse, and rays leave
// surfaces by a share of their coordinates (shaders/lib/offset.glsl): at 100 km by more than a metre. Such a scene is
// drawn around an origin of its own, in the file's coordinates a round number.

#include "scene/scene.h"

namespace crsh::scene {

/// Where a world that holds `bounds` is to have its origin: zero where their middle is no farther than four times their
/// longest edge from it on any axis, else on each axis the roundest number that they hold or nearly hold: the
/// multiple of the largest power of two. So what is moved by a round number is drawn as if it had not been moved.
[[nodiscard]] glm::dvec3 origin_for(const Bounds& bounds);

/// Chooses `scene.origin` for its geometry at time 0 of the first animation, and an origin of their own for meshes
/// whose positions are far off for the scene's size. Where all is near, nodes keep no more than floats of the file's
/// numbers. To be called once, of a scene as read.
void choose_origin(Scene& scene);

}  // namespace crsh::scene
