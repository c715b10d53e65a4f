// crsh info: the devices, or what is in a scene.

#include <memory>

#include "cli/command.h"
#include "cli/info_text.h"
#include "cli/load_scene.h"
#include "cli/rows.h"
#include "crsh/error.h"
#include "output/json_text.h"
#include "output/whole_file.h"

namespace crsh::cli {
namespace {

const char* const notes =
    "Without SCENE: the Vulkan devices, each with the index, name and UUID that\n"
    "--device of crsh render takes. With it: what is in the scene, what of it is not\n"
    "supported and left out, and what is approximated: drawn, but not as glTF means\n"
    "it.\n"
    "\n"
    "Examples:\n"
    "  crsh info\n"
    "  crsh info scene.glb\n"
    "  crsh info scene.glb --json | jq .scene.triangles\n";

struct InfoCommand {
  std::string scene;
  bool json = false;
  bool allow_outside = false, lenient = false;
};

void info_of_devices(bool json) {
  const std::vector<gpu::DeviceInfo> devices = gpu::list_devices();
  output::write_stdout(json ? output::json_text(devices_json(devices)) : devices_text(devices));
  for (const gpu::DeviceInfo& device : devices)
    if (device.unusable.empty()) return;
  throw UserError("no usable Vulkan device: install the package mesa-vulkan-drivers", Exit::no_device);
}

void run_info(const InfoCommand& command) {
  if (command.scene.empty()) return info_of_devices(command.json);
  const scene::Scene scene =
      load_scene(command.scene, {.reach = reach_of(command.allow_outside), .lenient = command.lenient});
  output::write_stdout(command.json ? output::json_text(scene_json(scene)) : scene_text(scene));
}

}  // namespace

Command info_command() {
  auto command = std::make_shared<InfoCommand>();
  return {.name = "info",
          .summary = "Lists the Vulkan devices, or what is in a scene.",
          .positionals = {{.name = "SCENE",
                           .required = false,
                           .set = [command](const std::string& path) { command->scene = path; }}},
          .groups = {{"Options",
                      {flag("--json", "As JSON.", command->json), allow_outside_row(command->allow_outside),
                       lenient_row(command->lenient)}}},
          .epilogue = notes,
          .run = [command](const std::vector<std::string>&) { run_info(*command); }};
}

}  // namespace crsh::cli
