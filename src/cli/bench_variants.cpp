// The variants of `crsh bench`: presets with every combination of --vary, and with their switches set back one by one.

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>

#include "cli/bench_options.h"
#include "cli/render_checks.h"
#include "cli/values.h"
#include "trace/tracers.h"

namespace crsh::cli {
namespace {

constexpr const char* papers_preset = "crsh-2017";

/// Sets the rows that are given, in the order of the table, as the command line does.
void give_all(const std::vector<Given>& given, RenderCommand& render) {
  for (const OptionGroup& group : render_options(render))
    for (const Option& option : group.options)
      for (const Given& one : given)
        if (one.key == option.key()) option.set(one.value);
}

bool is_switch(const std::string& key) {
  AlgorithmOptions scratch;
  const OptionGroup group = algorithm_options(scratch);
  return std::ranges::any_of(group.options, [&](const Option& option) { return option.key() == key; });
}

/// One value of each --vary.
using Picks = std::vector<Given>;

std::vector<Picks> combinations(const std::vector<Vary>& vary) {
  std::vector<Picks> all = {{}};
  for (const Vary& one : vary) {
    std::vector<Picks> longer;
    for (const Picks& picks : all)
      for (const std::string& value : one.values) {
        longer.push_back(picks);
        longer.back().push_back({one.key, value});
      }
    all = std::move(longer);
  }
  return all;
}

/// Drops switches that do not matter: a preset without nodes runs only once for all values of a switch.
void drop_idle_switches(const std::string& algorithm, Picks& picks) {
  if (ignores_switches(algorithm)) std::erase_if(picks, [](const Given& pick) { return is_switch(pick.key); });
}

bench::Variant variant_of(const BenchCommand& command, const BenchScene& scene, const std::string& algorithm,
                          const Picks& picks) {
  bench::Variant variant{.label = algorithm};
  std::vector<Given> given = {{"algorithm", algorithm}};
  for (const auto* list : {&scene.given, &command.given, &picks}) given.insert(given.end(), list->begin(), list->end());
  RenderCommand render;
  give_all(given, render);
  for (const Given& pick : picks) {
    variant.label += fmt::format(" {}={}", pick.key, pick.value);
    variant.vary[pick.key] = pick.value;
    if (!is_switch(pick.key)) variant.rays += fmt::format("{}={};", pick.key, pick.value);
  }
  check_time(render);
  check_view(render.options.view, render.options.camera);
  variant.options = render.options;
  variant.seconds.clear();
  for (const FrameTask& task : frame_tasks(render)) variant.seconds.push_back(task.seconds);
  const nlohmann::ordered_json values = effective_options(render_options(render));
  for (const char* key : {"time", "frames", "fps"}) variant.when[key] = values.at(key);
  return variant;
}

/// The values that set a switch of `own` back to the paper's, or switch off what the paper has, too; none where there
/// is nothing to do.
Picks back_to_paper(const Option& own, const Option& papers) {
  const nlohmann::ordered_json value = own.get(), back = papers.get();
  if (value == back) return value == "on" ? Picks{{own.key(), "off"}} : Picks{};
  if (!back.is_object()) return {{own.key(), text_of(back)}};
  Picks picks;
  for (const auto& [kind, part] : back.items()) picks.push_back({own.key(), fmt::format("{}={}", kind, text_of(part))});
  return picks;
}

/// The picks that a label names: "levels=2", or each kind's where they differ.
std::string label_of(const Picks& picks) {
  std::vector<std::string> values;
  for (const Given& pick : picks) {
    const std::string value = picks.size() > 1 ? pick.value.substr(pick.value.find('=') + 1) : pick.value;
    if (std::ranges::find(values, value) == values.end()) values.push_back(value);
  }
  return fmt::format("{}={}", picks.front().key, fmt::join(values, ","));
}

}  // namespace

bool ignores_switches(const std::string& algorithm) { return !trace::tracer_of(preset(algorithm)).needs.sorted_rays; }

std::vector<bench::Variant> variants_of(const BenchCommand& command, const BenchScene& scene) {
  std::vector<bench::Variant> variants;
  for (const std::string& algorithm : command.algorithms)
    for (Picks picks : combinations(command.vary)) {
      drop_idle_switches(algorithm, picks);
      bench::Variant variant = variant_of(command, scene, algorithm, picks);
      const auto same = [&](const bench::Variant& other) { return other.label == variant.label; };
      if (std::ranges::none_of(variants, same)) variants.push_back(std::move(variant));
    }
  return variants;
}

void add_as_printed(const BenchCommand& command, const BenchScene& scene, std::vector<bench::Variant>& variants) {
  const auto chosen = [](const std::vector<Given>& given) {
    return std::ranges::any_of(given, [](const Given& one) { return one.key == "cone-test" || one.key == "bound"; });
  };
  if (!command.vary.empty() || chosen(command.given) || chosen(scene.given)) return;
  const auto papers = std::ranges::find(variants, std::string(papers_preset), &bench::Variant::label);
  if (papers == variants.end()) return;
  bench::Variant printed = variant_of(command, scene, papers_preset, {{"cone-test", "printed"}});
  printed.timed = false;
  variants.insert(papers + 1, std::move(printed));
}

bool goes_beyond_paper(const std::string& algorithm) {
  return algorithm.starts_with("crsh") && algorithm != papers_preset && !ignores_switches(algorithm);
}

std::vector<bench::Variant> ablations_of(const BenchCommand& command, const BenchScene& scene,
                                         const std::string& algorithm) {
  AlgorithmOptions own = preset(algorithm), papers = preset(papers_preset);
  const OptionGroup own_rows = algorithm_options(own), paper_rows = algorithm_options(papers);
  std::vector<bench::Variant> variants = {variant_of(command, scene, algorithm, {})};
  for (size_t i = 0; i < own_rows.options.size(); ++i) {
    const Option& row = own_rows.options[i];
    const Picks picks = row.key() == "algorithm" ? Picks{} : back_to_paper(row, paper_rows.options[i]);
    if (picks.empty()) continue;
    variants.push_back(variant_of(command, scene, algorithm, picks));
    variants.back().label = label_of(picks);
  }
  return variants;
}

nlohmann::ordered_json effective_options(const BenchCommand& command, const bench::Variant& variant) {
  RenderCommand render = command.common;
  render.options = variant.options;
  nlohmann::ordered_json values = effective_options(render_options(render));
  values.update(variant.when);
  return values;
}

}  // namespace crsh::cli
