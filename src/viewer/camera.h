#pragma once
// The eye as a person moves it: around a pivot, or flying.

#include <glm/glm.hpp>

#include "frame/options.h"
#include "raster/camera.h"
#include "scene/scene.h"

namespace crsh::viewer {

/// Looks at `pivot` from `distance` metres. Angles in radians; at 0 and 0 it stands at the front (+Z in glTF).
struct OrbitCamera {
  glm::vec3 pivot{0};
  float distance = 1, yaw = 0, pitch = 0;
  float half_height = 0.41421356f;  ///< of the image at distance 1
  glm::mat3 basis{1};               ///< right, up and back at no turn

  [[nodiscard]] glm::vec3 back() const;
  [[nodiscard]] glm::vec3 right() const;
  [[nodiscard]] glm::vec3 up() const;
  [[nodiscard]] glm::vec3 eye() const { return pivot + back() * distance; }
  /// The options that render this view.
  [[nodiscard]] ViewOption view() const;
  /// Unit direction through a point of the image, -1..1 an axis, y up.
  [[nodiscard]] glm::vec3 direction(glm::vec2 place, float aspect) const;

  /// Shares of the image's height.
  void orbit(glm::vec2 by);
  /// The pivot's plane moves with the cursor: shares of the image's height.
  void pan(glm::vec2 by);
  /// Distance times `factor`; what lies at `place` (-1..1, y up) in the pivot's plane stays there.
  void zoom(float factor, glm::vec2 place, float aspect);
  /// Metres to the right, up and forward.
  void fly(glm::vec3 by);
  /// Turns towards a new pivot in place; the eye stays.
  void look_at(glm::vec3 point);
  void turn_to(float new_yaw, float new_pitch);
  /// The whole of `bounds` comes into view, seen from the same side.
  void frame(const scene::Bounds& bounds, float aspect);
};

/// From where `view` stands; the pivot at `distance` before it. `up` is what stays upright.
[[nodiscard]] OrbitCamera orbit_of(const raster::CameraView& view, float distance, glm::vec3 up);

}  // namespace crsh::viewer
