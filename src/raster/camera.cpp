#include "raster/camera.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <span>

#include "crsh/error.h"

namespace crsh::raster {
namespace {

constexpr float default_fov = float(std::numbers::pi) / 4;
constexpr float default_aspect = 4.0f / 3;
/// Where the default camera stands, seen from the middle of the scene.
constexpr glm::vec3 default_side{0.5f, 0.4f, 1.0f};
constexpr float near_share = 1e-4f;  ///< of the scene's size
/// Of the image, that the scene's bounds take up where the camera is chosen: a twentieth is left at either border.
constexpr float framed_share = 0.9f;

struct Extent {
  glm::vec3 centre{0};
  float radius = 1;
};

Extent extent_of(const scene::Bounds& bounds) {
  if (bounds.empty()) return {};
  const float radius = glm::length(bounds.high - bounds.low) * 0.5f;
  return {(bounds.low + bounds.high) * 0.5f, radius > 0 ? radius : 1.0f};
}

std::optional<uint32_t> as_index(const std::string& text) {
  uint32_t index = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), index);
  if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
  return index;
}

std::string camera_list(const scene::Scene& scene) {
  if (scene.cameras.empty()) return "it has none";
  std::string list = "it has";
  for (size_t i = 0; i < scene.cameras.size(); ++i)
    list += fmt::format("{} {} ({})", i ? "," : "", i, scene.cameras[i].name);
  return list;
}

/// --camera by name or index, else the first; none where --eye or --target place one.
std::optional<uint32_t> chosen_camera(const scene::Scene& scene, const RenderOptions& options) {
  if (options.view.eye || options.view.target) return std::nullopt;
  if (options.camera.empty()) return scene.cameras.empty() ? std::nullopt : std::optional<uint32_t>(0);
  for (uint32_t i = 0; i < scene.cameras.size(); ++i)
    if (scene.cameras[i].name == options.camera) return i;
  const std::optional<uint32_t> index = as_index(options.camera);
  if (index && *index < scene.cameras.size()) return index;
  throw UserError(fmt::format("{}: no camera \"{}\": {}", scene.path.string(), options.camera, camera_list(scene)));
}

float aspect_of(const scene::Camera& camera) {
  const float aspect = camera.orthographic ? camera.xmag / camera.ymag : camera.aspect.value_or(default_aspect);
  return std::isfinite(aspect) && aspect > 0 ? std::clamp(aspect, 1e-3f, 1e3f) : default_aspect;
}

glm::vec3 unit_or(glm::vec3 v, glm::vec3 otherwise) {
  const float length = glm::length(v);
  return length > 0 && std::isfinite(length) ? v / length : otherwise;
}

/// Any unit vector at right angles to `forward`.
glm::vec3 some_side(glm::vec3 forward) {
  const glm::vec3 axis = std::abs(forward.y) < 0.9f ? glm::vec3(0, 1, 0) : glm::vec3(0, 0, -1);
  return glm::normalize(glm::cross(forward, axis));
}

void look(CameraView& view, glm::vec3 forward, glm::vec3 up) {
  view.forward = unit_or(forward, glm::vec3(0, 0, -1));
  const glm::vec3 side = glm::cross(view.forward, unit_or(up, glm::vec3(0, 1, 0)));
  view.right = glm::length(side) > 1e-6f ? glm::normalize(side) : some_side(view.forward);
  view.up = glm::cross(view.right, view.forward);
}

void set_fov(CameraView& view, float fov) { view.half_height = std::tan(std::clamp(fov, 1e-3f, 3.1f) / 2); }

void see_through(CameraView& view, const scene::Camera& camera, const glm::mat4& transform) {
  view.eye = glm::vec3(transform[3]);
  look(view, -glm::vec3(transform[2]), glm::vec3(transform[1]));
  // A mirrored node would mirror the picture; look() keeps x to the right, as viewers do.
  view.orthographic = camera.orthographic;
  if (camera.orthographic) view.half_height = std::abs(camera.ymag);
  else set_fov(view, camera.yfov);
  view.near_plane = camera.orthographic ? camera.near_plane : std::max(camera.near_plane, 1e-6f);
}

