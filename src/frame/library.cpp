// The front door of the library: devices and scenes behind pointers.

#include "crsh/renderer.h"
#include "gpu/device.h"
#include "scene/gltf/load.h"
#include "scene/hide.h"

namespace crsh {

DevicePtr open_device(const DeviceRequest& request) { return std::make_shared<gpu::Device>(request); }

const DeviceInfo& info_of(const DevicePtr& device) { return device->info(); }

std::vector<DeviceInfo> list_devices() { return gpu::list_devices(); }

namespace {

scene::LoadOptions load_options(const ReadOptions& options) {
  return {.scene = options.scene,
          .reach = options.allow_outside ? scene::Reach::anywhere : scene::Reach::folder,
          .variant = options.variant,
          .lenient = options.lenient};
}

}  // namespace

ScenePtr read_scene(const std::filesystem::path& path, const ReadOptions& options) {
  auto scene = std::make_shared<scene::Scene>(scene::load(path, load_options(options)));
  scene::hide(*scene, options.hidden);
  return scene;
}

const std::vector<std::string>& unsupported_in(const ScenePtr& scene) { return scene->unsupported; }

}  // namespace crsh
