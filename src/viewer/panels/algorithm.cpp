// The algorithm and its switches, from the table of options that the command line has.

#include <imgui.h>

#include <algorithm>

#include "cli/mend.h"
#include "cli/values.h"
#include "crsh/error.h"
#include "crsh/kinds.h"
#include "trace/tracers.h"
#include "viewer/panels/panels.h"

namespace crsh::viewer {
namespace {

using cli::Option;
using Json = nlohmann::ordered_json;

void set(Model& model, const Option& option, const std::string& value) {
  try {
    option.set(value);
  } catch (const UserError& error) {
    model.say("--" + option.key() + " " + value + ": " + cli::line_of(error), true);
  }
}

/// "mesh-culling" as "Mesh culling".
std::string title_of(const Option& option) {
  std::string title = option.key();
  std::ranges::replace(title, '-', ' ');
  title[0] = char(std::toupper(title[0]));
  return title;
}

/// Draws an option whose value is one of several words.
void draw_words(Model& model, Widgets& widgets, const Option& option, const std::string& name, const char* label,
                const std::string& now, const std::string& prefix) {
  std::vector<std::string> words = option.words;
  std::erase_if(words, [](const std::string& word) { return word == "file"; });  // makes sense only with --replay-rays
  std::string chosen;
  const bool changed = widgets.choice(name, label, now, words, chosen);
  widgets.hint(option.help);
  if (changed) set(model, option, prefix + chosen);
}

void draw_whole(Model& model, Widgets& widgets, const Option& option, const std::string& name, const char* label,
                int now, int low, int high, const std::string& prefix) {
  const bool changed = widgets.whole(name, label, now, low, high);
  widgets.hint(option.help);
  if (changed) set(model, option, prefix + std::to_string(now));
}

/// Draws an option that has a value for each kind of rays.
void draw_kinds(Model& model, Widgets& widgets, const Option& option, const Json& values) {
  for (const auto& [kind, value] : values.items()) {
    const std::string name = option.key() + " " + kind, label = title_of(option) + ", " + kind.substr(0, 7);
    if (value.is_string()) draw_words(model, widgets, option, name, label.c_str(), value, kind + "=");
    else draw_whole(model, widgets, option, name, label.c_str(), value, 1, 8, kind + "=");
  }
}

void draw_option(Model& model, Widgets& widgets, const Option& option) {
  const Json value = option.get();
  const std::string name = option.key(), label = title_of(option);
  if (value.is_object()) return draw_kinds(model, widgets, option, value);
  if (option.words == std::vector<std::string>{"off", "on"}) {
    bool on = value == "on";
    if (widgets.check(name, label.c_str(), on)) set(model, option, on ? "on" : "off");
    return widgets.hint(option.help);
  }
  if (!option.words.empty()) return draw_words(model, widgets, option, name, label.c_str(), value, "");
  if (value.is_number_integer()) return draw_whole(model, widgets, option, name, label.c_str(), value, 2, 64, "");
  float real = value.is_number() ? value.get<float>() : 0;
  if (value.is_number() && widgets.real(name, label.c_str(), real, 0, 4, "%.2f"))
    set(model, option, cli::text_of(cli::json_of(real)));
}

/// Whether keys, nodes and levels matter to what the algorithm traces with.
bool has_switches(const AlgorithmOptions& algorithm) { return trace::tracer_of(algorithm).needs.sorted_rays; }

}  // namespace

void draw_algorithm_section(Model& model, Widgets& widgets) {
  if (!widgets.header("Algorithm", "Algorithm", true)) return;
  const cli::OptionGroup group = cli::algorithm_options(model.command.options.algorithm);
  for (const Option& option : group.options)
    if (option.get && (has_switches(model.command.options.algorithm) || option.key() == "algorithm"))
      draw_option(model, widgets, option);
}

}  // namespace crsh::viewer
