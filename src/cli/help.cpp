// Help texts, made from the tables of options.

#include <fmt/format.h>

#include <sstream>

#include "cli/command.h"
#include "cli/values.h"

namespace crsh::cli {
namespace {

constexpr size_t text_column = 27, line_length = 80;

/// `text` broken between words, each line but the first indented to text_column.
std::string hanging(const std::string& text) {
  std::istringstream words(text);
  std::string result, word;
  size_t column = text_column;
  while (words >> word) {
    if (column > text_column && column + 1 + word.size() > line_length) {
      result += "\n" + std::string(text_column, ' ');
      column = text_column;
    } else if (column > text_column) {
      result += ' ';
      ++column;
    }
    result += word;
    column += word.size();
  }
  return result + "\n";
}

std::string row(const std::string& left, const std::string& text) {
  if (left.size() + 2 > text_column) return left + "\n" + std::string(text_column, ' ') + hanging(text);
  return fmt::format("{:<{}}", left, text_column) + hanging(text);
}

/// The left column: "  -o, --output FILE", with long names below one another.
std::string left_of(const Option& option) {
  const size_t comma = option.names.find(',');
  const std::string brief = comma == std::string::npos ? "    " : option.names.substr(0, comma) + ", ";
  return fmt::format("  {}--{} {}", brief, option.key(), option.value);
}

std::string option_row(const Option& option) {
  const std::string initial = default_of(option);
  return row(left_of(option), initial.empty() ? option.help : fmt::format("{} [{}]", option.help, initial));
}

}  // namespace

std::string default_of(const Option& option) {
  if (option.initial || !option.get) return option.initial.value_or("");
  const nlohmann::ordered_json value = option.get();
  return value.is_null() || value.is_boolean() ? "" : text_of(value);
}

std::string usage_of(const Command& command) {
  std::string usage = "Usage: " + (command.call.empty() ? "crsh " + command.name : command.call);
  for (const Positional& positional : command.positionals)
    usage += fmt::format(fmt::runtime(positional.required ? " {}{}" : " [{}{}]"), positional.name,
                         positional.repeats ? "..." : "");
  return usage + (command.groups.empty() ? "" : " [OPTION...]");
}

std::string help_of(const Command& command) {
  std::string text = fmt::format("{}\n\n{}\n", usage_of(command), command.summary);
  for (const OptionGroup& group : command.groups) {
    std::string rows;
    for (const Option& option : group.options)
      if (!option.hidden) rows += option_row(option);
    if (!rows.empty()) text += fmt::format("\n{}\n{}", group.title, rows);
  }
  return fmt::format("{}\n{}", text, command.epilogue);
}

std::string general_help() {
  std::string text =
      "Usage: crsh COMMAND ...\n\n"
      "Renders glTF scenes with ray-traced shadows, reflections and refractions on any\n"
      "Vulkan device, through a hierarchy over the rays.\n\nCommands:\n";
  for (const Command& command : commands()) {
    const size_t end = command.summary.find('\n');
    text += fmt::format("  {:<12}{}\n", command.name, command.summary.substr(0, end));
  }
  return text +
         "  help        Says more about a command: crsh help render; --man: the manual page\n"
         "\ncrsh --version says which version this is.\n"
         "\nExit status: 0 done, 1 failed, 2 wrong usage, 3 images differ, 77 no usable\nVulkan device.\n";
}

}  // namespace crsh::cli
