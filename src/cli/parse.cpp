// CLI11 takes the command line apart; what values mean is decided by the table of options.

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include <algorithm>
#include <limits>

#include "cli/command.h"
#include "crsh/error.h"

namespace crsh::cli {
namespace {

[[noreturn]] void misuse(const Command& command, const std::string& what) {
  const std::string help = command.help.empty() ? "crsh help " + command.name : command.help;
  throw UserError(fmt::format("{} (see {})", what, help), Exit::usage);
}

/// An option or positional of the table, and the values that CLI11 collects for it.
template <class Row>
struct Collected {
  const Row* row;
  CLI::Option* found;
};

CLI::Option* declare(CLI::App& app, const Option& option) {
  CLI::Option* declared = option.value.empty() ? app.add_flag(option.names) : app.add_option(option.names);
  if (!option.value.empty()) declared->allow_extra_args(false);
  return declared->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
}

CLI::Option* declare(CLI::App& app, const Positional& positional) {
  CLI::Option* declared = app.add_option(positional.name);
  return positional.repeats ? declared->expected(1, std::numeric_limits<int>::max() / 2)->allow_extra_args() : declared;
}

void set(const Option& option, const std::string& value) {
  try {
    option.set(value);
  } catch (const UserError& error) {
    throw UserError(fmt::format("--{} {}: {}", option.key(), value.empty() ? "''" : value, error.what()),
                    error.status());
  }
}

void set_all(const Collected<Option>& collected) {
  const auto& values = collected.found->results();
  if (values.empty()) return;
  const size_t first = collected.row->repeats ? 0 : values.size() - 1;
  for (size_t index = first; index < values.size(); ++index) set(*collected.row, values[index]);
}

void refuse_unknown(const Command& command, const std::vector<std::string>& unknown) {
  if (unknown.empty()) return;
  const bool option = unknown[0].size() > 1 && unknown[0][0] == '-';
  misuse(command, fmt::format("{}: {}", unknown[0], option ? "no such option" : "one argument too many"));
}

void collect(CLI::App& app, const Command& command, std::vector<std::string> arguments) {
  std::ranges::reverse(arguments);  // CLI11 wants them in reverse order
  try {
    app.parse(arguments);
  } catch (const CLI::ArgumentMismatch& error) {
    const std::string message = error.what();  // "--size: 1 required TEXT missing"
    misuse(command, message.substr(0, message.find(':')) + ": its value is missing");
  } catch (const CLI::ParseError& error) {
    misuse(command, error.what());
  }
}

}  // namespace

std::string Option::key() const { return names.substr(names.rfind("--") + 2); }

bool parse(const Command& command, const std::vector<std::string>& arguments) {
  CLI::App app;
  app.set_help_flag();
  app.allow_extras();
  CLI::Option* help = app.add_flag("-h,--help");
  std::vector<Collected<Option>> options;
  std::vector<Collected<Positional>> positionals;
  for (const OptionGroup& group : command.groups)
    for (const Option& option : group.options) options.push_back({&option, declare(app, option)});
  for (const Positional& positional : command.positionals)
    positionals.push_back({&positional, declare(app, positional)});

  collect(app, command, arguments);
  if (help->count()) return false;
  refuse_unknown(command, app.remaining());
  for (const auto& [positional, found] : positionals) {
    if (positional->required && !found->count()) misuse(command, positional->name + " is missing");
    for (const std::string& value : found->results()) positional->set(value);
  }
  for (const auto& option : options) set_all(option);
  return true;
}

nlohmann::ordered_json effective_options(const std::vector<OptionGroup>& groups, bool only_pixels) {
  auto values = nlohmann::ordered_json::object();
  for (const OptionGroup& group : groups) {
    for (const Option& option : group.options) {
      if (!option.get || (only_pixels && !option.pixels)) continue;
      nlohmann::ordered_json value = option.get();
      if (!value.is_null() || !(option.hidden || only_pixels)) values[option.key()] = std::move(value);
    }
  }
  return values;
}

}  // namespace crsh::cli
