#include "cli/mend.h"

#include <fmt/format.h>

#include <array>

#include "cli/values.h"

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
  return fmt::format("--eye {} --target {}", text_of(view.eye.value()), text_of(view.target.value()));
}

std::string option_of(const LightOption& light) { return "--light " + text_of(light); }

}  // namespace crsh::cli
