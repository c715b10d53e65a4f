// The list of subcommands.

#include "cli/command.h"

namespace crsh::cli {

std::vector<Command> commands() {
  return {render_command(), bench_command(), diff_command(), info_command(), completion_command()};
}

}  // namespace crsh::cli
