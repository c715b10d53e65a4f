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

/// Looks at `pivot` from `distance` metres, in the drawn world (scene::Scene::origin). Angles in radians; with both
/// 0 it stands at the front (+Z in glTF). An orthographic camera shows as much of the plane through the pivot as in
/// perspective, and stands at `stand_off`.
struct OrbitCamera {
  glm::vec3 pivot{0};
  float distance = 1, yaw = 0, pitch = 0;
  float roll = 0;                   ///< about the line of sight
  float half_height = 0.41421356f;  ///< of the image at distance 1
  bool orthographic = false;
  float stand_off = 1;  ///< orthographic: metres from the pivot to the eye; nothing nearer is seen
  glm::mat3 basis{1};   ///< right, up and back where all angles are 0

  [[nodiscard]] glm::vec3 back() const;
  [[nodiscard]] glm::vec3 right() const;
  [[nodiscard]] glm::vec3 up() const;
  [[nodiscard]] glm::vec3 eye() const { return pivot + back() * (orthographic ? stand_off : distance); }
  /// The options that render this view, but for the world that its places are in.
  [[nodiscard]] ViewOption view() const;
  /// The line of sight through a point of the image, -1..1 an axis, y up. Its direction is a unit vector.
  [[nodiscard]] Sight sight(glm::vec2 place, float aspect) const;

  /// Turns around the pivot; `by` in shares of the image's height.
  void orbit(glm::vec2 by);
  /// Moves the plane through the pivot with the cursor; `by` in shares of the image's height.
  void pan(glm::vec2 by);
  /// Multiplies the distance by `factor`; what is seen at `place` (-1..1, y up) in the pivot's plane stays there.
  void zoom(float factor, glm::vec2 place, float aspect);
  /// Moves by metres to the right, up and forward; orthographic, forward enlarges the picture.
  void fly(glm::vec3 by);
  /// Makes `point` the pivot. In perspective the eye stays and turns there; orthographic, it moves there and does not
  /// turn.
  void look_at(glm::vec3 point);
  /// Looks from these angles, upright.
  void turn_to(float new_yaw, float new_pitch);
  /// Brings the whole of `bounds` into view, seen from the same side.
  void frame(const scene::Bounds& bounds, float aspect);
  /// Changes from perspective to orthographic, where the eye stands in front of all of `bounds`, or back. What lies in
  /// the pivot's plane looks the same.
  void change_projection(const scene::Bounds& bounds);
};

/// The camera that sees what `view` sees, with its pivot `distance` metres in front. `up` stays upright.
[[nodiscard]] OrbitCamera orbit_of(const raster::CameraView& view, float distance, glm::vec3 up);

}  // namespace crsh::viewer
