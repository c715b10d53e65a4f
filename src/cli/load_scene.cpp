#include "cli/load_scene.h"

namespace crsh::cli {

scene::Scene load_scene(const std::string& path, const scene::LoadOptions& options) {
  try {
    return scene::load(path, options);
  } catch (const scene::OutsideError& error) {
    throw UserError(std::string(error.what()) + " (--allow-outside)", error.status());
  } catch (const scene::ExtensionError& error) {
    throw UserError(std::string(error.what()) + " (--lenient)", error.status());
  }
}

}  // namespace crsh::cli
