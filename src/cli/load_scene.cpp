#include "cli/load_scene.h"

#include "scene/gltf/load.h"

namespace crsh::cli {

scene::Scene load_scene(const std::string& path, const std::string& which, bool allow_outside) {
  try {
    return scene::load(path, which, allow_outside ? scene::Reach::anywhere : scene::Reach::folder);
  } catch (const scene::OutsideError& error) {
    throw UserError(std::string(error.what()) + " (--allow-outside)", error.status());
  }
}

}  // namespace crsh::cli
