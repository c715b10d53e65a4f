// crsh completion: scripts by which shells complete command lines, made from the tables of options.

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <memory>

#include "cli/command.h"
#include "cli/values.h"
#include "output/whole_file.h"

namespace crsh::cli {
namespace {

const char* const examples =
    "Examples:\n"
    "  source <(crsh completion bash)\n"
    "  crsh completion zsh > ~/.zfunc/_crsh\n"
    "  crsh completion fish > ~/.config/fish/completions/crsh.fish\n";

const std::vector<std::string> shells = {"bash", "zsh", "fish"};

bool takes_file(const Option& option) { return option.value.starts_with("FILE"); }
bool takes_list(const Option& option) { return option.value == "LIST"; }

std::string words_of(const Option& option) { return fmt::format("{}", fmt::join(option.words, " ")); }

/// Calls `use` with every option that is not hidden, and its names.
template <class Use>
void for_options(const Command& command, Use use) {
  for (const OptionGroup& group : command.groups)
    for (const Option& option : group.options)
      if (!option.hidden) use(option, split(option.names, ','));
}

std::vector<std::string> command_names() {
  std::vector<std::string> names;
  for (const Command& command : commands()) names.push_back(command.name);
  names.emplace_back("help");
  return names;
}

/// The words that a command takes besides options, where these are no files.
std::string positional_words(const Command& command) {
  return command.name == "completion" ? fmt::format("{}", fmt::join(shells, " ")) : "";
}

// ---- bash

/// A case for each option that takes a value: the words it may be, or none, where bash completes file names.
std::string bash_values(const Command& command) {
  std::string cases;
  for_options(command, [&](const Option& option, const std::vector<std::string>& names) {
    std::string pattern;
    for (const std::string& name : names)
      pattern += fmt::format("{}{}:{}", pattern.empty() ? "" : "|", command.name, name);
    if (!option.words.empty())
      cases += fmt::format("    {}) _crsh_words '{}' {}; return ;;\n", pattern, words_of(option),
                           takes_list(option) ? "list" : "one");
    else if (!option.value.empty()) cases += fmt::format("    {}) return ;;\n", pattern);
  });
  return cases;
}

/// Completes options where a word begins with "-", else the words that the command takes; without any, bash completes
/// file names.
std::string bash_options(const Command& command) {
  std::string names = "--help";
  for_options(command, [&](const Option&, const std::vector<std::string>& own) {
    names += fmt::format(" {}", fmt::join(own, " "));
  });
  return fmt::format("    {}) [[ $current == -* ]] && _crsh_words '{}' one || _crsh_words '{}' one ;;\n", command.name,
                     names, positional_words(command));
}

std::string bash() {
  std::string values, options;
  for (const Command& command : commands()) {
    values += bash_values(command);
    options += bash_options(command);
  }
  const std::string names = fmt::format("{}", fmt::join(command_names(), " "));
  return "# bash completion for crsh, made by: crsh completion bash\n\n"
         "# Completes one of the words, or the last of a list with commas between.\n"
         "_crsh_words() {\n"
         "  local before=\n"
         "  if [[ $2 == list && $current == *,* ]]; then before=${current%,*},; fi\n"
         "  mapfile -t COMPREPLY < <(compgen -P \"$before\" -W \"$1\" -- \"${current#\"$before\"}\")\n"
         "}\n\n"
         "_crsh() {\n"
         "  COMPREPLY=()\n"
         "  local current=${COMP_WORDS[COMP_CWORD]}\n"
         "  if ((COMP_CWORD == 1)); then _crsh_words '" +
         names +
         " --version' one; return; fi\n"
         "  case ${COMP_WORDS[1]}:${COMP_WORDS[COMP_CWORD - 1]} in\n" +
         values +
         "  esac\n"
         "  case ${COMP_WORDS[1]} in\n" +
         options + "    help) _crsh_words '" + names +
         " --man' one ;;\n"
         "  esac\n"
         "}\n"
         "complete -o default -F _crsh crsh\n";
}

// ---- zsh

/// Text escaped for single quotes, in places where brackets and colons have a meaning.
std::string zsh_text(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (c == '\'') result += "'\\'";
    else if (c == '[' || c == ']' || c == ':' || c == '\\') result += '\\';
    result += c;
  }
  return result;
}

std::string zsh_value(const Option& option) {
  if (option.value.empty()) return "";
  std::string action = " ";
  if (takes_file(option)) action = "_files";
  if (takes_list(option)) action = fmt::format("_sequence compadd - {}", words_of(option));
  else if (!option.words.empty()) action = fmt::format("({})", words_of(option));
  return fmt::format(":{}:{}", zsh_text(option.value), action);
}

std::string zsh_options(const Command& command) {
  std::string rows;
  for_options(command, [&](const Option& option, const std::vector<std::string>& names) {
    const std::string all = fmt::format("{}", fmt::join(names, ","));
    const std::string exclusive = option.repeats ? "*" : fmt::format("({})", fmt::join(names, " "));
    const std::string name =
        names.size() == 1 ? fmt::format("'{}{}", exclusive, all) : fmt::format("'{}'{{{}}}'", exclusive, all);
    rows += fmt::format(" \\\n        {}[{}]{}'", name, zsh_text(option.help), zsh_value(option));
  });
  const std::string words = positional_words(command);
  rows += words.empty() ? " \\\n        '*:file:_files'" : fmt::format(" \\\n        ':shell:({})'", words);
  return fmt::format("    {})\n      _arguments '(- *)'{{-h,--help}}'[Say what the options are.]'{} ;;\n", command.name,
                     rows);
}

std::string zsh() {
  std::string names, options;
  for (const Command& command : commands()) {
    names += fmt::format("    '{}:{}'\n", command.name, zsh_text(command.summary));
    options += zsh_options(command);
  }
  return "#compdef crsh\n# zsh completion for crsh, made by: crsh completion zsh\n\n"
         "_crsh() {\n"
         "  local -a commands=(\n" +
         names +
         "    'help:Says more about a command.'\n"
         "  )\n"
         "  if ((CURRENT == 2)); then _describe command commands; return; fi\n"
         "  local command=$words[2]\n"
         "  shift words\n"
         "  ((CURRENT--))\n"
         "  case $command in\n" +
         options +
         "    help) _describe command commands ;;\n"
         "  esac\n"
         "}\n\n"
         "if [[ $funcstack[1] == _crsh ]]; then _crsh \"$@\"; else compdef _crsh crsh; fi\n";
}

// ---- fish

std::string fish_text(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (c == '\'' || c == '\\') result += '\\';
    result += c;
  }
  return "'" + result + "'";
}

