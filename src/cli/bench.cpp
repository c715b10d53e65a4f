// crsh bench: renders in several ways in turn, and says what each took.

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <memory>

#include "bench/ablation.h"
#include "bench/binned_sah.h"
#include "bench/data.h"
#include "bench/paper_tables.h"
#include "bench/report.h"
#include "cli/bench_options.h"
#include "cli/load_scene.h"
#include "cli/mend.h"
#include "cli/say.h"
#include "crsh/error.h"
#include "output/json_text.h"
#include "output/progress.h"
#include "output/whole_file.h"
#include "scene/hide.h"
#include "scene/scene.h"

namespace crsh::cli {
namespace {

const char* const notes =
    "Several scenes become columns of one table. A scene's own options follow its\n"
    "path between quotes; all others are for every scene. Frames of all algorithms\n"
    "take turns, so that none has the quieter machine, and times are medians. Brute\n"
    "force is counted, not traced, where tracing would take too long. Table 1 counts\n"
    "crsh-2017 also with --cone-test printed, unless --vary or --cone-test is given.\n"
    "\n"
    "Examples:\n"
    "  crsh bench scene.glb\n"
    "  crsh bench scene.glb --algorithms rah,crsh --vary arity=4,8 --vary levels=2,3\n"
    "  crsh bench 'a.glb --light 0,5,0' 'b.glb --eye 1,2,5' --json all.json\n";

void say(const BenchCommand& command, const std::string& line) { say(command.common, line); }

/// The file's name without its ending; with a number where another scene has it.
std::string name_of(const BenchCommand& command, size_t scene) {
  const auto stem = [&](size_t i) { return std::filesystem::path(command.scenes[i].path).stem().string(); };
  size_t before = 0, all = 0;
  for (size_t i = 0; i < command.scenes.size(); ++i) {
    all += stem(i) == stem(scene);
    before += i < scene && stem(i) == stem(scene);
  }
  return all > 1 ? fmt::format("{} {}", stem(scene), before + 1) : stem(scene);
}

/// Whether the flag of this name is given for the scene.
bool is_given(const BenchScene& scene, std::string_view flag) {
  return std::ranges::any_of(scene.given, [flag](const Given& one) { return one.key == flag && one.value == "true"; });
}

scene::LoadOptions load_options(const BenchCommand& command, const BenchScene& scene, const RenderOptions& options) {
  return {.scene = options.scene,
          .reach = reach_of(command.common.allow_outside || is_given(scene, "allow-outside")),
          .variant = options.variant,
          .lenient = command.common.lenient || is_given(scene, "lenient")};
}

/// Loads all scenes before anything is measured, so that a wrong path is reported at once.
std::vector<scene::Scene> load_scenes(const BenchCommand& command) {
  std::vector<scene::Scene> scenes;
  for (const BenchScene& asked : command.scenes) {
    const RenderOptions options = variants_of(command, asked).front().options;
    scenes.push_back(load_scene(asked.path, load_options(command, asked, options)));
    scene::hide(scenes.back(), options.hidden);
    if (const auto& missing = scenes.back().unsupported; !missing.empty())
      say(command, fmt::format("{}: not supported and left out: {}", asked.path, fmt::join(missing, "; ")));
  }
  return scenes;
}

/// What all measurements share: the device, the scenes, the progress.
struct Stage {
  gpu::Device& device;
  const std::vector<scene::Scene>& scenes;
  output::Progress& progress;
  uint32_t parts = 0;  ///< begun
  std::chrono::steady_clock::time_point start = std::chrono::steady_clock::now();
  [[nodiscard]] double seconds() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  }
  /// Progress of the next part of the whole.
  [[nodiscard]] bench::Progress next() {
    return [this, part = parts++](double done) { progress.update(part, part, done); };
  }
};

struct Found {
  std::vector<bench::SceneResults> scenes;
  std::vector<bench::Table> ablations;
  std::vector<bench::ChartSection> sweeps;
  std::vector<bench::Table> others;
};

/// What this scene may take of the budget: its share of what those before it have left.
bench::Schedule schedule_of(const BenchCommand& command, size_t index, Stage& stage) {
  bench::Schedule schedule = command.schedule;
  if (schedule.budget_seconds <= 0) return schedule;
  schedule.budget_seconds =
      std::max(schedule.budget_seconds - stage.seconds(), 1e-3) / double(command.scenes.size() - index);
  schedule.say = [&command, &stage, name = name_of(command, index)](const std::string& line) {
    stage.progress.clear();
    say(command, fmt::format("{}: {}", name, line));
  };
  return schedule;
}

bench::SceneResults run_scene(const BenchCommand& command, size_t index, Stage& stage) {
  const BenchScene& asked = command.scenes[index];
  std::vector<bench::Variant> variants = variants_of(command, asked);
  add_as_printed(command, asked, variants);
  return {
      name_of(command, index), asked.path,
      bench::measure(stage.device, stage.scenes[index], variants, schedule_of(command, index, stage), stage.next())};
}

void write_to(const std::string& path, const std::string& bytes, output::Progress& progress) {
  if (path.empty()) return;
  path == "-" ? output::write_stdout(bytes) : output::write_whole(path, bytes);
  progress.written(path);
}

/// Counts one pass of each variant; nothing is timed. Variants that a preset does not allow are left out, with a line
/// that says so.
bench::Table ablate(const BenchCommand& command, const std::string& algorithm, Stage& stage) {
  std::vector<bench::SceneResults> results;
  for (size_t i = 0; i < command.scenes.size(); ++i) {
    results.push_back({name_of(command, i), command.scenes[i].path, {}});
    const std::vector<bench::Variant> variants = ablations_of(command, command.scenes[i], algorithm);
    const bench::Progress progress = stage.next();
    for (size_t v = 0; v < variants.size(); ++v) {
      const auto part = [&](double done) { progress((double(v) + done) / double(variants.size())); };
      try {
        auto measured = bench::measure(stage.device, stage.scenes[i], {variants[v]}, {.warmup = 0, .repeat = 0}, part);
        results.back().results.push_back(std::move(measured.front()));
      } catch (const UserError& error) {
        if (error.status() != Exit::usage) throw;
        stage.progress.clear();
        say(command, fmt::format("{} {} is left out: {}", algorithm, variants[v].label, line_of(error)));
      }
    }
  }
  return bench::ablation_table(results, command.count);
}

/// Measures the sweep of each scene, with a tenth of the frames.
std::vector<bench::ChartSection> sweep(const BenchCommand& command, bench::SweepAxis axis, Stage& stage) {
  bench::Schedule schedule = command.schedule;
  schedule.repeat = std::max(1u, schedule.repeat / 10);
  schedule.budget_seconds = 0;
  schedule.pictures = false;
  std::vector<bench::ChartSection> sections;
  for (size_t i = 0; i < stage.scenes.size(); ++i) {
    const auto variants = variants_of(command, command.scenes[i]);
    const auto steps = bench::sweep(axis, stage.device, stage.scenes[i], variants, schedule, stage.next());
    sections.push_back(bench::sweep_section(axis, name_of(command, i), steps));
  }
  return sections;
}

/// Measures how good the object hierarchies are, where there are any.
void judge_hierarchies(const Stage& stage, Found& found) {
  const auto has_one = [](const bench::Result& result) { return bench::has_object_hierarchy(result.variant); };
  if (std::ranges::none_of(found.scenes.front().results, has_one)) return;
  std::vector<double> binned;
  for (size_t i = 0; i < stage.scenes.size(); ++i)
    binned.push_back(
        bench::binned_sah_cost(bench::world_boxes(stage.scenes[i], found.scenes[i].results.front().variant)));
  found.others.push_back(bench::sah_table(found.scenes, binned));
}

/// The presets that --ablate names; without it, for a report, all that go beyond the paper.
std::vector<std::string> presets_to_ablate(const BenchCommand& command) {
  if (command.ablate) return *command.ablate;
  std::vector<std::string> presets;
  for (const std::string& name : command.algorithms)
    if (!command.report.empty() && goes_beyond_paper(name)) presets.push_back(name);
  return presets;
}

std::string tables_text(const BenchCommand& command, const Found& found) {
  std::string text = bench::text_of(bench::table_1(found.scenes, command.count)) + "\n";
  for (const bench::SceneResults& scene : found.scenes)
    text += bench::text_of(bench::table_2(scene, command.count)) + "\n";
  text += bench::text_of(bench::table_3(found.scenes));
  for (const bench::Table& table : found.ablations) text += "\n" + bench::text_of(table);
  for (const bench::Table& table : found.others) text += "\n" + bench::text_of(table);
  for (const bench::ChartSection& section : found.sweeps) text += "\n" + bench::text_of(section.table);
  for (const bench::SceneResults& scene : found.scenes) text += "\n" + bench::verdict(scene, command.count);
  return text + "\n";
}

/// Prints the tables on standard output, or on standard error where other data goes to standard output.
void show_tables(const BenchCommand& command, const std::string& text) {
  if (command.json != "-" && command.csv != "-" && command.report != "-") return output::write_stdout(text);
  say(command, text);
}

void write_files(const BenchCommand& command, const std::vector<std::string>& line, const Found& found, Stage& stage) {
  const bench::Description description{line, stage.device.info(), command.schedule, [&](const bench::Variant& variant) {
                                         return effective_options(command, variant);
                                       }};
  if (!command.json.empty())
    write_to(command.json, output::json_text(bench::bench_json(description, found.scenes)), stage.progress);
  if (!command.csv.empty()) write_to(command.csv, bench::bench_csv(found.scenes), stage.progress);
  if (!command.report.empty())
    write_to(
        command.report,
        bench::report_html({description, found.scenes, command.count, found.ablations, found.sweeps, found.others}),
        stage.progress);
}

void run_bench(BenchCommand& command, const std::vector<std::string>& line) {
  check_bench(command);
  command.schedule.pictures = !command.report.empty();
  command.schedule.exposure = command.common.exposure;
  command.schedule.budget_seconds = budget_of(command);
  const std::vector<scene::Scene> scenes = load_scenes(command);
  if (command.common.progress == ProgressChoice::json)
    command.common.device.on_validation = [&command](const std::string& message) { say(command.common, message); };
  gpu::Device device(command.common.device);
  say(command, fmt::format("device: {} ({} {}), {}", device.info().name, device.info().driver,
                           device.info().driver_version, device.info().type));
  const std::vector<std::string> ablated = presets_to_ablate(command);
  const auto parts = static_cast<uint32_t>(scenes.size() * (1 + ablated.size() + command.sweeps.size()));
  output::Progress progress(progress_mode(command.common), parts);
  Stage stage{device, scenes, progress};
  Found found;
  for (size_t i = 0; i < scenes.size(); ++i) found.scenes.push_back(run_scene(command, i, stage));
  for (const std::string& algorithm : ablated) found.ablations.push_back(ablate(command, algorithm, stage));
  for (const bench::SweepAxis axis : command.sweeps)
    for (bench::ChartSection& section : sweep(command, axis, stage)) found.sweeps.push_back(std::move(section));
  judge_hierarchies(stage, found);
  progress.clear();
  write_files(command, line, found, stage);
  show_tables(command, tables_text(command, found));
}

}  // namespace

Command bench_command() {
  auto command = std::make_shared<BenchCommand>();
  return {.name = "bench",
          .summary = "Compares algorithms: tests and times of each, as the paper's Tables 1 to 3.",
          .positionals = {{.name = "SCENE",
                           .set = [command](const std::string& text) { command->scenes.push_back(parse_scene(text)); },
                           .repeats = true}},
          .groups = bench_options(*command),
          .epilogue = notes,
          .run = [command](const std::vector<std::string>& line) { run_bench(*command, line); }};
}

}  // namespace crsh::cli
