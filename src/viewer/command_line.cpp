#include "viewer/command_line.h"

#include <algorithm>
#include <array>

#include "cli/values.h"

namespace crsh::viewer {
namespace {

using Json = nlohmann::ordered_json;

/// Options left out of the command: they depend on the machine, or the name of the output file decides them.
constexpr std::array left_out = {"layers",     "frames",      "fps",        "device",
                                 "max-memory", "submit-work", "validation", "mutation"};

std::string shell_word(const std::string& word) {
  const auto is_plain = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
           std::string_view("_-./,=:+").find(c) != std::string_view::npos;
  };
  if (!word.empty() && std::ranges::all_of(word, is_plain)) return word;
  std::string text = "'";
  for (const char c : word) text += c == '\'' ? "'\\''" : std::string(1, c);
  return text + "'";
}

/// The words of an option's value: one, or several where it is a list or has a value a kind of rays.
std::vector<std::string> words_of(const Json& value) {
  std::vector<std::string> words;
  if (value.is_object())
    for (const auto& [kind, part] : value.items()) words.push_back(kind + "=" + cli::text_of(part));
  else if (value.is_array())
    for (const Json& part : value) words.push_back(cli::text_of(part));
  else words.push_back(cli::text_of(value));
  return words;
}

void append(std::string& line, const std::string& key, const Json& value) {
  if (value.is_boolean()) return void(line += value.get<bool>() ? " --" + key : "");
  for (const std::string& word : words_of(value)) {
    // After a space a negative number would be read as an option.
    line += " --" + key + (word.starts_with('-') ? "=" : " ") + shell_word(word);
  }
}

}  // namespace

cli::RenderCommand command_of(const Shown& shown, const cli::RenderCommand& base) {
  cli::RenderCommand command = base;
  command.options = shown.options;
  command.options.layers = base.options.layers;
  command.seconds.reset();
  if (shown.seconds != 0) command.seconds = float(shown.seconds);
  return command;
}

std::string command_line(cli::RenderCommand command) {
  cli::RenderCommand usual;
  usual.options.algorithm = preset(command.options.algorithm.preset);
  const Json values = cli::effective_options(cli::render_options(command));
  const Json defaults = cli::effective_options(cli::render_options(usual));
  const std::string usual_preset = RenderOptions().algorithm.preset;
  std::string line = "crsh render " + shell_word(command.scene);
  for (const auto& [key, value] : values.items()) {
    if (value.is_null() || std::ranges::find(left_out, key) != left_out.end()) continue;
    const bool differs = key == "algorithm" ? value != usual_preset : !defaults.contains(key) || defaults[key] != value;
    if (differs) append(line, key, value);
  }
  return line + " -o picture.png";
}

}  // namespace crsh::viewer
