#include "cli/mend.h"

#include <fmt/format.h>

#include <array>

namespace crsh::cli {
namespace {

/// By Mend.
constexpr std::array<std::string_view, mend_count> in_options = {
    "",
    "give a larger --max-memory",
    "choose a smaller --size",
    "try a smaller --submit-work",
    "give fewer --levels",
    "see crsh info",
    "choose another --algorithm",
    "choose another --device (see crsh info)",
    "choose another --algorithm or --device",
    "leave some out, or choose another --device (see crsh info)"};

}  // namespace

std::string line_of(const UserError& error) {
  if (error.mend() == Mend::none) return error.what();
  return fmt::format("{}: {}", error.reason(), in_options[static_cast<size_t>(error.mend())]);
}

std::string option_of(const ViewOption& view) {
  const glm::vec3 eye = view.eye.value(), target = view.target.value();
  return fmt::format("--eye {},{},{} --target {},{},{}", eye.x, eye.y, eye.z, target.x, target.y, target.z);
}

std::string option_of(const LightOption& light) {
  const std::string place = fmt::format("--light {},{},{}", light.position.x, light.position.y, light.position.z);
  return light.candela ? fmt::format("{},{}", place, *light.candela) : place;
}

}  // namespace crsh::cli
