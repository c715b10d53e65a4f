// --layers, from the table of layers.

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "cli/render_options.h"
#include "cli/values.h"
#include "output/image.h"

namespace crsh::cli {
namespace {

std::vector<std::string> names_of(const LayerSet& layers) {
  std::vector<std::string> names;
  for (const LayerId id : layers.members()) names.emplace_back(row_of(id).name);
  return names;
}

/// Adds every layer of which the name means all channels.
void add_named(LayerSet& layers, const std::string& name) {
  bool known = name == "all";
  if (known) layers = LayerSet::all();
  for (const LayerId layer : LayerSet::all().members()) {
    if (!std::ranges::all_of(channels_of(layer), [&](const auto& channel) { return output::in_layer(channel, name); }))
      continue;
    layers.add(layer);
    known = true;
  }
  if (!known)
    refuse(fmt::format("{}: no such layer: choose of {}, or all", name, fmt::join(names_of(LayerSet::all()), ", ")));
}

}  // namespace

Option layers_option(LayerSet& layers) {
  return {.names = "--layers",
          .value = "LIST",
          .help = "Layers of an EXR, named below, with commas between, or all.",
          .set =
              [&layers](const std::string& text) {
                LayerSet chosen;
                for (const std::string& name : split(text, ',')) add_named(chosen, name);
                layers = chosen;
              },
          .get = [&layers] { return fmt::format("{}", fmt::join(names_of(layers), ",")); },
          .words = layer_words()};
}

std::vector<std::string> layer_words() {
  std::vector<std::string> words = names_of(LayerSet::all());
  words.emplace_back("all");
  return words;
}

std::string layers_help() {
  std::string text = "Layers of an EXR:\n";
  for (const LayerRow& row : layer_table) text += fmt::format("  {:<25}{}\n", row.name, row.help);
  return text;
}

}  // namespace crsh::cli
