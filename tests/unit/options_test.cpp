// Presets, and the table of render's options.

#include <doctest/doctest.h>

#include "cli/render_options.h"
#include "cli/values.h"
#include "crsh/error.h"
#include "crsh/options.h"
#include "support/kinds.h"

namespace crsh {
namespace {

using doctest::Contains;

/// The command that these arguments give.
struct Parsed {
  cli::RenderCommand command;
  std::vector<cli::OptionGroup> groups = cli::render_options(command);
  explicit Parsed(const std::vector<std::string>& arguments) {
    const cli::Command table{
        .name = "render", .summary = {}, .positionals = {}, .groups = groups, .epilogue = {}, .run = {}};
    const bool parsed = cli::parse(table, arguments);
    REQUIRE(parsed);
  }
  Parsed(const Parsed&) = delete;
  Parsed& operator=(const Parsed&) = delete;
};

TEST_CASE("the presets are those of the design") {
  CHECK(preset("brute").tracer == "brute");
  CHECK(preset("bvh").tracer == "single-rays");
  const AlgorithmOptions rah = preset("rah");
  CHECK(rah.keys[0].empty());
  CHECK(rah.ray_order == RayOrder::tiles);
  CHECK_FALSE(rah.mesh_culling);
  CHECK(rah.interval);
  const AlgorithmOptions paper = preset("crsh-2017");
  CHECK(paper.keys[2] == "spherical");
  CHECK(paper.compression);
  CHECK(paper.fit == Fit::merged);
  CHECK_FALSE(paper.interval);
  CHECK(paper.mesh_culling);
  const AlgorithmOptions best = preset("crsh");
  CHECK(best.keys[0] == ray_kinds[0].best_key);
  CHECK_FALSE(best.compression);
  CHECK(rah.levels[0] == 2);
  CHECK(paper.levels[0] == 2);
  for (const std::string& name : preset_names()) {
    CHECK(preset(name).preset == name);
    CHECK(preset(name).arity == 8);
  }
  CHECK(preset(default_preset).preset == default_preset);
  for (const Preset& row : preset_table()) {
    CHECK(row.options().tracer == preset(row.name).tracer);
    CHECK(cli::presets_help().find(row.help) != std::string::npos);
  }
  CHECK_THROWS_WITH_AS((void)preset("bvh9"), Contains("brute, bvh, rah, crsh-2017, crsh, crsh-bvh, ray-query"),
                       UserError);
}

TEST_CASE("the default algorithm is crsh-bvh") {
  const Parsed parsed({});
  CHECK(parsed.command.options.algorithm.preset == "crsh-bvh");
  CHECK(parsed.command.options.algorithm.keys[0] == ray_kinds[0].best_key);
  CHECK_FALSE(parsed.command.options.algorithm.compression);
}

TEST_CASE("a switch changes one thing of the preset, wherever it stands") {
  const Parsed parsed({"--interval", "on", "--levels", "shadow=3", "--algorithm", "crsh-2017"});
  CHECK(parsed.command.options.algorithm.preset == "crsh-2017");
  CHECK(parsed.command.options.algorithm.interval);
  CHECK(parsed.command.options.algorithm.compression);
  PerKind<uint32_t> levels(2);
  levels[shared::kind_shadow] = 3;
  CHECK(parsed.command.options.algorithm.levels == levels);
}

TEST_CASE("a key is of one kind or of all, and best is each kind's own") {
  const Parsed parsed({"--key", "spherical", "--key", "shadow=best"});
  const auto& keys = parsed.command.options.algorithm.keys;
  CHECK(keys[0] == ray_kinds[0].best_key);
  CHECK(keys[1] == "spherical");
}

TEST_CASE("best is the algorithm's own key, wherever it stands, and the kind's where the algorithm does not sort") {
  for (const std::string& name : preset_names()) {
    CAPTURE(name);
    const AlgorithmOptions own = preset(name);
    for (const std::vector<std::string>& arguments :
         {std::vector<std::string>{"--key", "best", "--algorithm", name}, {"--algorithm", name, "--key", "best"}}) {
      const Parsed parsed(arguments);
      for (size_t kind = 0; kind < kind_count; ++kind)
        CHECK(parsed.command.options.algorithm.keys[kind] ==
              (own.keys[kind].empty() ? std::string(ray_kinds[kind].best_key) : own.keys[kind]));
    }
  }
  CHECK(Parsed({"--key", "best"}).command.options.algorithm == preset(default_preset));
}

TEST_CASE("the last of a repeated option wins, and repeating ones add up") {
  const Parsed parsed({"--size", "10x20", "--size", "30x40", "--light", "1,2,3", "--light", "4,5,6,70"});
  CHECK(parsed.command.options.width == 30);
  CHECK(parsed.command.options.height == 40);
  REQUIRE(parsed.command.options.lights.size() == 2);
  CHECK_FALSE(parsed.command.options.lights[0].candela);
  CHECK(parsed.command.options.lights[1].candela == 70);
}

TEST_CASE("values are read as they are written") {
  const Parsed parsed({"--eye", "-12,3,0.5", "--exposure", "-1.5", "--background", "none", "--rays", "shadow",
                       "--frames", "3..5", "--max-memory", "256", "--layers", "Z,beauty", "-o", "-", "--seed",
                       "4294967295"});
  const cli::RenderCommand& command = parsed.command;
  CHECK(command.options.view.eye == glm::dvec3(-12, 3, 0.5));
  CHECK(command.exposure == -1.5f);
  CHECK_FALSE(command.options.background);
  CHECK(command.options.rays == test::only({shared::kind_shadow}));
  CHECK(command.device.memory_budget == uint64_t(256) << 20);
  CHECK(command.options.layers == LayerSet{LayerId::beauty, LayerId::depth});
  CHECK(command.outputs[0].to_stdout());
  CHECK(command.options.seed == 4294967295u);
  const auto tasks = cli::frame_tasks(command);
  REQUIRE(tasks.size() == 3);
  CHECK(tasks[2].number == 5);
  CHECK(tasks[2].seconds == doctest::Approx(5 / 24.0));
}

TEST_CASE("a wrong value is wrong usage: one line with the option, the value and what is allowed") {
  const std::vector<std::pair<std::string, std::string>> wrong = {{"--size", "0x0"},
                                                                  {"--size", "100000x100000"},
                                                                  {"--size", "640"},
                                                                  {"--size", "-4x4"},
                                                                  {"--size", "4x4x4"},
                                                                  {"--size", "4 x4"},
                                                                  {"--samples", "0"},
                                                                  {"--samples", "1.5"},
                                                                  {"--samples", "-1"},
                                                                  {"--seed", "4294967296"},
                                                                  {"--bounces", "65"},
                                                                  {"--bounces", ""},
                                                                  {"--fov", "nan"},
                                                                  {"--fov", "180"},
                                                                  {"--fov", "0"},
                                                                  {"--orthographic", "0"},
                                                                  {"--exposure", "inf"},
                                                                  {"--exposure", "1e99"},
                                                                  {"--exposure", "1x"},
                                                                  {"--exposure", " 1"},
                                                                  {"--eye", "1,2"},
                                                                  {"--eye", "1,2,nan"},
                                                                  {"--eye", "1,2,3,4"},
                                                                  {"--up", "0,0,0"},
                                                                  {"--background", "-1,0,0"},
                                                                  {"--background", "black"},
                                                                  {"--rays", "shadows"},
                                                                  {"--rays", ""},
                                                                  {"--light", "1,2"},
                                                                  {"--light", "1,2,3,-4"},
                                                                  {"--time", "-1"},
                                                                  {"--frames", "5"},
                                                                  {"--frames", "5..4"},
                                                                  {"--frames", "-1..4"},
                                                                  {"--fps", "0"},
                                                                  {"--algorithm", "bvh9"},
                                                                  {"--key", "nokey"},
                                                                  {"--key", "eye=best"},
                                                                  {"--ray-order", "random"},
                                                                  {"--compression", "yes"},
                                                                  {"--nodes", "cuts"},
                                                                  {"--arity", "1"},
                                                                  {"--arity", "65"},
                                                                  {"--levels", "0"},
                                                                  {"--levels", "shadow=9"},
                                                                  {"--bound", "box"},
                                                                  {"--fit", "best"},
                                                                  {"--interval", "1"},
                                                                  {"--batches", "none"},
                                                                  {"--max-memory", "0"},
                                                                  {"--submit-work", "65535"},
                                                                  {"--layers", "depth"},
                                                                  {"--progress", "bar"},
                                                                  {"--output", "a.jpg"},
                                                                  {"--output", "{frame:x}.png"}};
  for (const auto& [option, value] : wrong) {
    CAPTURE(option);
    CAPTURE(value);
    try {
      const Parsed parsed({option + "=" + value});
      if (!value.empty()) FAIL("was taken");
    } catch (const UserError& error) {
      const std::string message = error.what();
      CHECK(error.status() == Exit::usage);
      CHECK(message.find(option) != std::string::npos);
      CHECK(message.find(value) != std::string::npos);
      CHECK(message.find('\n') == std::string::npos);
      CHECK(message.size() > option.size() + value.size() + 12);
    }
  }
}

TEST_CASE("unknown options, missing values and surplus arguments are wrong usage") {
  CHECK_THROWS_WITH_AS(Parsed({"--sizes", "1x1"}), Contains("--sizes: no such option"), UserError);
  CHECK_THROWS_WITH_AS(Parsed({"--size"}), Contains("--size: its value is missing"), UserError);
  CHECK_THROWS_WITH_AS(Parsed({"surplus"}), Contains("surplus: one argument too many"), UserError);
}

TEST_CASE("effective options hold every value, and the attributes those that change pixels") {
  Parsed parsed({"--algorithm", "rah", "--eye", "0.1,2,3", "--time", "0.3"});
  const auto all = cli::effective_options(parsed.groups);
  CHECK(all["algorithm"] == "rah");
  CHECK(all["key"]["shadow"] == "creation");
  CHECK(all["ray-order"] == "tiles");
  CHECK(all["levels"]["reflection"] == 2);
  CHECK(all["eye"] == "0.1,2,3");
  CHECK(all["time"].dump() == "0.3");
  CHECK(all["size"].is_null());
  CHECK(all["max-memory"].is_null());
  CHECK_FALSE(all.contains("output"));
  CHECK_FALSE(all.contains("mutation"));
  const auto pixels = cli::effective_options(parsed.groups, true);
  CHECK(pixels.contains("bounces"));
  CHECK(pixels.contains("rays"));
  for (const char* name : {"algorithm", "key", "exposure", "device", "stats", "max-memory"})
    CHECK_FALSE(pixels.contains(name));
}

TEST_CASE("an effective value, given again, changes nothing") {
  const Parsed parsed({"--light", "0.1,2,3,4.5", "--background", "0.5,0.25,0.125", "--rays", "shadow,refraction"});
  const auto values = cli::effective_options(parsed.groups, true);
  std::vector<std::string> again;
  for (const auto& [name, value] : values.items())
    if (name != "override-mirror") again.push_back("--" + name + "=" + cli::text_of(value));
  CHECK(cli::effective_options(Parsed(again).groups, true) == values);
}

TEST_CASE("layers are named alone, with others, by their channels or all at once") {
  const auto chosen = [](const std::string& list) { return Parsed({"--layers", list}).command.options.layers; };
  CHECK(Parsed({}).command.options.layers == default_layers);
  CHECK(chosen("all") == LayerSet::all());
  CHECK(chosen("Z,Direct") == LayerSet{LayerId::depth, layer_named("Direct")});
  CHECK(chosen("Direct.*") == LayerSet{layer_named("Direct")});
  CHECK(chosen("Shadow.Y,Object.id") == LayerSet{LayerId::shadow, layer_named("Object")});
  CHECK(chosen("Tests") ==
        LayerSet{layer_named("Tests.triangle"), layer_named("Tests.node"), layer_named("Tests.object")});
  CHECK(chosen("Tests.node") == LayerSet{layer_named("Tests.node")});
  for (const char* wrong : {"", "z", "Direct.R", "Tests.", "Z,", "Z Direct"}) {
    CAPTURE(wrong);
    CHECK_THROWS_WITH_AS((void)chosen(wrong), Contains("no such layer: choose of beauty, Direct, "), UserError);
  }
}

}  // namespace
}  // namespace crsh
