// crsh bench: renders in several ways in turn, and says what each took.

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <unistd.h>

#include <filesystem>
#include <memory>

#include "bench/data.h"
#include "bench/paper_tables.h"
#include "cli/bench_options.h"
#include "error.h"
#include "output/json_text.h"
#include "output/progress.h"
#include "output/whole_file.h"
#include "scene/scene.h"

namespace crsh::cli {
namespace {

const char* const notes =
    "Several scenes become columns of one table. A scene's own options follow its\n"
    "path between quotes; all others are for every scene. Frames of all algorithms\n"
    "take turns, so that none has the quieter machine, and times are medians. Brute\n"
    "force is counted, not traced, where tracing would take minutes.\n"
    "\n"
    "Examples:\n"
    "  crsh bench scene.glb\n"
    "  crsh bench scene.glb --algorithms rah,crsh --vary arity=4,8 --vary levels=2,3\n"
    "  crsh bench 'a.glb --light 0,5,0' 'b.glb --eye 1,2,5' --json all.json\n";

/// A line on standard error, unless --quiet.
void say(const BenchCommand& command, const std::string& line) {
  if (!command.common.quiet) fmt::print(stderr, "{}\n", line);
}

output::Progress::Mode progress_mode(const RenderCommand& command) {
  using Mode = output::Progress::Mode;
  if (command.progress == ProgressChoice::json) return Mode::json;
  const bool shown = command.progress == ProgressChoice::automatic && !command.quiet && ::isatty(STDERR_FILENO);
  return shown ? Mode::bar : Mode::none;
}

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

/// All of them, before anything is measured: a wrong path is known at once.
std::vector<scene::Scene> load_scenes(const BenchCommand& command) {
  std::vector<scene::Scene> scenes;
  for (const BenchScene& asked : command.scenes) {
    scenes.push_back(scene::load(asked.path, variants_of(command, asked).front().options.scene));
    if (const auto& missing = scenes.back().unsupported; !missing.empty())
      say(command, fmt::format("{}: not supported and left out: {}", asked.path, fmt::join(missing, "; ")));
  }
  return scenes;
}

bench::SceneResults run_scene(const BenchCommand& command, size_t index, gpu::Device& device, const scene::Scene& scene,
                              output::Progress& progress) {
  const BenchScene& asked = command.scenes[index];
  const auto number = static_cast<uint32_t>(index);
  const auto show = [&](double done) { progress.update(number, number, done); };
  return {name_of(command, index), asked.path,
          bench::measure(device, scene, variants_of(command, asked), command.schedule, show)};
}

void write_to(const std::string& path, const std::string& bytes, output::Progress& progress) {
  if (path.empty()) return;
  path == "-" ? output::write_stdout(bytes) : output::write_whole(path, bytes);
  progress.written(path);
}

std::string tables_text(const BenchCommand& command, const std::vector<bench::SceneResults>& scenes) {
  std::string text = bench::text_of(bench::table_1(scenes, command.count)) + "\n";
  for (const bench::SceneResults& scene : scenes) text += bench::text_of(bench::table_2(scene, command.count)) + "\n";
  return text + bench::text_of(bench::table_3(scenes));
}

/// The tables are data, unless other data has standard output.
void show_tables(const BenchCommand& command, const std::string& text) {
  if (command.json != "-" && command.csv != "-") return output::write_stdout(text);
  say(command, text);
}

void run_bench(BenchCommand& command, const std::vector<std::string>& line) {
  check_bench(command);
  const std::vector<scene::Scene> loaded = load_scenes(command);
  gpu::Device device(command.common.device);
  say(command, fmt::format("device: {} ({} {}), {}", device.info().name, device.info().driver,
                           device.info().driver_version, device.info().type));
  output::Progress progress(progress_mode(command.common), static_cast<uint32_t>(command.scenes.size()));
  std::vector<bench::SceneResults> scenes;
  for (size_t i = 0; i < command.scenes.size(); ++i)
    scenes.push_back(run_scene(command, i, device, loaded[i], progress));
  progress.clear();
  const bench::Description description{line, device.info(), command.schedule, [&](const bench::Variant& variant) {
                                         return effective_options(command, variant);
                                       }};
  if (!command.json.empty())
    write_to(command.json, output::json_text(bench::bench_json(description, scenes)), progress);
  if (!command.csv.empty()) write_to(command.csv, bench::bench_csv(scenes), progress);
  show_tables(command, tables_text(command, scenes));
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
