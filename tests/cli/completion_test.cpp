// Completions and the manual page, made from the tables of options, as shells and roff read them.

#include <doctest/doctest.h>

#include <algorithm>
#include <sstream>

#include "cli/command.h"
#include "cli/values.h"
#include "output/whole_file.h"
#include "support/program.h"
#include "support/temporary_folder.h"

namespace crsh {
namespace {

using test::crsh;

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

/// What bash offers for the last of the words.
std::vector<std::string> bash_offers(const std::vector<std::string>& words) {
  std::string list;
  for (const std::string& word : words) list += " '" + word + "'";
  const std::string script = "source <('" + test::crsh_path() + "' completion bash); COMP_WORDS=(" + list +
                             "); COMP_CWORD=" + std::to_string(words.size() - 1) +
                             "; _crsh; printf '%s\\n' \"${COMPREPLY[@]}\"";
  const test::Outcome outcome = test::run_program("bash", {"--norc", "-c", script});
  CHECK(outcome.err == "");
  return lines_of(outcome.out);
}

using Words = std::vector<std::string>;

TEST_CASE("bash completes commands, options, their values and lists, and leaves the rest to file names") {
  CHECK(bash_offers({"crsh", "re"}) == Words{"render"});
  CHECK(bash_offers({"crsh", "render", "a.glb", "--over"}) == Words{"--override-mirror"});
  CHECK(bash_offers({"crsh", "render", "--algorithm", "crsh-2"}) == Words{"crsh-2017"});
  CHECK(bash_offers({"crsh", "render", "--compression", ""}) == Words{"off", "on"});
  CHECK(bash_offers({"crsh", "render", "--layers", "Z,Tests.n"}) == Words{"Z,Tests.node"});
  CHECK(bash_offers({"crsh", "diff", "a", "b", "--layers", "Ref"}) == Words{"Reflection", "Refraction"});
  CHECK(bash_offers({"crsh", "render", "scene"}) == Words{""});
  CHECK(bash_offers({"crsh", "render", "-o", "pic"}) == Words{""});
  CHECK(bash_offers({"crsh", "completion", ""}) == Words{"bash", "zsh", "fish"});
  CHECK(bash_offers({"crsh", "render", "--mut"}) == Words{""});
}

bool is_here(const std::string& program) {
  const bool here = test::run_program(program, {"--version"}).status == 0;
  if (!here) MESSAGE("skipped: ", program, " is not installed");
  return here;
}

TEST_CASE("zsh and fish accept their scripts") {
  const test::TemporaryFolder folder;
  for (const char* shell : {"zsh", "fish"}) {
    const test::Outcome script = crsh({"completion", shell});
    REQUIRE(script.status == 0);
    output::write_whole(folder / shell, script.out);
    if (!is_here(shell)) continue;
    const test::Outcome checked = test::run_program(shell, {"-n", folder / shell});
    CHECK(checked.err == "");
    CHECK(checked.status == 0);
  }
}

/// Whether the text has the name and no longer one: "--fail" is not in "--fail-percent".
bool has_name(const std::string& text, const std::string& name) {
  for (size_t at = text.find(name); at != std::string::npos; at = text.find(name, at + 1)) {
    const char next = at + name.size() < text.size() ? text[at + name.size()] : ' ';
    if (!std::isalnum(static_cast<unsigned char>(next)) && next != '-') return true;
  }
  return false;
}

TEST_CASE("every option is in every script and in the manual, but those for tests") {
  std::string manual = crsh({"help", "--man"}).out;
  for (size_t at; (at = manual.find("\\f")) != std::string::npos;) manual.replace(at, 3, " ");  // \fB and the like
  std::erase(manual, '\\');
  const std::string bash = crsh({"completion", "bash"}).out, zsh = crsh({"completion", "zsh"}).out,
                    fish = crsh({"completion", "fish"}).out;
  for (const cli::Command& command : cli::commands())
    for (const cli::OptionGroup& group : command.groups)
      for (const cli::Option& option : group.options)
        for (const std::string& name : cli::split(option.names, ',')) {
          CAPTURE(name);
          CHECK(has_name(manual, name) == !option.hidden);
          for (const std::string& script : {bash, zsh}) CHECK(has_name(script, name) == !option.hidden);
          const std::string fish_name = name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
          CHECK(has_name(fish, fish_name) == !option.hidden);
        }
}

TEST_CASE("the manual is roff without a warning, and the same every time") {
  const test::Outcome manual = crsh({"help", "--man"});
  CHECK(manual.status == 0);
  CHECK(crsh({"help", "--man"}).out == manual.out);
  if (!is_here("groff")) return;
  const test::TemporaryFolder folder;
  output::write_whole(folder / "crsh.1", manual.out);
  const test::Outcome page = test::run_program("groff", {"-man", "-ww", "-Tascii", "-P-cbu", folder / "crsh.1"});
  CHECK(page.err == "");
  CHECK(page.out.find("EXIT STATUS") != std::string::npos);
}

TEST_CASE("an unknown shell is wrong usage, one line") {
  const test::Outcome outcome = crsh({"completion", "tcsh"});
  CHECK(outcome.status == 2);
  CHECK(outcome.error_lines() == 1);
  CHECK(outcome.err.find("bash, zsh, fish") != std::string::npos);
}

}  // namespace
}  // namespace crsh
