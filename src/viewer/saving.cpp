#include "viewer/saving.h"

#include <fmt/format.h>

#include <filesystem>

#include "output/exr.h"
#include "output/png.h"
#include "output/whole_file.h"
#include "viewer/command_line.h"

namespace crsh::viewer {
namespace {

bool is_exr(const std::string& path) { return path.ends_with(".exr"); }

}  // namespace

bool can_save(const Model& model, const std::string& path) {
  if (!model.fine()) return false;
  if (!is_exr(path)) return true;
  for (const std::string& layer : picture_layers(model.command.options.layers))
    if (!model.left.shown->picture.find(layer)) return false;
  return true;
}

void save_picture(const Model& model, const std::string& path) {
  const Shown& shown = *model.left.shown;
  if (is_exr(path)) {
    cli::RenderCommand command = command_of(shown, model.command);
    output::write_exr(path, shown.picture, picture_layers(model.command.options.layers),
                      cli::attributes_of(command, shown.seconds), command.ids);
    return;
  }
  output::write_whole(
      path, output::encode_png(*shown.picture.find(""), shown.picture.width, shown.picture.height, model.exposure()));
}

void save_screenshot(const gpu::Screenshot& screenshot, const std::string& path) {
  output::write_whole(path, output::encode_rgb_png(screenshot.rgb, screenshot.width, screenshot.height));
}

std::string free_name(const Model& model, const std::string& extension) {
  const std::string stem = std::filesystem::path(model.command.scene).stem().string();
  for (uint32_t number = 1;; ++number) {
    const std::string name = fmt::format("{}-{}{}", stem, number, extension);
    std::error_code ignored;
    if (!std::filesystem::exists(name, ignored)) return name;
  }
}

std::string copied_command(const Model& model) { return command_line(command_of(*model.left.shown, model.command)); }

}  // namespace crsh::viewer
