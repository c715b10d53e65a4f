#pragma once
// Whole pictures, rendered in this process, and what two renderings differ in.

#include <cstdint>
#include <string>
#include <string_view>

#include "crsh/renderer.h"
#include "frame/borrowed.h"
#include "gpu/device.h"
#include "scene/scene.h"

namespace crsh::test {

struct Rendered {
  Picture picture;
  Statistics statistics;
};

/// One frame on this device.
[[nodiscard]] Rendered render(gpu::Device& device, const scene::Scene& scene, const RenderOptions& options,
                              double seconds = 0);
/// One frame on the device that all tests share.
[[nodiscard]] Rendered render(const scene::Scene& scene, const RenderOptions& options, double seconds = 0);

/// The preset `algorithm` with the options' image.
[[nodiscard]] Rendered render_with(const std::string& algorithm, const scene::Scene& scene, RenderOptions options,
                                   double seconds = 0);

/// What the shared device was asked for, for devices of a test's own.
[[nodiscard]] gpu::DeviceRequest device_request();

/// scenes/NAME.glb of the project; loaded once.
[[nodiscard]] const scene::Scene& own_scene(const std::string& name);

/// A file below the shared scenes, which are not part of the project (tests/README.md); loaded once. Null where they
/// are not here.
[[nodiscard]] const scene::Scene* shared_scene(const std::string& path);

/// The first value of any layer whose bits differ, as a sentence; empty: all are the same.
[[nodiscard]] std::string difference(const Picture& a, const Picture& b);

/// The first ray kind and bounce whose numbers of rays or hits, or whose digests, differ; empty: none.
[[nodiscard]] std::string difference_of_hits(const Statistics& a, const Statistics& b);

/// The first counter that differs, of all there are; empty: none. Times and memory are no counters.
[[nodiscard]] std::string difference_of_counters(const Statistics& a, const Statistics& b);

/// Pictures and hits.
[[nodiscard]] std::string difference(const Rendered& a, const Rendered& b);

/// The counters of a ray kind at a bounce.
[[nodiscard]] const RayStatistics& rays_of(const Statistics& statistics, std::string_view kind, uint32_t bounce);

}  // namespace crsh::test
