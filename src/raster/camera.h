#pragma once
// The camera: where it is, and what it sees.

#include <cstdint>
#include <glm/glm.hpp>
#include <optional>

#include "crsh/options.h"
#include "scene/scene.h"

namespace crsh::raster {

struct ImageSize {
  uint32_t width = 0, height = 0;
};

/// In the drawn world (scene::Scene::origin); metres. `right`, `up` and `forward` are unit vectors at right angles.
struct CameraView {
  glm::vec3 eye{0}, right{1, 0, 0}, up{0, 1, 0}, forward{0, 0, -1};
  bool orthographic = false;
  float half_width = 1, half_height = 1;  ///< of the image: at distance 1 (perspective), or in metres (orthographic)
  float near_plane = 0.01f;
  float far_plane = 1;  ///< nothing farther is seen; orthographic: else behind all of the scene; perspective: else 0

  /// OpenEXR's worldToCamera: left-handed, x to the right, y up, z the way the camera looks. A column-major matrix for
  /// column vectors has the same sixteen floats in memory as Imath's for row vectors.
  [[nodiscard]] glm::mat4 world_to_camera() const;
  /// OpenEXR's worldToNDC: after division by w, (0,0) is the upper left corner of the image and (1,1) the lower right.
  [[nodiscard]] glm::mat4 world_to_ndc() const;
};

/// The cone of a pixel, by which textures are filtered: how wide it is at the eye, and how much wider it gets in a
/// metre.
struct PixelCone {
  float width = 0, spread = 0;
};
[[nodiscard]] PixelCone pixel_cone(const CameraView& view, ImageSize size);

/// The image's size: as the options say, else as wide as the camera's aspect asks for (4:3 where it has none).
[[nodiscard]] ImageSize image_size(const scene::Scene& scene, const RenderOptions& options);

/// The camera of this pose: --eye and --target, else --camera, else the file's first, else one that frames `bounds`,
/// the scene's at time 0: the nearest corner is a twentieth of the image from its border. --fov or --orthographic go
/// with any of them. The image's aspect widens or narrows the view, its height stays. Throws UserError for a camera
/// that the file has not.
[[nodiscard]] CameraView camera_view(const scene::Scene& scene, const scene::Pose& pose, const RenderOptions& options,
                                     const scene::Bounds& bounds, ImageSize size);

/// Where camera_view() has chosen eye or target itself: both as options that say the same, to the last bit, in the
/// file's coordinates. Else none.
[[nodiscard]] std::optional<ViewOption> chosen_view(const scene::Scene& scene, const RenderOptions& options,
                                                    const scene::Bounds& bounds, ImageSize size);

}  // namespace crsh::raster
