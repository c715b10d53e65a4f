#pragma once
// The eye as a person moves it: around a pivot, or flying.

#include <glm/glm.hpp>

#include "crsh/options.h"
#include "raster/camera.h"
#include "scene/scene.h"

namespace crsh::viewer {

/// A line of sight.
struct Sight {
  glm::vec3 origin, direction;
};

/// Looks at `pivot` from `distance` metres. Angles in radians; at 0 and 0 it stands at the front (+Z in glTF).
/// Orthographic, it shows of the pivot's plane what it would in perspective, and stands apart.
struct OrbitCamera {
  glm::vec3 pivot{0};
  float distance = 1, yaw = 0, pitch = 0;
  float roll = 0;                   ///< about the line of sight
  float half_height = 0.41421356f;  ///< of the image at distance 1
  bool orthographic = false;
  float stand_off = 1;  ///< orthographic: metres from the pivot to the eye, where the picture begins
  glm::mat3 basis{1};   ///< right, up and back at no turn

  [[nodiscard]] glm::vec3 back() const;
  [[nodiscard]] glm::vec3 right() const;
  [[nodiscard]] glm::vec3 up() const;
  [[nodiscard]] glm::vec3 eye() const { return pivot + back() * (orthographic ? stand_off : distance); }
  /// The options that render this view.
  [[nodiscard]] ViewOption view() const;
  /// Through a point of the image, -1..1 an axis, y up; a unit direction.
  [[nodiscard]] Sight sight(glm::vec2 place, float aspect) const;

  /// Shares of the image's height.
  void orbit(glm::vec2 by);
  /// The pivot's plane moves with the cursor: shares of the image's height.
  void pan(glm::vec2 by);
  /// Distance times `factor`; what lies at `place` (-1..1, y up) in the pivot's plane stays there.
  void zoom(float factor, glm::vec2 place, float aspect);
  /// Metres to the right, up and forward; orthographic, forward is nearer.
  void fly(glm::vec3 by);
  /// Turns towards a new pivot in place, and the eye stays; orthographic, the eye moves there and the direction stays.
  void look_at(glm::vec3 point);
  /// Upright.
  void turn_to(float new_yaw, float new_pitch);
  /// The whole of `bounds` comes into view, seen from the same side.
  void frame(const scene::Bounds& bounds, float aspect);
  /// Perspective becomes orthographic, from before all of `bounds`, and back. The pivot's plane looks the same.
  void change_projection(const scene::Bounds& bounds);
};

/// From where `view` stands, as it looks; the pivot at `distance` before it. `up` is what stays upright.
[[nodiscard]] OrbitCamera orbit_of(const raster::CameraView& view, float distance, glm::vec3 up);

}  // namespace crsh::viewer
