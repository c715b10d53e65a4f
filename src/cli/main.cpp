// crsh: chooses the subcommand, and turns every error into one line and an exit status.

#include <fmt/format.h>

#include <exception>
#include <new>
#include <string>
#include <vector>

#include "cli/command.h"
#include "cli/mend.h"
#include "cli/say.h"
#include "crsh/error.h"
#include "crsh/leaks.h"
#include "crsh/version.h"
#include "gpu/device.h"
#include "output/whole_file.h"

namespace {

using namespace crsh;

[[nodiscard]] cli::Command find_command(const std::string& name) {
  for (cli::Command& command : cli::commands())
    if (command.name == name) return std::move(command);
  throw UserError(fmt::format("{}: no such command (see crsh help)", name), Exit::usage);
}

void run_help(const std::vector<std::string>& arguments) {
  if (arguments.size() > 1) throw UserError("help: one command at a time", Exit::usage);
  if (!arguments.empty() && arguments[0] == "--man") return output::write_stdout(cli::manual_page());
  output::write_stdout(arguments.empty() ? cli::general_help() : cli::help_of(find_command(arguments[0])));
}

/// `line`: the whole command line.
void run(const std::vector<std::string>& line) {
  if (line.size() < 2) throw UserError("a command is missing (see crsh help)", Exit::usage);
  const std::vector<std::string> arguments(line.begin() + 2, line.end());
  const std::string& name = line[1];
  if (name == "help" || name == "--help" || name == "-h") return run_help(arguments);
  if (name == "--version") return output::write_stdout(fmt::format("crsh {} ({})\n", version, commit));
  const cli::Command command = find_command(name);
  if (!cli::parse(command, arguments)) return output::write_stdout(cli::help_of(command));
  command.run(line);
}

/// Runs the command line; throws nothing, whatever happens.
[[nodiscard]] Exit run_reported(const std::vector<std::string>& line) {
  const auto report = [as_json = cli::asks_for_json(line)](const std::string& text, Exit status) {
    cli::say_error(text, status, as_json);
    return status;
  };
  try {
    run(line);
    return Exit::done;
  } catch (const UserError& error) {
    return report(cli::line_of(error), error.status());
  } catch (const gpu::OutOfMemory& shortage) {
    return report(fmt::format("out of memory ({}): make the image or the scene smaller", shortage.name), Exit::failed);
  } catch (const std::bad_alloc&) {
    return report("out of memory: make the image or the scene smaller", Exit::failed);
  } catch (const std::exception& error) {
    return report(fmt::format("internal error: {}", error.what()), Exit::failed);
  }
}

}  // namespace

int main(int count, char** arguments) {
  output::remove_unfinished_files_on_signals();
  return static_cast<int>(run_reported(std::vector<std::string>(arguments, arguments + count)));
}
