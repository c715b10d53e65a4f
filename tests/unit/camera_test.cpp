// What the eye sees: cameras of the file, of the options and of last resort; OpenEXR's matrices; samples in a pixel.

#include <doctest/doctest.h>

#include <cmath>
#include <cstdio>
#include <glm/gtc/matrix_transform.hpp>

#include "cli/mend.h"
#include "crsh/error.h"
#include "raster/camera.h"
#include "raster/jitter.h"

namespace crsh {
namespace {

using raster::camera_view;
using raster::CameraView;

const scene::Bounds box{glm::vec3(-1, 0, -2), glm::vec3(3, 2, 4)};

glm::vec3 ndc(const CameraView& view, glm::vec3 point) {
  const glm::vec4 p = view.world_to_ndc() * glm::vec4(point, 1);
  return glm::vec3(p) / p.w;
}

RenderOptions looking(glm::vec3 eye, glm::vec3 target, float fov) {
  RenderOptions options;
  options.view.eye = eye;
  options.view.target = target;
  options.view.fov_degrees = fov;
  return options;
}

bool near(glm::vec3 a, glm::vec3 b, float tolerance = 1e-5f) { return glm::distance(a, b) < tolerance; }

TEST_CASE("worldToCamera is left-handed: right, up and forward become x, y and z") {
  const CameraView view = camera_view({}, {}, looking({1, 2, 3}, {1, 2, -7}, 60), box, {100, 100});
  const glm::mat4 m = view.world_to_camera();
  CHECK(near(glm::vec3(m * glm::vec4(1, 2, 3, 1)), glm::vec3(0)));
  CHECK(near(glm::vec3(m * glm::vec4(1, 2, 2, 1)), glm::vec3(0, 0, 1)));
  CHECK(near(glm::vec3(m * glm::vec4(2, 2, 3, 1)), glm::vec3(1, 0, 0)));
  CHECK(near(glm::vec3(m * glm::vec4(1, 3, 3, 1)), glm::vec3(0, 1, 0)));
}

TEST_CASE("worldToNDC puts the image's upper left corner at (0,0) and its lower right one at (1,1)") {
  const CameraView view = camera_view({}, {}, looking({0, 0, 0}, {0, 0, -1}, 90), box, {200, 100});
  CHECK(near(ndc(view, {0, 0, -5}), glm::vec3(0.5f, 0.5f, ndc(view, {0, 0, -5}).z)));
  CHECK(glm::distance(glm::vec2(ndc(view, {-10, 5, -5})), glm::vec2(0, 0)) < 1e-5f);
  CHECK(glm::distance(glm::vec2(ndc(view, {10, -5, -5})), glm::vec2(1, 1)) < 1e-5f);
}

TEST_CASE("a file's camera looks along -z of its node, and keeps its height when the image is wider") {
  scene::Scene scene;
  scene::Camera camera;
  camera.yfov = float(M_PI) / 2;
  camera.aspect = 1.0f;
  camera.near_plane = 0.5f;
  scene.cameras = {camera};
  scene::Pose pose;
  pose.cameras = {
      glm::scale(glm::rotate(glm::translate(glm::mat4(1), glm::vec3(1, 2, 3)), float(M_PI) / 2, glm::vec3(0, 1, 0)),
                 glm::vec3(3))};
  const CameraView view = camera_view(scene, pose, {}, box, {300, 100});
  CHECK(near(view.eye, {1, 2, 3}));
  CHECK(near(view.forward, {-1, 0, 0}));
  CHECK(near(view.up, {0, 1, 0}));
  CHECK(view.half_height == doctest::Approx(1));
  CHECK(view.half_width == doctest::Approx(3));
  CHECK(view.near_plane == 0.5f);
}

TEST_CASE("an orthographic camera's extent is its ymag") {
  scene::Scene scene;
  scene::Camera camera;
  camera.orthographic = true;
  camera.xmag = 4;
  camera.ymag = 2;
  scene.cameras = {camera};
  scene::Pose pose;
  pose.cameras = {glm::translate(glm::mat4(1), glm::vec3(0, 0, 10))};
  CHECK(raster::image_size(scene, {}).width == 1024);
  const CameraView view = camera_view(scene, pose, {}, box, {200, 100});
  CHECK(glm::distance(glm::vec2(ndc(view, {4, 2, 0})), glm::vec2(1, 0)) < 1e-5f);
  CHECK(view.far_plane > 12);
}

TEST_CASE("--orthographic makes the lines of any camera parallel, and says how high its image is") {
  RenderOptions options = looking({1, 1, 10}, {1, 1, 0}, 60);
  options.view.fov_degrees.reset();
  options.view.orthographic_height = 3.0f;
  const CameraView own = camera_view({}, {}, options, box, {200, 100});
  CHECK(glm::distance(glm::vec2(ndc(own, {4, 2.5f, 3})), glm::vec2(1, 0)) < 1e-5f);
  CHECK(glm::distance(glm::vec2(ndc(own, {-2, -0.5f, -2})), glm::vec2(0, 1)) < 1e-5f);
  CHECK(own.far_plane > 12);

  scene::Scene scene;
  scene.cameras.resize(1);
  scene::Pose pose;
  pose.cameras = {glm::translate(glm::mat4(1), glm::vec3(0, 0, 10))};
  options.view.eye.reset(), options.view.target.reset();
  const CameraView of_file = camera_view(scene, pose, options, box, {200, 100});
  CHECK(glm::distance(glm::vec2(ndc(of_file, {3, 1.5f, 0})), glm::vec2(1, 0)) < 1e-5f);
}

TEST_CASE("without a camera the whole scene is in the image, whatever its aspect") {
  for (const raster::ImageSize size : {raster::ImageSize{512, 512}, {900, 200}, {100, 700}}) {
    const CameraView view = camera_view({}, {}, {}, box, size);
    for (int corner = 0; corner < 8; ++corner) {
      const glm::vec3 p = ndc(view, glm::mix(box.low, box.high, glm::vec3(corner & 1, corner >> 1 & 1, corner >> 2)));
      CHECK(p.x > 0);
      CHECK(p.x < 1);
      CHECK(p.y > 0);
      CHECK(p.y < 1);
    }
  }
}

scene::Bounds bounds_between(glm::vec3 low, glm::vec3 high) { return {low, high}; }

TEST_CASE(
    "the camera that is chosen frames the bounds closely: all corners inside, the nearest to a border within a tenth") {
  for (const scene::Bounds& bounds :
       {box, bounds_between({0, 0, 0}, {8, 0.1f, 3}), bounds_between({-1, 0, -1}, {1, 40, 1}),
        bounds_between({1000, 2000, -500}, {1001, 2003, -498}), bounds_between({0, 0, 0}, {2e-3f, 1e-3f, 1e-3f})})
    for (const raster::ImageSize size : {raster::ImageSize{512, 512}, {900, 200}, {100, 700}}) {
      const CameraView view = camera_view({}, {}, {}, bounds, size);
      float nearest = 1;
      for (int corner = 0; corner < 8; ++corner) {
        const glm::vec3 p =
            ndc(view, glm::mix(bounds.low, bounds.high, glm::vec3(corner & 1, corner >> 1 & 1, corner >> 2)));
        nearest = std::min({nearest, p.x, p.y, 1 - p.x, 1 - p.y});
      }
      CAPTURE(size.width);
      CAPTURE(bounds.high.y);
      CHECK(nearest > 0.03f);
      CHECK(nearest < 0.1f);
    }
}

TEST_CASE(
    "the camera that is chosen, pasted as options, is the same to the last bit; one that is given is not printed") {
  for (const float fov : {20.0f, 45.0f, 100.0f})
    for (const std::optional<glm::vec3>& target : {std::optional<glm::vec3>(), {glm::vec3(0.1f, 0.7f, 3)}}) {
      RenderOptions options;
      options.view.fov_degrees = fov, options.view.target = target;
      const CameraView chosen = camera_view({}, {}, options, box, {300, 200});
      const std::optional<ViewOption> view = raster::chosen_view({}, options, box, {300, 200});
      REQUIRE(view);
      const std::string printed = cli::option_of(*view);
      glm::vec3 eye, at;
      REQUIRE(std::sscanf(printed.c_str(), "--eye %f,%f,%f --target %f,%f,%f", &eye.x, &eye.y, &eye.z, &at.x, &at.y,
                          &at.z) == 6);
      options.view.eye = eye, options.view.target = at;
      const CameraView pasted = camera_view({}, {}, options, box, {300, 200});
      CHECK(pasted.eye == chosen.eye);
      CHECK(pasted.forward == chosen.forward);
      CHECK(pasted.right == chosen.right);
      CHECK(pasted.near_plane == chosen.near_plane);
      CHECK(!raster::chosen_view({}, options, box, {300, 200}));
    }
  scene::Scene scene;
  scene.cameras.resize(1);
  CHECK(!raster::chosen_view(scene, {}, box, {300, 200}));
}

TEST_CASE("an eye that looks along its own up still has a right side; an empty scene has a view") {
  const CameraView down = camera_view({}, {}, looking({0, 5, 0}, {0, 0, 0}, 60), box, {10, 10});
  CHECK(glm::length(down.right) == doctest::Approx(1));
  CHECK(glm::length(down.up) == doctest::Approx(1));
  const CameraView empty = camera_view({}, {}, {}, {}, {10, 10});
  CHECK(std::isfinite(empty.eye.x + empty.near_plane));
  CHECK(empty.near_plane > 0);
}

TEST_CASE("cameras are chosen by name or index, and an unknown one is named") {
  scene::Scene scene;
  scene.cameras.resize(2);
  scene.cameras[1].name = "side";
  scene::Pose pose;
  pose.cameras = {glm::mat4(1), glm::translate(glm::mat4(1), glm::vec3(9, 0, 0))};
  RenderOptions options;
  for (const char* name : {"side", "1"}) {
    options.camera = name;
    CHECK(camera_view(scene, pose, options, box, {10, 10}).eye.x == 9);
  }
  options.camera = "top";
  CHECK_THROWS_WITH_AS((void)camera_view(scene, pose, options, box, {10, 10}), doctest::Contains("side"), UserError);
}

TEST_CASE("the image is as wide as the camera's aspect asks for") {
  scene::Scene scene;
  scene.cameras.resize(1);
  scene.cameras[0].aspect = 2.0f;
  RenderOptions options;
  CHECK(raster::image_size(scene, options).width == 1024);
  options.width = 30, options.height = 20;
  CHECK(raster::image_size(scene, options).width == 30);
}

TEST_CASE("the first sample lies at the pixel's centre, the others spread over the pixel and turn with the seed") {
  CHECK(raster::jitter(0, 5) == glm::vec2(0));
  CHECK(raster::jitter(1, 0) != raster::jitter(1, 1));
  uint32_t quarters[4] = {};
  for (uint32_t i = 0; i < 64; ++i) {
    const glm::vec2 at = raster::jitter(i, 3);
    CHECK(std::abs(at.x) <= 0.5f);
    CHECK(std::abs(at.y) <= 0.5f);
    ++quarters[(at.x < 0) + 2 * (at.y < 0)];
  }
  for (const uint32_t count : quarters) CHECK(count >= 12);
}

}  // namespace
}  // namespace crsh