/// Far enough that a sphere around the target fills the narrower side of the image.
float framing_distance(const CameraView& view, float aspect, float radius) {
  const float narrow = std::atan(view.half_height * std::min(aspect, 1.0f));
  return 1.02f * radius / std::sin(narrow);
}

std::array<glm::vec3, 8> corners_of(const scene::Bounds& bounds, const Extent& extent) {
  const scene::Bounds none{extent.centre - glm::vec3(0.5f * extent.radius),
                           extent.centre + glm::vec3(0.5f * extent.radius)};
  const scene::Bounds& box = bounds.longest_edge() > 0 ? bounds : none;
  std::array<glm::vec3, 8> corners;
  for (int i = 0; i < 8; ++i) corners[i] = glm::mix(box.low, box.high, glm::vec3(i & 1, i >> 1 & 1, i >> 2));
  return corners;
}

/// Two planes through the eye, `slope` to either side of where it looks, that hold all corners between them.
/// `sideways`: where the eye stands along the axis from one to the other; `forward`: how far ahead it may stand. Both
/// are seen from the middle of the bounds.
struct Wedge {
  float sideways, forward;
};

Wedge wedge_around(std::span<const glm::vec3> corners, const Extent& extent, glm::vec3 axis, glm::vec3 forward,
                   float slope) {
  float low = std::numeric_limits<float>::infinity(), high = -low;
  for (const glm::vec3& corner : corners) {
    const float across = glm::dot(corner - extent.centre, axis), along = glm::dot(corner - extent.centre, forward);
    low = std::min(low, across + slope * along);
    high = std::max(high, across - slope * along);
  }
  return {(low + high) / 2, (low - high) / (2 * slope)};
}

/// To a thousandth or less of the scene's size, so that the printed option is short.
glm::vec3 rounded(glm::vec3 place, float radius) {
  const double step = std::pow(10.0, std::floor(std::log10(double(radius))) - 3);
  return {float(std::round(place.x / step) * step), float(std::round(place.y / step) * step),
          float(std::round(place.z / step) * step)};
}

struct Placement {
  glm::vec3 eye, target;
};

/// As near as the bounds' corners allow that are to be in the image, seen from default_side.
Placement frame(CameraView view, glm::vec3 up, const scene::Bounds& bounds, const Extent& extent, float aspect) {
  look(view, -default_side, up);
  const std::array<glm::vec3, 8> corners = corners_of(bounds, extent);
  const float slope = framed_share * view.half_height;
  const Wedge wide = wedge_around(corners, extent, view.right, view.forward, slope * aspect),
              high = wedge_around(corners, extent, view.up, view.forward, slope);
  const float forward = std::min(wide.forward, high.forward);
  const glm::vec3 middle = extent.centre + view.right * wide.sideways + view.up * high.sideways;
  return {rounded(middle + view.forward * forward, extent.radius), rounded(middle, extent.radius)};
}

/// What is chosen where the options do not say both eye and target. Parallel lines of sight want the middle of the
/// scene in the middle of the image, however near it is.
Placement chosen_placement(const scene::Scene& scene, const CameraView& view, const ViewOption& option,
                           const scene::Bounds& bounds, float aspect) {
  const Extent extent = extent_of(bounds);
  if (!option.eye && !option.target && !option.orthographic_height)
    return frame(view, option.up, bounds, extent, aspect);
  const glm::vec3 target = option.target ? scene.drawn(*option.target) : extent.centre;
  const glm::vec3 away = glm::normalize(default_side) * framing_distance(view, aspect, extent.radius);
  return {target + away, target};
}

/// The option with both eye and target, in the file's coordinates.
ViewOption completed(const scene::Scene& scene, const CameraView& view, const ViewOption& option,
                     const scene::Bounds& bounds, float aspect) {
  const Placement chosen = chosen_placement(scene, view, option, bounds, aspect);
  ViewOption whole = option;
  if (!whole.eye) whole.eye = scene.in_file(chosen.eye);
  if (!whole.target) whole.target = scene.in_file(chosen.target);
  return whole;
}

CameraView with_fov(const ViewOption& option) {
  CameraView view;
  set_fov(view, option.fov_degrees ? glm::radians(*option.fov_degrees) : default_fov);
  return view;
}

