#include "cli/bench_options.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <sstream>

#include "cli/rows.h"
#include "crsh/error.h"
#include "output/whole_file.h"

namespace crsh::cli {
namespace {

/// Options of `crsh render` that say where a picture goes, or what the bench has its own options for.
bool is_render_only(const Option& option) {
  static const std::vector<std::string> keys = {"output", "layers", "stats", "dump-rays", "replay-rays", "algorithm"};
  return std::ranges::find(keys, option.key()) != keys.end();
}

/// A row that also remembers its values, so that each variant can be given them.
Option remembered(Option option, std::vector<Given>& given) {
  const auto set = option.set;
  const std::string key = option.key();
  option.set = [set, key, &given](const std::string& value) {
    set(value);
    given.push_back({key, value});
  };
  return option;
}

std::vector<OptionGroup> render_groups(RenderCommand& render, std::vector<Given>& given) {
  std::vector<OptionGroup> groups;
  for (OptionGroup& group : render_options(render)) {
    OptionGroup kept{group.title, {}};
    for (Option& option : group.options)
      if (!is_render_only(option)) kept.options.push_back(remembered(std::move(option), given));
    if (!kept.options.empty()) groups.push_back(std::move(kept));
  }
  return groups;
}

/// What may follow a scene's path between quotes: not what the whole run shares.
std::vector<OptionGroup> scene_groups(RenderCommand& render, std::vector<Given>& given) {
  std::vector<OptionGroup> groups = render_groups(render, given);
  std::erase_if(groups, [](const OptionGroup& group) {
    return group.title != "Picture" && group.title != "Scene and view" && group.title != "Time";
  });
  return groups;
}

std::vector<std::string> algorithm_words() {
  std::vector<std::string> words;
  for (const Preset& row : preset_table()) words.emplace_back(row.name);
  return words;
}

Option algorithms_row(std::vector<std::string>& algorithms) {
  return {.names = "--algorithms",
          .value = "LIST",
          .help = "Presets to compare, with commas between.",
          .set =
              [&algorithms](const std::string& text) {
                std::vector<std::string> names = split(text, ',');
                for (size_t i = 0; i < names.size(); ++i) {
                  (void)preset(names[i]);
                  if (std::find(names.begin(), names.begin() + static_cast<std::ptrdiff_t>(i), names[i]) !=
                      names.begin() + static_cast<std::ptrdiff_t>(i))
                    refuse(fmt::format("{} stands twice", names[i]));
                }
                algorithms = std::move(names);
              },
          .initial = fmt::format("{}", fmt::join(algorithms, ",")),
          .words = algorithm_words()};
}

/// What all variants of a scene share: the scene itself, and the device.
bool is_shared(const std::string& group, const Option& option) {
  return group == "Device" || group == "Output" || option.key() == "scene" || option.key() == "hide";
}

/// The row of this name that may differ between variants.
const Option* find_varied(const std::vector<OptionGroup>& groups, const std::string& key) {
  for (const OptionGroup& group : groups)
    for (const Option& option : group.options)
      if (option.key() == key && !option.hidden && !is_shared(group.title, option)) return &option;
  return nullptr;
}

/// OPTION=V1,V2; semicolons where values have commas.
Vary parse_vary(const std::string& text) {
  const std::string body = text.substr(std::min(text.find_first_not_of('-'), text.size()));
  const size_t equals = body.find('=');
  if (equals == std::string::npos || equals + 1 == body.size())
    refuse("OPTION=VALUE,VALUE is allowed, as in arity=4,8 (semicolons between values that have commas)");
  const std::string values = body.substr(equals + 1);
  Vary vary{body.substr(0, equals), split(values, values.find(';') == std::string::npos ? ',' : ';')};
  RenderCommand scratch;
  std::vector<Given> given;
  const auto groups = render_groups(scratch, given);
  const Option* row = find_varied(groups, vary.key);
  if (!row) refuse(fmt::format("{}: no option that can be varied", vary.key));
  for (const std::string& value : vary.values) row->set(value);
  return vary;
}

Option vary_row(std::vector<Vary>& vary) {
  return {.names = "--vary",
          .value = "OPTION=V1,V2",
          .help = "Run every algorithm with each of these values. Repeats: every combination is run.",
          .set = [&vary](const std::string& text) { vary.push_back(parse_vary(text)); },
          .repeats = true};
}

/// KIND[:BOUNCE]
bench::CountedRays parse_counted(const std::string& text) {
  std::vector<std::string> names;
  for (const RayKind& kind : ray_kinds) names.emplace_back(kind.name);
  const std::vector<std::string> parts = split(text, ':');
  bench::CountedRays counted{parse_choice(parts[0], names), {}};
  if (parts.size() > 2) refuse("KIND or KIND:BOUNCE is allowed, as in shadow:0,reflection");
  if (parts.size() == 2) counted.bounce = static_cast<uint32_t>(parse_integer(parts[1], 0, 64));
  return counted;
}

Option count_row(bench::RayFilter& filter) {
  return {.names = "--count",
          .value = "KIND[:BOUNCE],...",
          .help = "The rays that Tables 1 and 2 count, as in shadow:0,reflection.",
          .set =
              [&filter](const std::string& text) {
                filter.clear();
                for (const std::string& part : split(text, ',')) filter.push_back(parse_counted(part));
              },
          .initial = "all"};
}

Option ablate_row(std::optional<std::vector<std::string>>& ablate) {
  std::vector<std::string> words = preset_names();
  words.emplace_back("none");
  return {
      .names = "--ablate",
      .value = "LIST",
      .help =
          "Presets whose switches are set back one by one, to show what each is worth, with commas between; or none.",
      .set =
          [&ablate](const std::string& text) {
            ablate.emplace();
            if (text == "none") return;
            for (const std::string& name : split(text, ',')) {
              if (ignores_switches(name)) refuse(fmt::format("{} has no switches", name));
              ablate->push_back(name);
            }
          },
      .initial = "with --report those of --algorithms that go beyond the paper",
      .words = words};
}

Option sweep_row(std::vector<bench::SweepAxis>& sweeps) {
  return {
      .names = "--sweep",
      .value = "LIST",
      .help =
          "How cost grows with triangles, pixels or lights, with commas between: as curves in the report. A tenth of "
          "--repeat's frames each.",
      .set =
          [&sweeps](const std::string& text) {
            sweeps.clear();
            for (const std::string& name : split(text, ','))
              sweeps.push_back(static_cast<bench::SweepAxis>(parse_choice(name, bench::sweep_names)));
          },
      .initial = "none",
      .words = bench::sweep_names};
}

/// Remembers that it was given.
Option repeat_row(BenchCommand& command) {
  Option row = integer("--repeat", "N",
                       "Timed frames of each, in turn with the others; with --frames so many times all of those.",
                       command.schedule.repeat, 1, 100000);
  row.set = [set = row.set, &command](const std::string& text) {
    set(text);
    command.repeats_as_given = true;
  };
  return row;
}

Option budget_row(std::optional<float>& budget) {
  return {.names = "--budget",
          .value = "SECONDS",
          .help =
              "Time that measuring may take: frames are repeated less often, and brute force is counted and not "
              "traced, where more would not fit. Each is rendered once in any case; sweeps and ablations come on top. "
              "0: no bound.",
          .set = [&budget](const std::string& text) { budget = parse_real(text, 0, 1e7f); },
          .initial = fmt::format("{}, or 0 where --repeat is given", usual_budget)};
}

OptionGroup own_options(BenchCommand& command) {
  return {
      "Bench",
      {algorithms_row(command.algorithms), vary_row(command.vary), repeat_row(command), budget_row(command.budget),
       integer("--warmup", "N", "As many more that are rendered first and not timed.", command.schedule.warmup, 0,
               100000),
       count_row(command.count), ablate_row(command.ablate), sweep_row(command.sweeps),
       text("--report", "FILE.html", "Write tables, charts and pictures as one page that needs no network.",
            command.report),
       text(
           "--json", "FILE|-",
           "Write every run's statistics: an object of schema crsh-bench/1, whose \"runs\" are a list of crsh-stats/1.",
           command.json),
       text("--csv", "FILE|-", "Write counters of a frame, or of all --frames together, and median times as a table.",
            command.csv)}};
}

[[noreturn]] void misuse(const std::string& message) { throw UserError(message, Exit::usage); }

}  // namespace

double budget_of(const BenchCommand& command) {
  return double(command.budget.value_or(command.repeats_as_given ? 0 : usual_budget));
}

std::vector<OptionGroup> bench_options(BenchCommand& command) {
  command.algorithms = preset_names();
  std::vector<OptionGroup> groups = render_groups(command.common, command.given);
  groups.insert(groups.begin(), own_options(command));
  return groups;
}

BenchScene parse_scene(const std::string& text) {
  const size_t dashes = text.find(" --");
  if (dashes == std::string::npos || std::filesystem::exists(text)) return {text, {}};
  BenchScene scene{text.substr(0, text.find_last_not_of(' ', dashes) + 1), {}};
  std::istringstream stream(text.substr(dashes));
  std::vector<std::string> words;
  for (std::string word; stream >> word;) words.push_back(word);
  RenderCommand scratch;
  try {
    const Command own{.name = "bench",
                      .summary = "",
                      .positionals = {},
                      .groups = scene_groups(scratch, scene.given),
                      .epilogue = "",
                      .run = {}};
    if (!parse(own, words)) misuse("--help is no option of a scene");
  } catch (const UserError& error) {
    throw UserError(fmt::format("'{}': {}", text, error.what()), error.status());
  }
  return scene;
}

void check_bench(const BenchCommand& command) {
  if (!command.report.empty() && command.report != "-" && !command.report.ends_with(".html"))
    misuse(fmt::format("--report {}: a path that ends in .html is allowed, or -", command.report));
  std::vector<std::string> paths;
  for (const std::string* path : {&command.json, &command.csv, &command.report}) {
    if (path->empty()) continue;
    const std::string normal = std::filesystem::path(*path).lexically_normal();
    if (std::ranges::find(paths, normal) != paths.end())
      misuse(*path == "-" ? "two outputs on standard output: give one of them a file"
                          : *path + ": two outputs into one file");
    paths.push_back(normal);
    if (*path != "-") output::check_writable(*path);
  }
}

}  // namespace crsh::cli
