// The viewer's camera: what each movement promises.

#include <doctest/doctest.h>

#include <cmath>

#include "viewer/camera.h"
#include "viewer/pace.h"

namespace crsh::viewer {
namespace {

constexpr float aspect = 1.5f;

OrbitCamera camera() {
  OrbitCamera made;
  made.pivot = {1, 2, 3};
  made.distance = 5;
  made.yaw = 0.4f;
  made.pitch = 0.3f;
  return made;
}

void check_near(glm::vec3 a, glm::vec3 b) {
  CAPTURE(glm::distance(a, b));
  CHECK(glm::distance(a, b) < 1e-4f);
}

/// Where a point of the world is in the image, -1..1.
glm::vec2 image_of(const OrbitCamera& c, glm::vec3 point) {
  const glm::vec3 from = point - c.eye();
  const float depth = c.orthographic ? c.distance : -glm::dot(from, c.back());
  return glm::vec2(glm::dot(from, c.right()) / aspect, glm::dot(from, c.up())) / (depth * c.half_height);
}

TEST_CASE("an orbit keeps the pivot and the distance, and a drag there and back changes nothing") {
  OrbitCamera c = camera();
  const glm::vec3 before = c.eye();
  c.orbit({0.2f, -0.1f});
  CHECK(glm::distance(c.eye(), c.pivot) == doctest::Approx(5));
  CHECK(glm::distance(c.eye(), before) > 0.5f);
  c.orbit({-0.2f, 0.1f});
  check_near(c.eye(), before);
}

TEST_CASE("an orbit stops above and below") {
  OrbitCamera c = camera();
  c.orbit({0, 100});
  check_near(c.back(), {0, 1, 0});
  CHECK(std::isfinite(c.view().up.x));
  CHECK(std::abs(glm::dot(c.view().up, c.back())) < 1e-4f);
}

TEST_CASE("a zoom keeps what is under the cursor") {
  const glm::vec2 place(0.5f, -0.25f);
  for (const bool orthographic : {false, true}) {
    OrbitCamera c = camera();
    c.orthographic = orthographic;
    const Sight sight = c.sight(place, aspect);
    const glm::vec3 point = sight.origin + sight.direction * (glm::dot(sight.origin - c.pivot, c.back()) /
                                                              -glm::dot(sight.direction, c.back()));
    const glm::vec3 eye = c.eye();
    c.zoom(0.5f, place, aspect);
    CHECK(c.distance == doctest::Approx(2.5f));
    CHECK(glm::distance(image_of(c, point), place) < 1e-4f);
    if (orthographic) CHECK(glm::dot(c.eye() - eye, c.back()) == doctest::Approx(0));  // nothing is cut off by it
  }
}

TEST_CASE("a pan moves the pivot's plane with the cursor") {
  OrbitCamera c = camera();
  const glm::vec3 point = c.pivot;
  c.pan({0.25f, 0});  // a quarter of the image's height
  CHECK(image_of(c, point).x * aspect == doctest::Approx(0.5f));
}

TEST_CASE("a new pivot comes to the middle, and the eye stays") {
  OrbitCamera c = camera();
  const glm::vec3 eye = c.eye(), point(0.5f, 2.5f, 1);
  c.look_at(point);
  check_near(c.eye(), eye);
  CHECK(glm::length(image_of(c, point)) < 1e-4f);
}

TEST_CASE("a framed scene is in view as a whole") {
  for (const float wide : {0.5f, 1.0f, 2.0f}) {
    OrbitCamera c = camera();
    c.frame({{-1, -1, -1}, {3, 2, 1}}, wide);
    for (int corner = 0; corner < 8; ++corner) {
      const glm::vec3 from = glm::vec3(corner & 1 ? 3 : -1, corner & 2 ? 2 : -1, corner & 4 ? 1 : -1) - c.eye();
      const float depth = -glm::dot(from, c.back());
      CHECK(std::abs(glm::dot(from, c.right())) <= depth * c.half_height * wide * 1.001f);
      CHECK(std::abs(glm::dot(from, c.up())) <= depth * c.half_height * 1.001f);
    }
  }
}

TEST_CASE("front, right and top look along the axes") {
  OrbitCamera c = camera();
  c.turn_to(0, 0);
  check_near(c.back(), {0, 0, 1});
  c.turn_to(1.5707963f, 0);
  check_near(c.back(), {1, 0, 0});
  c.turn_to(0, 1.5707963f);
  check_near(c.back(), {0, 1, 0});
  check_near(c.up(), {0, 0, -1});
}

TEST_CASE("taking over a camera shows what it showed") {
  raster::CameraView view;
  view.forward = glm::normalize(glm::vec3(-1, -0.5f, -2));
  view.right = glm::normalize(glm::cross(view.forward, glm::vec3(0, 1, 0)));
  view.up = glm::cross(view.right, view.forward);
  view.eye = {3, 4, 5};
  view.half_height = 0.7f;
  const OrbitCamera c = orbit_of(view, 2, {0, 1, 0});
  check_near(c.eye(), view.eye);
  check_near(-c.back(), view.forward);
  check_near(c.right(), view.right);
  CHECK(c.half_height == 0.7f);
}

/// A camera of a file, turned about its line of sight.
raster::CameraView rolled_view(float roll) {
  raster::CameraView view;
  view.eye = {3, 4, 5};
  view.forward = glm::normalize(glm::vec3(-1, -0.5f, -2));
  const glm::vec3 level = glm::normalize(glm::cross(view.forward, glm::vec3(0, 1, 0)));
  view.right = level * std::cos(roll) + glm::cross(level, view.forward) * std::sin(roll);
  view.up = glm::cross(view.right, view.forward);
  return view;
}

TEST_CASE("taking over a tilted camera keeps the tilt, in the options too, and drags go with the picture") {
  for (const float roll : {-2.0f, 0.3f, 3.0f}) {
    const raster::CameraView view = rolled_view(roll);
    OrbitCamera c = orbit_of(view, 2, {0, 1, 0});
    check_near(c.right(), view.right);
    check_near(c.up(), view.up);
    RenderOptions options;
    options.view = c.view();
    const raster::CameraView again = raster::camera_view({}, {}, options, {}, {300, 200});
    check_near(again.right, view.right);
    check_near(again.up, view.up);
    const glm::vec3 point = c.pivot + c.back() * 0.1f;  // nearer than the pivot: it follows the cursor
    c.orbit({0.01f, 0});
    const glm::vec2 moved = image_of(c, point);
    CHECK(moved.x > 0);
    CHECK(std::abs(moved.y) < 0.3f * moved.x);  // a turntable turns about what is upright, not about the picture's up
    c.turn_to(0, 0);
    check_near(c.up(), {0, 1, 0});
  }
}

TEST_CASE("taking over an orthographic camera shows what it showed, in the options too") {
  raster::CameraView view = rolled_view(0);
  view.orthographic = true;
  view.half_height = 0.75f;
  const OrbitCamera c = orbit_of(view, 4, {0, 1, 0});
  RenderOptions options;
  options.view = c.view();
  const raster::CameraView again = raster::camera_view({}, {}, options, {}, {300, 200});
  CHECK(again.orthographic);
  CHECK(again.half_height == doctest::Approx(0.75f));
  CHECK(again.half_width == doctest::Approx(0.75f * aspect));
  check_near(again.eye, view.eye);
  check_near(again.right, view.right);
}

TEST_CASE("a change of projection keeps the pivot's plane, and begins before the whole scene") {
  const scene::Bounds bounds{{-10, -10, -10}, {10, 10, 10}};
  OrbitCamera c = camera();
  const glm::vec3 eye = c.eye(), point = c.pivot + c.up() * 0.5f - c.right() * 0.25f;
  const glm::vec2 before = image_of(c, point);
  c.change_projection(bounds);
  CHECK(c.orthographic);
  CHECK(glm::distance(image_of(c, point), before) < 1e-4f);
  for (int corner = 0; corner < 8; ++corner)
    CHECK(glm::dot(glm::vec3(corner & 1 ? 10 : -10, corner & 2 ? 10 : -10, corner & 4 ? 10 : -10) - c.eye(),
                   c.back()) <= 0);
  c.change_projection(bounds);
  check_near(c.eye(), eye);
}

TEST_CASE("an orthographic camera sees all of a framed scene, and what is double clicked comes to the middle") {
  OrbitCamera c = camera();
  c.change_projection({});
  c.frame({{-1, -1, -1}, {3, 2, 1}}, aspect);
  for (int corner = 0; corner < 8; ++corner) {
    const glm::vec2 place = image_of(c, glm::vec3(corner & 1 ? 3 : -1, corner & 2 ? 2 : -1, corner & 4 ? 1 : -1));
    CHECK(std::max(std::abs(place.x), std::abs(place.y)) < 1);
  }
  const glm::vec3 back = c.back(), point = c.pivot + c.up() * 0.5f;
  c.look_at(point);
  check_near(c.back(), back);
  CHECK(glm::length(image_of(c, point)) < 1e-4f);
}

TEST_CASE("the pace keeps to the budget where it can, and does not flicker") {
  Pace pace;
  const raster::ImageSize full{1000, 800};
  raster::ImageSize size;
  const auto cost = [&] { return 5 + 400.0 * size.width * size.height / (1000.0 * 800); };
  for (int frame = 0; frame < 10; ++frame) pace.measured(size = pace.size(full, 50), full, cost());
  CHECK(cost() <= 50);
  const raster::ImageSize settled = size;
  for (int frame = 0; frame < 10; ++frame) {
    pace.measured(size = pace.size(full, 50), full, cost());
    CHECK(size.width == settled.width);
  }
  for (int frame = 0; frame < 10; ++frame) pace.measured(size = pace.size(full, 2000), full, cost());
  CHECK(size.width == 1000);
  CHECK(Pace().size({1, 1}, 50).width == 1);
}

}  // namespace
}  // namespace crsh::viewer
