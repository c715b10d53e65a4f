// The library in several threads, as others call it.

#include <doctest/doctest.h>

#include <exception>
#include <string>
#include <thread>
#include <vector>

#include "crsh/renderer.h"
#include "support/render.h"

namespace crsh::test {
namespace {

struct Job {
  std::string scene, algorithm;
  double seconds = 0;
};

const std::vector<Job> jobs = {{"glass", "crsh", 0}, {"moving", "crsh-bvh", 0.7}};

/// Everything of its own: the device, the scene, the renderer.
Rendered done(const Job& job) {
  const ScenePtr scene = read_scene(std::string(CRSH_SOURCE_DIR "/scenes/") + job.scene + ".glb");
  RenderOptions options;
  options.width = 48, options.height = 36, options.bounces = 2;
  options.layers = LayerSet::all();
  options.algorithm = preset(job.algorithm);
  Renderer renderer(open_device(device_request()), scene, options);
  Picture picture = renderer.render(job.seconds);
  return {std::move(picture), renderer.statistics()};
}

TEST_CASE("two threads render two scenes on two devices at once, and get what each would get alone") {
  std::vector<Rendered> together(jobs.size());
  std::vector<std::exception_ptr> errors(jobs.size());
  std::vector<std::thread> threads;
  for (size_t i = 0; i < jobs.size(); ++i)
    threads.emplace_back([&, i] {
      try {
        together[i] = done(jobs[i]);
      } catch (...) {
        errors[i] = std::current_exception();
      }
    });
  for (std::thread& thread : threads) thread.join();
  for (size_t i = 0; i < jobs.size(); ++i) {
    CAPTURE(jobs[i].scene);
    REQUIRE_FALSE(errors[i]);
    const Rendered one = done(jobs[i]);
    CHECK(difference(one, together[i]) == "");
    CHECK(difference_of_counters(one.statistics, together[i].statistics) == "");
  }
}

TEST_CASE("a renderer keeps its scene and its device, and can be moved") {
  Renderer renderer = [] {
    RenderOptions options;
    options.width = 24, options.height = 18, options.bounces = 1;
    return Renderer(open_device(device_request()), read_scene(CRSH_SOURCE_DIR "/scenes/cornell.glb"), options);
  }();
  RenderOptions options = renderer.options();
  const Picture picture = renderer.render();
  CHECK(difference(picture, render(own_scene("cornell"), options).picture) == "");
}

}  // namespace
}  // namespace crsh::test
