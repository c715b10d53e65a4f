// crsh bench, end to end: what it measures, in which form it says so, and what it refuses.

#include <doctest/doctest.h>

#include <nlohmann/json.hpp>
#include <set>

#include "crsh/options.h"
#include "output/whole_file.h"
#include "support/bench_run.h"
#include "support/program.h"
#include "support/temporary_folder.h"

namespace crsh {
namespace {

using nlohmann::json;
using test::bench;
using test::bench_json;
using test::cornell;
using test::glass;
using test::labels_of;
using test::moving;
using test::sum;

TEST_CASE("every preset is measured unless some are named, and all trace the same rays to the same hits") {
  const json result = bench_json({glass, "--repeat", "1", "--warmup", "0"});
  CHECK(result["schema"] == "crsh-bench/1");
  std::vector<std::string> labels = preset_names();
  labels.insert(std::ranges::find(labels, "crsh-2017") + 1, "crsh-2017 cone-test=printed");
  CHECK(labels_of(result) == labels);
  const json& first = result["runs"][0];
  for (const json& run : result["runs"]) {
    CHECK(run["schema"] == "crsh-stats/1");
    CHECK(run["options"]["size"] == "12x10");
    CHECK(run["options"]["algorithm"] == run["algorithm"]);
    for (size_t row = 0; row < run["rays"].size(); ++row)
      CHECK(run["rays"][row]["hits_digest"] == first["rays"][row]["hits_digest"]);
  }
}

TEST_CASE("a run's counters are those of crsh render --stats, summed over its frames") {
  const json result = bench_json({glass, "--repeat", "3", "--warmup", "1", "--algorithms", "crsh-2017"});
  const test::TemporaryFolder folder;
  const test::Outcome once = test::crsh({"render", glass, "-q", "--size", "12x10", "--bounces", "1", "--algorithm",
                                         "crsh-2017", "--stats", "-", "-o", folder / "a.png"});
  REQUIRE(once.status == 0);
  const json& run = result["runs"][0];
  CHECK(run["frames"] == 3);
  for (const char* counter : {"count", "hits", "brute_force_tests", "triangle_tests", "paper_tests", "total_tests"})
    CHECK(sum(run, counter) == 3 * sum(json::parse(once.out), counter));
}

TEST_CASE("frames of the algorithms take turns, and those for warming up are not counted") {
  const json result = bench_json({glass, "--repeat", "3", "--warmup", "2", "--algorithms", "rah,crsh"});
  CHECK(result["runs"][0]["bench"]["places"] == json({0, 2, 4}));
  CHECK(result["runs"][1]["bench"]["places"] == json({1, 3, 5}));
}

TEST_CASE("with --frames a pass is all of them, with the counters of crsh render, refits included") {
  const std::vector<std::string> frames = {"--frames", "0..3", "--fps", "2"};
  for (const std::string memory : {"2048", "8"}) {  // where all fit together, and one at a time
    std::vector<std::string> options = {
        moving, "--repeat", "2", "--warmup", "1", "--algorithms", "brute,crsh,bvh,crsh-bvh", "--max-memory", memory};
    options.insert(options.end(), frames.begin(), frames.end());
    const json result = bench_json(options);
    uint64_t sum_of_peaks = 0;
    for (const json& run : result["runs"]) {
      sum_of_peaks += run["memory"]["device_peak_bytes"].get<uint64_t>();
      const std::string algorithm = run["algorithm"];
      CAPTURE(algorithm);
      CHECK(run["options"]["frames"] == "0..3");
      const test::TemporaryFolder folder;
      std::vector<std::string> render = {
          "render",      moving,    "-q",      "--size", "12x10", "--bounces",           "1",
          "--algorithm", algorithm, "--stats", "-",      "-o",    folder / "{frame}.png"};
      render.insert(render.end(), frames.begin(), frames.end());
      const json once = json::parse(test::crsh(render).out);
      const uint64_t passes = run["bench"]["traced"] ? 2 : 1;
      for (const char* counter : {"count", "hits", "triangle_tests", "paper_tests", "total_tests"})
        CHECK(sum(run, counter) == passes * sum(once, counter));
      CHECK(run["object_hierarchy"]["refits"] == once["object_hierarchy"]["refits"]);
      if (passes == 2) CHECK(run["frames"] == 8);
    }
    CHECK(sum_of_peaks > (8 << 20));  // else nothing is ever short
    CHECK(result["runs"][3]["object_hierarchy"]["refits"] == 3);
    CHECK(result["runs"][1]["bench"]["places"].size() == 8);
  }
}

TEST_CASE("Table 1 says whether it counts one frame or all") {
  const std::vector<std::string> quick = {moving, "--repeat", "1", "--warmup", "0", "--algorithms", "bvh"};
  std::vector<std::string> film = quick;
  film.insert(film.end(), {"--frames", "0..1"});
  CHECK(bench(quick).out.find("tests of one frame\n") != std::string::npos);
  CHECK(bench(film).out.find("tests of all frames\n") != std::string::npos);
}

TEST_CASE("Table 1 counts crsh-2017 with equation 9 signed and as printed, unless switches are chosen") {
  const json both = bench_json({glass, "--repeat", "2", "--warmup", "0", "--algorithms", "crsh-2017,rah"});
  CHECK(labels_of(both) == std::vector<std::string>{"crsh-2017", "crsh-2017 cone-test=printed", "rah"});
  const json &with_sign = both["runs"][0], &as_printed = both["runs"][1];
  CHECK(with_sign["options"]["cone-test"] == "signed");
  CHECK(as_printed["options"]["cone-test"] == "printed");
  CHECK(as_printed["bench"]["traced"] == true);
  CHECK(as_printed["bench"]["timed"] == false);
  CHECK(as_printed["frames"] == 0);
  CHECK(2 * sum(as_printed, "paper_tests") > sum(with_sign, "paper_tests"));
  CHECK(2 * sum(as_printed, "hits") == sum(with_sign, "hits"));
  CHECK(both["runs"][2]["bench"]["places"] == json({1, 3}));
  const test::Outcome tables = bench({glass, "--repeat", "1", "--warmup", "0", "--algorithms", "crsh-2017"});
  CHECK(tables.out.find("\nOur Algorithm (crsh-2017 cone-test=printed) ") != std::string::npos);
  CHECK(tables.out.find("cone-test=printed is equation 9 to the letter") != std::string::npos);
  for (const std::vector<std::string>& chosen :
       std::vector<std::vector<std::string>>{{"--cone-test", "printed"}, {"--vary", "arity=8"}, {"--bound", "slab"}}) {
    std::vector<std::string> options = {glass, "--repeat", "1", "--warmup", "0", "--algorithms", "crsh-2017"};
    options.insert(options.end(), chosen.begin(), chosen.end());
    CHECK(bench_json(options)["runs"].size() == 1);
  }
}

TEST_CASE("--budget makes the repeats fewer and says so; an explicit --repeat is kept where no budget is given") {
  const std::vector<std::string> usual = {"bench",     glass, "--size",       "24x18",
                                          "--bounces", "0",   "--algorithms", "brute,bvh"};
  const auto run = [&](std::vector<std::string> more) {
    more.insert(more.begin(), usual.begin(), usual.end());
    const test::TemporaryFolder folder;
    more.insert(more.end(), {"--json", folder / "a.json"});
    const test::Outcome outcome = test::crsh(more);
    CAPTURE(outcome.err);
    REQUIRE(outcome.status == 0);
    return std::pair(json::parse(output::read_whole(folder / "a.json")), outcome.err);
  };
  const auto [little, said] = run({"--budget", "0.001"});
  CHECK(little["runs"][0]["bench"]["traced"] == false);
  CHECK(little["runs"][1]["frames"] == 1);
  CHECK(little["budget_s"].get<double>() == doctest::Approx(0.001));
  CHECK(said.find("glass: 1 timed pass of each in place of 58, 0 for warming up") != std::string::npos);
  const auto [both, said_of_both] = run({"--repeat", "4", "--budget", "0.001"});
  CHECK(both["runs"][1]["frames"] == 1);
  CHECK(said_of_both.find("in place of 4") != std::string::npos);
  const auto [kept, nothing] = run({"--repeat", "4", "--warmup", "0"});
  CHECK(kept["runs"][0]["bench"]["traced"] == true);
  CHECK(kept["runs"][1]["frames"] == 4);
  CHECK(kept["budget_s"] == 0);
  CHECK(nothing.find("in place of") == std::string::npos);
}

TEST_CASE("--json is an object whose runs are a list, as its help says") {
  const json result = bench_json({glass, "--repeat", "1", "--warmup", "0", "--algorithms", "bvh"});
  CHECK(result.is_object());
  CHECK(result["runs"].is_array());
  CHECK(test::crsh({"help", "bench"}).out.find("crsh-bench/1, whose \"runs\" are a list") != std::string::npos);
}

TEST_CASE("progress rises to the end, as JSON when asked") {
  const test::Outcome outcome =
      test::crsh({"bench", glass, "--size", "12x10", "--bounces", "0", "--repeat", "2", "--warmup", "0", "--algorithms",
                  "bvh,crsh", "--progress", "json", "--csv", "/dev/null"});
  REQUIRE(outcome.status == 0);
  std::istringstream stream(outcome.err);
  std::vector<double> done;
  bool written = false;
  for (std::string line; std::getline(stream, line);) {
    const json event = json::parse(line, nullptr, false);
    REQUIRE(!event.is_discarded());
    if (event["event"] == "progress") done.push_back(event["done"]);
    written |= event["event"] == "written" && event["path"] == "/dev/null";
  }
  CHECK(std::ranges::is_sorted(done));
  REQUIRE(!done.empty());
  CHECK(done.back() == 1);
  CHECK(written);
}

TEST_CASE("where memory holds one algorithm at a time, the counters and the turns are the same") {
  const std::vector<std::string> options = {glass, "--repeat",     "2",        "--warmup",
                                            "1",   "--algorithms", "rah,crsh", "--max-memory"};
  std::vector<std::string> little = options, plenty = options;
  little.emplace_back("6");
  plenty.emplace_back("1000");
  const json alone = bench_json(little), together = bench_json(plenty);
  uint64_t sum_of_peaks = 0;
  for (size_t run = 0; run < 2; ++run) {
    CHECK(alone["runs"][run]["rays"] == together["runs"][run]["rays"]);
    CHECK(alone["runs"][run]["bench"]["places"] == together["runs"][run]["bench"]["places"]);
    sum_of_peaks += together["runs"][run]["memory"]["device_peak_bytes"].get<uint64_t>();
  }
  CHECK(sum_of_peaks > (6 << 20));  // else nothing was short
}

TEST_CASE("--vary makes every combination, and leaves out what a preset does not look at") {
  const json result = bench_json({glass, "--repeat", "1", "--warmup", "0", "--algorithms", "brute,rah", "--vary",
                                  "arity=4,8", "--vary", "--fit=merged,all", "--vary", "size=8x8,16x8"});
  CHECK(labels_of(result) ==
        std::vector<std::string>{
            "brute size=8x8", "brute size=16x8", "rah arity=4 fit=merged size=8x8", "rah arity=4 fit=merged size=16x8",
            "rah arity=4 fit=all size=8x8", "rah arity=4 fit=all size=16x8", "rah arity=8 fit=merged size=8x8",
            "rah arity=8 fit=merged size=16x8", "rah arity=8 fit=all size=8x8", "rah arity=8 fit=all size=16x8"});
  CHECK(result["runs"][2]["options"]["arity"] == 4);
  CHECK(result["runs"][2]["options"]["fit"] == "merged");
  CHECK(result["runs"][3]["image"]["width"] == 16);
  CHECK(sum(result["runs"][2], "paper_tests") != sum(result["runs"][6], "paper_tests"));
}

TEST_CASE("brute force of many tests is counted, not traced, with the counters that tracing has") {
  const std::string office = CRSH_SOURCE_DIR "/scenes/office.glb";
  const json counted = bench_json({office, "--repeat", "100000", "--warmup", "0", "--algorithms", "brute"});
  const json traced = bench_json({office, "--repeat", "1", "--warmup", "0", "--algorithms", "brute"});
  CHECK(counted["runs"][0]["bench"]["traced"] == false);
  CHECK(traced["runs"][0]["bench"]["traced"] == true);
  CHECK(counted["runs"][0]["frames"] == 0);
  CHECK(counted["runs"][0]["rays"] == traced["runs"][0]["rays"]);
  const test::TemporaryFolder folder;
  const test::Outcome tables =
      bench({office, "--repeat", "100000", "--algorithms", "brute", "--report", folder / "a.html"});
  CHECK(tables.out.find("Brute force was counted, not traced") != std::string::npos);
  CHECK(output::read_whole(folder / "a.html").find("Table 1") != std::string::npos);  // without any picture
}

TEST_CASE("a scene's own options stand behind its path between quotes") {
  const json result = bench_json(
      {cornell + " --size 8x4 --rays shadow", glass, "--repeat", "1", "--warmup", "0", "--algorithms", "rah"});
  CHECK(result["runs"][0]["options"]["rays"] == "shadow");
  CHECK(result["runs"][1]["options"]["rays"] == "shadow,reflection,refraction");
  CHECK(result["runs"][0]["scene"]["path"] == cornell);
}

TEST_CASE("--count chooses the rays of Tables 1 and 2") {
  const test::Outcome outcome =
      bench({glass, "--repeat", "1", "--warmup", "0", "--algorithms", "rah", "--count", "shadow:0"});
  CHECK(outcome.out.find("shadow (k = 0) rays") != std::string::npos);
  CHECK(outcome.out.find("# RE") == std::string::npos);
}

TEST_CASE("wrong usage of the bench is one line, before anything is rendered") {
  const auto check_misuse = [](std::vector<std::string> options, const std::string& message, int status = 2) {
    options.insert(options.begin(), "bench");
    const test::Outcome outcome = test::crsh(options);
    CAPTURE(outcome.err);
    CHECK(outcome.status == status);
    CHECK(outcome.out.empty());
    CHECK(outcome.error_lines() == 1);
    CHECK(outcome.err.find(message) != std::string::npos);
  };
  check_misuse({}, "SCENE is missing");
  check_misuse({"a.glb", "--algorithms", "rah,none"}, "no such algorithm: choose brute, ");
  check_misuse({"a.glb", "--algorithms", "rah,rah"}, "rah stands twice");
  check_misuse({"a.glb", "--vary", "arity"}, "OPTION=VALUE,VALUE is allowed");
  check_misuse({"a.glb", "--vary", "colour=red"}, "colour: no option that can be varied");
  check_misuse({"a.glb", "--vary", "scene=0,1"}, "scene: no option that can be varied");
  check_misuse({"a.glb", "--vary", "device=0,1"}, "device: no option that can be varied");
  check_misuse({"a.glb", "--vary", "arity=4,many"}, "a whole number from 2 to 64");
  check_misuse({"a.glb", "--repeat", "0"}, "a whole number from 1");
  check_misuse({"a.glb", "--count", "shadows"}, "allowed is shadow, reflection, refraction");
  check_misuse({"a.glb", "--json", "-", "--csv", "-"}, "two outputs on standard output");
  check_misuse({"a.glb", "--json", "a", "--csv", "./a"}, "two outputs into one file");
  check_misuse({"a.glb", "--report", "a.txt"}, "a path that ends in .html");
  check_misuse({"a.glb", "--ablate", "brute"}, "brute has no switches");
  check_misuse({"a.glb", "--sweep", "cameras"}, "allowed is triangles, pixels, lights");
  check_misuse({"a.glb", "--frames", "3..0"}, "the last frame comes before the first");
  check_misuse({"a.glb", "--frames", "0..3", "--time", "1"}, "give one");
  check_misuse({"a.glb", "--fov", "50", "--orthographic", "1"}, "give one");
  check_misuse({"a.glb --size 0x0"}, "'a.glb --size 0x0': --size 0x0");
  check_misuse({"a.glb --device 1"}, "--device: no such option");
  check_misuse({"none.glb", "-q"}, "none.glb", 1);
  check_misuse({"a.glb", "--json", "no-such-folder/a.json"}, "the folder no-such-folder does not exist", 1);
}

TEST_CASE("a failure leaves no output") {
  const test::TemporaryFolder folder;
  CHECK(bench({glass, "none.glb", "--repeat", "1", "--json", folder / "a.json", "--csv", folder / "a.csv"}).status ==
        1);
  CHECK(folder.size() == 0);
}

}  // namespace
}  // namespace crsh
