#pragma once
// A subcommand: its options as one table, from which parsing, help, the effective options and the EXR attributes come.

#include <functional>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

namespace crsh::cli {

/// A row of the table: an option, and the functions that set and get its variable.
struct Option {
  std::string names;  ///< "-o,--output": the last one names it in JSON and messages
  std::string value;  ///< placeholder in the help; empty: a flag
  std::string help;
  /// Sets the variable from one value ("true" for a flag). Throws UserError that says what is allowed.
  std::function<void(const std::string&)> set;
  /// Gives the effective value, null where the scene decides. No function: not one of the effective options.
  std::function<nlohmann::ordered_json()> get = {};
  bool repeats = false;                     ///< may be given several times; else the last value counts
  bool pixels = false;                      ///< changes pixels: an attribute of the EXR
  std::optional<std::string> initial = {};  ///< the default as the help shows it; none: what `get` gives
  bool hidden = false;  ///< for tests: not shown in the help, and an effective option only where it is given
  std::vector<std::string> words =
      {};  ///< the values that have names, for shells to complete; in a LIST with commas between

  /// The last of `names`, without its dashes.
  [[nodiscard]] std::string key() const;
};

struct OptionGroup {
  std::string title;
  std::vector<Option> options;
};

struct Positional {
  std::string name;  ///< "SCENE"
  bool required = true;
  std::function<void(const std::string&)> set;
  bool repeats = false;  ///< one or more of them
};

struct Command {
  std::string name, summary;
  std::string call = {};  ///< how it is called; empty: "crsh NAME"
  std::string help = {};  ///< the line that says more about it; empty: "crsh help NAME"
  std::vector<Positional> positionals;
  std::vector<OptionGroup> groups;
  std::string epilogue;                                      ///< examples: the end of the help
  std::function<void(const std::vector<std::string>&)> run;  ///< gets the whole command line as it was given
};

/// All subcommands, in the order of the help.
[[nodiscard]] std::vector<Command> commands();
// A file each.
[[nodiscard]] Command render_command();
[[nodiscard]] Command bench_command();
[[nodiscard]] Command diff_command();
[[nodiscard]] Command info_command();
[[nodiscard]] Command completion_command();

/// Sets all options that `arguments`, what follows the subcommand, name. Returns false where they ask for help. Throws
/// UserError (wrong usage): one line that names the option, the value and what is allowed.
[[nodiscard]] bool parse(const Command& command, const std::vector<std::string>& arguments);

/// Every effective value by the option's name; with `only_pixels`, those of options that change pixels.
[[nodiscard]] nlohmann::ordered_json effective_options(const std::vector<OptionGroup>& groups,
                                                       bool only_pixels = false);

/// The default as the help shows it; empty: none.
[[nodiscard]] std::string default_of(const Option& option);
/// "Usage: crsh render SCENE [OPTION...]"
[[nodiscard]] std::string usage_of(const Command& command);

/// `crsh help COMMAND`.
[[nodiscard]] std::string help_of(const Command& command);
/// `crsh help`.
[[nodiscard]] std::string general_help();
/// `crsh help --man`: the manual page, in roff.
[[nodiscard]] std::string manual_page();

}  // namespace crsh::cli
