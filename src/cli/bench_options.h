#pragma once
// What the command line of `crsh bench` says.

#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "bench/sweep.h"
#include "cli/command.h"
#include "cli/render_options.h"

namespace crsh::cli {

/// An option of `crsh render` with the value that was given for it.
struct Given {
  std::string key, value;
};

/// --vary OPTION=V1,V2
struct Vary {
  std::string key;
  std::vector<std::string> values;
};

/// SCENE, with options of its own behind its path.
struct BenchScene {
  std::string path;
  std::vector<Given> given;
};

struct BenchCommand {
  std::vector<BenchScene> scenes;
  std::vector<std::string> algorithms;
  std::vector<Vary> vary;
  std::vector<bench::SweepAxis> sweeps;
  std::optional<std::vector<std::string>> ablate;  ///< presets; none: ours, for a report
  std::vector<Given> given;                        ///< for every scene
  RenderCommand common;                            ///< what they say: device, time, progress
  bench::Schedule schedule;
  std::optional<float> budget;  ///< seconds, 0: none; not given: usual_budget, unless --repeat is given
  bool repeats_as_given = false;
  bench::RayFilter count;
  std::string json, csv, report;  ///< paths, "-" or empty
};

/// Of the time that measuring takes, seconds.
inline constexpr float usual_budget = 120;
[[nodiscard]] double budget_of(const BenchCommand& command);

/// All tables, bound to `command`.
[[nodiscard]] std::vector<OptionGroup> bench_options(BenchCommand& command);

/// SCENE as it stands on the command line: a path, or a path and options between quotes. Throws UserError (wrong
/// usage).
[[nodiscard]] BenchScene parse_scene(const std::string& text);

/// A scene's variants: every algorithm with every combination of --vary.
[[nodiscard]] std::vector<bench::Variant> variants_of(const BenchCommand& command, const BenchScene& scene);

/// Where the paper's preset stands among them by itself, it is counted, not timed, with equation 9 as printed, too; not
/// where switches are varied or cones are tested as the command says.
void add_as_printed(const BenchCommand& command, const BenchScene& scene, std::vector<bench::Variant>& variants);

/// Whether switches do not matter to this preset, because it has no nodes.
[[nodiscard]] bool ignores_switches(const std::string& algorithm);

/// Whether it is a preset with better nodes than the paper's.
[[nodiscard]] bool goes_beyond_paper(const std::string& algorithm);

/// `algorithm` on this scene as it is, then with each of its switches, one at a time, as the paper has it, or off.
[[nodiscard]] std::vector<bench::Variant> ablations_of(const BenchCommand& command, const BenchScene& scene,
                                                       const std::string& algorithm);

/// Every effective option of the variant, by its name.
[[nodiscard]] nlohmann::ordered_json effective_options(const BenchCommand& command, const bench::Variant& variant);

/// Throws UserError where options do not go together or an output could not be written.
void check_bench(const BenchCommand& command);

}  // namespace crsh::cli
