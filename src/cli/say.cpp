#include "cli/say.h"

#include <fmt/format.h>
#include <unistd.h>

#include <string_view>

#include "output/json_text.h"

namespace crsh::cli {
namespace {

constexpr std::string_view option = "--progress", json = "json";

}  // namespace

void say(const RenderCommand& command, const std::string& text) {
  if (command.quiet) return;
  const bool as_json = command.progress == ProgressChoice::json;
  fmt::print(stderr, "{}", as_json ? output::json_line({{"event", "note"}, {"text", text}}) : text + "\n");
}

void say_error(const std::string& text, Exit status, bool as_json) {
  if (text.empty()) return;
  if (!as_json) return fmt::print(stderr, "crsh: {}\n", text);
  fmt::print(stderr, "{}",
             output::json_line({{"event", "error"}, {"text", text}, {"status", static_cast<int>(status)}}));
}

bool asks_for_json(const std::vector<std::string>& words) {
  bool asks = false;
  for (size_t i = 0; i < words.size(); ++i) {
    if (words[i] == option && i + 1 < words.size()) asks = words[i + 1] == json;
    if (words[i].starts_with(std::string(option) + "=")) asks = words[i].substr(option.size() + 1) == json;
  }
  return asks;
}

output::Progress::Mode progress_mode(const RenderCommand& command) {
  using Mode = output::Progress::Mode;
  if (command.progress == ProgressChoice::json) return Mode::json;
  const bool shown = command.progress == ProgressChoice::automatic && !command.quiet && ::isatty(STDERR_FILENO);
  return shown ? Mode::bar : Mode::none;
}

}  // namespace crsh::cli
