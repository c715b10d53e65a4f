// crsh diff: compares two images.

#include <fmt/format.h>

#include <memory>

#include "cli/command.h"
#include "cli/render_options.h"
#include "cli/rows.h"
#include "crsh/error.h"
#include "output/diff.h"
#include "output/whole_file.h"

namespace crsh::cli {
namespace {

const char* const notes =
    "A and B are both OpenEXR or both PNG: one of each, as in a.exr b.png, is wrong\n"
    "usage, since one has light and the other what a screen shows. The difference of\n"
    "two values is absolute for PNG, whose values are 0 to 1, and relative for\n"
    "OpenEXR: |a-b| divided by the largest of |a|, |b| and 0.01. R, G, B, A are\n"
    "compared unless --layers names others.\n"
    "\n"
    "Exit status: 0 no difference beyond the tolerance, 3 different (also in size or\n"
    "channels), 1 a file cannot be read, 2 wrong usage.\n"
    "\n"
    "Examples:\n"
    "  crsh diff a.exr b.exr --exact --layers all\n"
    "  crsh diff a.png b.png --fail 0.01 --fail-percent 1 -o difference.png\n";

struct DiffCommand {
  std::string a, b;
  output::Tolerance tolerance;
  std::optional<double> fail, fail_percent, hard_fail;
  std::string layers = "beauty", picture, json;
};

Option limit_row(std::string names, std::string help, std::string initial, std::optional<double>& limit, float high) {
  return {.names = std::move(names),
          .value = "N",
          .help = std::move(help),
          .set = [&limit, high](const std::string& text) { limit = double(parse_real(text, 0, high)); },
          .initial = std::move(initial)};
}

std::vector<OptionGroup> diff_options(DiffCommand& command) {
  constexpr float any = 1e30f;
  return {{"Tolerance",
           {flag("--exact", "Every bit must be equal.", command.tolerance.exact),
            limit_row("--fail", "A pixel fails when one of its channels differs by more.", "0.004", command.fail, any),
            limit_row("--fail-percent", "Per cent of all pixels that may fail.", "0.1", command.fail_percent, 100),
            limit_row("--hard-fail", "No pixel may differ by more.", "0.05, or --fail where that is more",
                      command.hard_fail, any)}},
          {"What and where to",
           {with_words(layer_words(),
                       text("--layers", "LIST", "Layers to compare, with commas between, or all.", command.layers)),
            text("-o,--output", "FILE.png", "Write a picture: black where equal, white at the worst pixel.",
                 command.picture),
            text("--json", "FILE|-", "Write the result as JSON.", command.json)}}};
}

void check(DiffCommand& command) {
  if (command.tolerance.exact && (command.fail || command.fail_percent || command.hard_fail))
    throw UserError("--exact allows no difference: give it without --fail, --fail-percent and --hard-fail",
                    Exit::usage);
  if (command.picture == "-" && command.json == "-")
    throw UserError("two outputs on standard output: give one of them a file", Exit::usage);
  if (command.picture != "-" && !command.picture.empty() && !command.picture.ends_with(".png"))
    throw UserError(fmt::format("--output {}: a path that ends in .png is allowed, or -", command.picture),
                    Exit::usage);
  for (const std::string* path : {&command.picture, &command.json})
    if (!path->empty() && *path != "-") output::check_writable(*path);
  output::Tolerance& tolerance = command.tolerance;
  tolerance.fail = command.fail.value_or(tolerance.fail);
  tolerance.fail_percent = command.fail_percent.value_or(tolerance.fail_percent);
  tolerance.hard_fail = command.hard_fail.value_or(std::max(tolerance.hard_fail, tolerance.fail));
}

void write_to(const std::string& path, const std::string& bytes) {
  path == "-" ? output::write_stdout(bytes) : output::write_whole(path, bytes);
}

/// Prints the line on standard output, or on standard error where other data goes to standard output.
void say_verdict(const DiffCommand& command, const std::string& line) {
  if (command.json == "-" || command.picture == "-") fmt::print(stderr, "{}\n", line);
  else output::write_stdout(line + "\n");
}

void run_diff(DiffCommand& command) {
  check(command);
  const output::Image a = output::read_image(command.a), b = output::read_image(command.b);
  const output::Comparison result = output::compare(a, b, split(command.layers, ','), command.tolerance);
  say_verdict(command, output::verdict(result, command.tolerance));
  if (!command.json.empty()) write_to(command.json, output::diff_json(result, command.tolerance, command.a, command.b));
  if (!command.picture.empty() && result.mismatch.empty()) write_to(command.picture, output::difference_png(result));
  if (!result.same) throw UserError("", Exit::differ);
}

}  // namespace

Command diff_command() {
  auto command = std::make_shared<DiffCommand>();
  return {.name = "diff",
          .summary = "Compares two images and names the worst pixel.",
          .positionals = {{.name = "A", .set = [command](const std::string& path) { command->a = path; }},
                          {.name = "B", .set = [command](const std::string& path) { command->b = path; }}},
          .groups = diff_options(*command),
          .epilogue = notes,
          .run = [command](const std::vector<std::string>&) { run_diff(*command); }};
}

}  // namespace crsh::cli