void see_scene(CameraView& view, const scene::Scene& scene, const ViewOption& option, const scene::Bounds& bounds,
               float aspect) {
  view = with_fov(option);
  const ViewOption whole = completed(scene, view, option, bounds, aspect);
  view.eye = scene.drawn(*whole.eye);
  look(view, scene.drawn(*whole.target) - view.eye, option.up);
  view.near_plane = near_share * 2 * extent_of(bounds).radius;
}

/// The camera's own where something may lie beyond: else the depths of what is seen need not depend on it.
float far_plane_of(const scene::Scene& scene, const RenderOptions& options, const CameraView& view,
                   const Extent& extent) {
  const float behind = std::max(view.near_plane, glm::distance(view.eye, extent.centre) + 2 * extent.radius);
  const std::optional<uint32_t> index = chosen_camera(scene, options);
  const std::optional<float> own = index ? scene.cameras[*index].far_plane : std::nullopt;
  if (own && (*own < behind || !scene.animations.empty())) return *own;
  return view.orthographic ? behind * 1.01f + 1e-6f : 0;
}

float aspect_of(ImageSize size) { return float(size.width) / float(size.height); }

}  // namespace

PixelCone pixel_cone(const CameraView& view, ImageSize size) {
  const float pixel = 2 * view.half_height / float(size.height);
  return view.orthographic ? PixelCone{pixel, 0} : PixelCone{0, pixel};
}

ImageSize image_size(const scene::Scene& scene, const RenderOptions& options) {
  if (options.width) return {options.width, options.height};
  const std::optional<uint32_t> camera = chosen_camera(scene, options);
  const float aspect = camera ? aspect_of(scene.cameras[*camera]) : default_aspect;
  return {std::max(uint32_t(std::lround(aspect * float(options.height))), 1u), options.height};
}

CameraView camera_view(const scene::Scene& scene, const scene::Pose& pose, const RenderOptions& options,
                       const scene::Bounds& bounds, ImageSize size) {
  const Extent extent = extent_of(bounds);
  const float aspect = aspect_of(size);
  CameraView view;
  if (const std::optional<uint32_t> index = chosen_camera(scene, options)) {
    see_through(view, scene::changed_or(pose.changes.cameras, scene.cameras, *index), pose.cameras[*index]);
    if (options.view.fov_degrees && !view.orthographic) set_fov(view, glm::radians(*options.view.fov_degrees));
  } else {
    see_scene(view, scene, options.view, bounds, aspect);
  }
  if (options.view.orthographic_height)
    view.orthographic = true, view.half_height = *options.view.orthographic_height / 2;
  view.half_width = view.half_height * aspect;
  view.far_plane = far_plane_of(scene, options, view, extent);
  return view;
}

std::optional<ViewOption> chosen_view(const scene::Scene& scene, const RenderOptions& options,
                                      const scene::Bounds& bounds, ImageSize size) {
  if (chosen_camera(scene, options) || (options.view.eye && options.view.target)) return {};
  return completed(scene, with_fov(options.view), options.view, bounds, aspect_of(size));
}

glm::mat4 CameraView::world_to_camera() const {
  const glm::mat4 rows(glm::vec4(right, -glm::dot(right, eye)), glm::vec4(up, -glm::dot(up, eye)),
                       glm::vec4(forward, -glm::dot(forward, eye)), glm::vec4(0, 0, 0, 1));
  return glm::transpose(rows);
}

glm::mat4 CameraView::world_to_ndc() const {
  const glm::vec4 x(0.5f / half_width, 0, orthographic ? 0 : 0.5f, orthographic ? 0.5f : 0);
  const glm::vec4 y(0, -0.5f / half_height, orthographic ? 0 : 0.5f, orthographic ? 0.5f : 0);
  const glm::vec4 z(0, 0, 1, -near_plane);
  const glm::vec4 w = orthographic ? glm::vec4(0, 0, 0, 1) : glm::vec4(0, 0, 1, 0);
  return glm::transpose(glm::mat4(x, y, z, w)) * world_to_camera();
}

}  // namespace crsh::raster