std::string fish_options(const Command& command) {
  const std::string begin = fmt::format("complete -c crsh -n '__fish_seen_subcommand_from {}'", command.name);
  const std::string words = positional_words(command);
  std::string rows = words.empty() ? begin + " -F\n" : fmt::format("{} -a '{}'\n", begin, words);
  for_options(command, [&](const Option& option, const std::vector<std::string>& names) {
    rows += begin;
    for (const std::string& name : names)
      rows += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
    if (takes_file(option)) rows += " -r -F";
    else if (takes_list(option)) rows += fmt::format(" -x -a '(__fish_append , {})'", words_of(option));
    else if (!option.words.empty()) rows += fmt::format(" -x -a '{}'", words_of(option));
    else if (!option.value.empty()) rows += " -x";
    rows += fmt::format(" -d {}\n", fish_text(option.help));
  });
  return rows;
}

std::string fish() {
  std::string text = "# fish completion for crsh, made by: crsh completion fish\n\ncomplete -c crsh -f\n", options;
  for (const Command& command : commands()) {
    text += fmt::format("complete -c crsh -n __fish_use_subcommand -a {} -d {}\n", command.name,
                        fish_text(command.summary));
    options += fish_options(command);
  }
  text += "complete -c crsh -n __fish_use_subcommand -a help -d 'Says more about a command.'\n";
  text +=
      fmt::format("complete -c crsh -n '__fish_seen_subcommand_from help' -a '{}'\n", fmt::join(command_names(), " "));
  return text + options;
}

void run_completion(size_t shell) {
  constexpr std::string (*scripts[])() = {bash, zsh, fish};
  output::write_stdout(scripts[shell]());
}

}  // namespace

Command completion_command() {
  auto shell = std::make_shared<size_t>(0);
  return {.name = "completion",
          .summary = "Prints what bash, zsh or fish needs to complete crsh's command line.",
          .positionals = {{.name = "SHELL",
                           .set = [shell](const std::string& name) { *shell = parse_choice(name, shells); }}},
          .groups = {},
          .epilogue = examples,
          .run = [shell](const std::vector<std::string>&) { run_completion(*shell); }};
}

}  // namespace crsh::cli
