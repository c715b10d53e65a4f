// What CONTRIBUTING.md tells those who add to the renderer, done as it stands there: in copies of the tree, and in
// NumPy.

#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "output/image.h"
#include "output/whole_file.h"
#include "support/program.h"
#include "support/temporary_folder.h"
#include "tree_copy.h"

namespace crsh {
namespace {

using nlohmann::json;

const std::string office = CRSH_SOURCE_DIR "/scenes/office.glb";
const std::string python = "/usr/bin/python3";  // Debian's, which its NumPy belongs to

bool make_is_here() {
  if (test::run_program("make", {"--version"}).status == 0) return true;
  MESSAGE("skipped: make is not here");
  return false;
}

void require_done(const test::Outcome& outcome, const std::string& command) {
  CAPTURE(command);
  CAPTURE(outcome.out);
  CAPTURE(outcome.err);
  REQUIRE(outcome.status == 0);
}

/// Does what the step tells, but for the commands that only show what it is worth. Their count.
size_t run_commands(const test::TreeCopy& copy, const test::Recipe& recipe) {
  size_t run = 0;
  for (const std::string& command : recipe.commands) {
    if (command.find(" bench ") != std::string::npos) continue;
    require_done(copy.run(command), command);
    ++run;
  }
  return run;
}

bool any_test_fails(const test::TreeCopy& copy, const test::Recipe& recipe) {
  for (const std::string& command : recipe.commands)
    if (command.find("build/test_") != std::string::npos && copy.run(command).status != 0) return true;
  return false;
}

std::vector<std::string> joined(std::vector<std::string> files, const std::vector<std::string>& more) {
  files.insert(files.end(), more.begin(), more.end());
  return files;
}

uint64_t paper_tests(const json& run) {
  uint64_t sum = 0;
  for (const json& rays : run["rays"]) sum += rays["paper_tests"].get<uint64_t>();
  return sum;
}

/// The new key, bound and algorithm beside others: none loses a hit.
void check_bench(const test::TreeCopy& copy) {
  const test::Outcome outcome = copy.run(
      "build/crsh bench scenes/office.glb -q --size 64x48 --bounces 1 --algorithms bvh,crsh,rah-sorted --vary "
      "key=best,octant --vary bound=slab,slab-plane --repeat 1 --warmup 0 --json -");
  require_done(outcome, "bench");
  const json runs = json::parse(outcome.out)["runs"];
  REQUIRE(runs.size() == 9);
  CHECK(runs[4]["options"]["bound"] == "slab-plane");
  CHECK(runs[4]["options"]["key"]["shadow"] == "octant");
  CHECK(runs[8]["options"]["algorithm"] == "rah-sorted");
  CHECK(runs[6]["options"]["key"]["shadow"] == "spherical");  // the algorithm's own best
  for (const json& each : runs)
    for (size_t row = 0; row < each["rays"].size(); ++row)
      CHECK(each["rays"][row]["hits_digest"] == runs[0]["rays"][row]["hits_digest"]);
  CHECK(paper_tests(runs[1]) != paper_tests(runs[3]));  // another key makes other nodes
  CHECK(paper_tests(runs[2]) < paper_tests(runs[1]));   // the tighter bound needs fewer tests
}

TEST_CASE("a key, a bound and an algorithm are added as CONTRIBUTING tells, and the tests it names know them") {
  if (!make_is_here()) return;
  const test::Recipe key = test::recipe("A sort key"), bound = test::recipe("A node bound"),
                     algorithm = test::recipe("An algorithm");
  CHECK(key.files().size() == 1);
  CHECK(bound.files().size() == 1);
  CHECK(algorithm.files().size() == 1);
  test::TreeCopy copy("extension");
  copy.apply(key), copy.apply(bound), copy.apply(algorithm);
  copy.build(joined(test::tests_in("stages"), joined(test::tests_in("properties"), test::tests_in("images"))));
  CHECK(copy.compiled() == 1);
  CHECK(run_commands(copy, key) == 2);
  CHECK(run_commands(copy, bound) == 2);
  CHECK(run_commands(copy, algorithm) == 2);
  check_bench(copy);
  // Faults: a key with more bits than it says, and a bound that takes its slack from what it should leave.
  copy.replace("shaders/rays/keys/octant.glsl", "<< 12 |", "<< 13 |");
  copy.replace("shaders/hierarchy/bounds/slab-plane.glsl", "slack = 1e-5", "slack = -1e-1");
  copy.build(joined(test::tests_in("stages"), joined(test::tests_in("properties"), test::tests_in("images"))));
  CHECK(any_test_fails(copy, key));
  CHECK(any_test_fails(copy, bound));
}

/// The layer of one channel, 0 to 1, has more than one value.
void check_shares(const test::TreeCopy& copy, const std::string& file, const std::string& channel) {
  const output::Image image = output::read_image((copy.path() / file).string());
  const output::Channel* found = image.find(channel);
  REQUIRE(found);
  double low = 2, high = -1;
  for (size_t pixel = 0; pixel < found->bits.size(); ++pixel)
    low = std::min(low, found->value(pixel)), high = std::max(high, found->value(pixel));
  CHECK(low >= 0);
  CHECK(high > low);
  CHECK(high <= 1);
}

/// Statistics and completion have the kind, it is cast where its row says, and single rays see the same as nodes.
void check_kind(const test::TreeCopy& copy) {
  const json statistics = json::parse(output::read_whole(copy.path() / "occlusion.json"));
  uint64_t rays = 0;
  for (const json& row : statistics["rays"])
    if (row["kind"] == "occlusion") {
      CHECK((row["count"].get<uint64_t>() > 0) == (row["bounce"] == 0));
      rays += row["count"].get<uint64_t>();
    }
  CHECK(rays > 0);
  CHECK(copy.run("build/crsh completion bash | grep -q occlusion").status == 0);
  const std::string render = "build/crsh render scenes/office.glb -q --size 48x36 --rays shadow,reflection,occlusion ";
  require_done(copy.run(render + "--layers beauty,Occlusion --algorithm crsh -o a.exr"), "crsh");
  require_done(copy.run(render + "--layers beauty,Occlusion --algorithm bvh -o b.exr"), "bvh");
  CHECK(copy.run("build/crsh diff --exact --layers beauty,Occlusion a.exr b.exr").status == 0);
}

TEST_CASE("a layer and a ray kind are added as CONTRIBUTING tells: statistics, files, help and the viewer have them") {
  if (!make_is_here()) return;
  const test::Recipe layer = test::recipe("A layer"), kind = test::recipe("A ray kind");
  CHECK(layer.files().size() <= 2);
  CHECK(kind.files().size() <= 3);
  test::TreeCopy copy("extension");
  copy.apply(layer), copy.apply(kind);
  copy.build({"tests/images/layers_test.cpp", "tests/unit/kinds_test.cpp"});
  CHECK(copy.compiled() > 20);
  CHECK(run_commands(copy, layer) == 2);
  CHECK(run_commands(copy, kind) == 3);
  check_shares(copy, "roughness.exr", "Roughness");
  check_shares(copy, "occlusion.exr", "Occlusion.Y");
  check_kind(copy);
  for (const std::string name : {"Roughness", "Occlusion"})
    CHECK(copy.run("build/crsh help render | grep -q '^  " + name + " '").status == 0);
  for (const std::string name : {"roughness", "occlusion"})
    CHECK(copy.run("build/show_names | grep -qx " + name).status == 0);
}

TEST_CASE("the key that CONTRIBUTING works out in NumPy sorts rays that are replayed") {
  if (test::run_program(python, {"-c", "import numpy"}).status != 0) {
    MESSAGE("skipped: NumPy is not here (the Debian package python3-numpy)");
    return;
  }
  const test::TemporaryFolder folder;
  const auto in_folder = [&](const std::string& command) {
    require_done(test::run_program("sh", {"-c", "cd '" + folder.path().string() + "' && " + command}), command);
  };
  output::write_whole(folder / "key.py", test::code_after("```python"));
  const std::string render = "'" + test::crsh_path() + "' render '" + office + "' -q --bounces 0 ";
  in_folder(render + "--size 32x24 --dump-rays rays.npz --stats before.json");
  in_folder(python + " key.py");
  in_folder(render + "--replay-rays own.npz --key file --stats after.json");
  const json before = json::parse(output::read_whole(folder / "before.json")),
             after = json::parse(output::read_whole(folder / "after.json"));
  CHECK(before["rays"][0]["hits_digest"] == after["rays"][0]["hits_digest"]);
  CHECK(paper_tests(before) != paper_tests(after));
}

}  // namespace
}  // namespace crsh
