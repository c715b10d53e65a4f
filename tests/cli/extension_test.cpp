// What CONTRIBUTING.md says of keys and bounds of one's own, done as it stands there: in NumPy, and in a copy of the
// tree.

#include <doctest/doctest.h>

#include <cstdlib>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "output/whole_file.h"
#include "support/program.h"
#include "support/temporary_folder.h"

namespace crsh {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

const fs::path tree = CRSH_SOURCE_DIR;
const std::string office = CRSH_SOURCE_DIR "/scenes/office.glb";
const std::string python = "/usr/bin/python3";  // Debian's, which its NumPy belongs to

/// The code between ``` that follows these words.
std::string code_after(const std::string& words) {
  const std::string text = output::read_whole(tree / "CONTRIBUTING.md");
  const size_t at = text.find(words);
  REQUIRE(at != std::string::npos);
  const size_t begin = text.find('\n', text.find("```", at)) + 1;
  return text.substr(begin, text.find("```", begin) - begin);
}

test::Outcome run(const std::string& program, const std::vector<std::string>& arguments) {
  const test::Outcome outcome = test::run_program(program, arguments);
  CAPTURE(program);
  CAPTURE(outcome.out);
  CAPTURE(outcome.err);
  REQUIRE(outcome.status == 0);
  return outcome;
}

/// A copy of what shaders are made of, with two new ones, and this build's compiled ones, which are younger than their
/// sources: make compiles only what is new.
void copy_tree(const fs::path& copy) {
  for (const char* folder : {"shaders", "tools/cmake", "src/gpu", "tests/extension"}) {
    fs::create_directories(copy / folder);
    run("cp", {"-a", (tree / folder / ".").string(), (copy / folder).string()});
  }
  output::write_whole(copy / "shaders/rays/keys/octant.glsl", code_after("`shaders/rays/keys/octant.glsl`:"));
  output::write_whole(copy / "shaders/hierarchy/bounds/slab-plane.glsl",
                      code_after("`shaders/hierarchy/bounds/slab-plane.glsl`:"));
  fs::create_directories(copy / "build/shaders");
  run("cp", {"-r", CRSH_BUILD_DIR "/shaders/.", (copy / "build/shaders").string()});
}

void build(const fs::path& copy) {
  run("cmake", {"-G", "Unix Makefiles", "-S", (copy / "tests/extension").string(), "-B", (copy / "build").string(),
                "-DCOPY=" + copy.string(), "-DBUILD=" CRSH_BUILD_DIR, "-DCMAKE_BUILD_TYPE=Release"});
  run("cmake", {"--build", (copy / "build").string(), "--target", "crsh", "-j2"});
}

uint64_t paper_tests(const json& run) {
  uint64_t sum = 0;
  for (const json& rays : run["rays"]) sum += rays["paper_tests"].get<uint64_t>();
  return sum;
}

TEST_CASE("the key and the bound that CONTRIBUTING adds, built in a copy of the tree, are benched beside the others") {
  if (test::run_program("make", {"--version"}).status != 0) {
    MESSAGE("skipped: make is not here");
    return;
  }
  const fs::path copy = fs::path(CRSH_BUILD_DIR) / "extension";  // no blanks in the path: make dislikes them
  fs::remove_all(copy);
  copy_tree(copy);
  build(copy);
  const test::Outcome outcome =
      run((copy / "build/crsh").string(),
          {"bench", office, "-q", "--size", "64x48", "--bounces", "1", "--algorithms", "bvh,crsh", "--vary",
           "key=best,octant", "--vary", "bound=slab,slab-plane", "--repeat", "1", "--warmup", "0", "--json", "-"});
  const json runs = json::parse(outcome.out)["runs"];
  REQUIRE(runs.size() == 5);
  CHECK(runs[4]["options"]["bound"] == "slab-plane");
  CHECK(runs[4]["options"]["key"]["shadow"] == "octant");
  for (const json& each : runs)  // none loses a hit
    for (size_t row = 0; row < each["rays"].size(); ++row)
      CHECK(each["rays"][row]["hits_digest"] == runs[0]["rays"][row]["hits_digest"]);
  CHECK(paper_tests(runs[1]) != paper_tests(runs[3]));  // another key makes other nodes
  CHECK(paper_tests(runs[2]) < paper_tests(runs[1]));   // the tighter bound needs fewer tests
  fs::remove_all(copy);
}

TEST_CASE("the key that CONTRIBUTING works out in NumPy sorts rays that are replayed") {
  if (test::run_program(python, {"-c", "import numpy"}).status != 0) {
    MESSAGE("skipped: NumPy is not here (the Debian package python3-numpy)");
    return;
  }
  const test::TemporaryFolder folder;
  const auto in_folder = [&](const std::string& command) {
    run("sh", {"-c", "cd '" + folder.path().string() + "' && " + command});
  };
  output::write_whole(folder / "key.py", code_after("```python"));
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
