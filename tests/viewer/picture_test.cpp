// The picture: the same as that of crsh render with the command that is copied.

#include <doctest/doctest.h>

#include "crsh/options.h"
#include "output/image.h"
#include "output/whole_file.h"
#include "viewer/view.h"

namespace crsh {
namespace {

using test::cornell;
using test::lines_with;
using test::quick;
using test::TemporaryFolder;
using test::view;

/// Saves after `script`, renders the printed command, and compares.
void check_same(const std::string& scene, const std::string& script, const std::vector<std::string>& options = quick,
                const std::string& extension = ".png") {
  const TemporaryFolder folder;
  const std::string seen = folder / ("seen" + extension), rendered = folder / ("rendered" + extension);
  const test::Outcome outcome = view(scene, script + "save " + seen + "\nprint-command\n", options);
  CAPTURE(outcome.err);
  REQUIRE(outcome.status == 0);
  const auto lines = lines_with(outcome.out, "crsh render");
  REQUIRE(lines.size() == 1);
  CAPTURE(lines[0]);
  const test::Outcome render = test::render_copied(lines[0], rendered);
  CAPTURE(render.err);
  REQUIRE(render.status == 0);
  const test::Outcome diff = test::crsh({"diff", seen, rendered, "--exact"});
  CAPTURE(diff.out);
  CHECK(diff.status == 0);
}

TEST_CASE("the saved picture is crsh render's with the copied command, bit for bit" * doctest::test_suite("subset")) {
  check_same(cornell,
             "resize 600 300\nwait\ndrag left 450 100 500 130\nwheel 420 150 2\ndrag middle 450 150 440 160\nwait\n");
}

TEST_CASE("so is the picture before anything is moved") { check_same(cornell, "resize 360 260\nwait\n"); }

TEST_CASE("so is one of several samples") {
  check_same(cornell, "resize 300 200\nrest\n", {"--bounces", "1", "--samples", "3", "--quiet"});
}

TEST_CASE("so is an EXR with its layers") { check_same(cornell, "resize 300 200\nwait\n", quick, ".exr"); }

TEST_CASE("so is one of an animation at another time") {
  check_same(test::moving, "resize 300 200\nwait\nkey Space\nframes 20\nkey Space\nframes 40\nwait\n");
}

TEST_CASE("so is one from the file's camera, framed, from above, flown and orthographic") {
  for (const std::string keys : {"key Tab\n", "key Enter\n", "key 7\n", "key 3\nhold W 5\n", "key 5\n",
                                 "key 5\nkey 3\nhold W 5\ndouble 150 90\n"})
    check_same(cornell, "resize 260 180\nwait\n" + keys + "frames 3\nwait\n");
}

TEST_CASE("a double click turns around what is there") {
  check_same(cornell, "resize 300 200\nwait\ndouble 150 90\nwait\ndrag left 100 60 120 60\nwait\n");
}

TEST_CASE("so is one with an object hidden") {
  check_same(cornell,
             "resize 700 500\nwait\nclick View\nclick Algorithm\nclick Total\nclick Time\nclick Counters\nclick "
             "Scene\nclick object 1\nwait\n");
}

TEST_CASE("every algorithm shows the same picture") {
  std::string script = "resize 700 500\nwait\n", first;
  const TemporaryFolder folder;
  for (const std::string& name : preset_names())
    script += "choose algorithm=" + name + "\nwait\nsave " + (folder / (name + ".png")) + "\n";
  const test::Outcome outcome = view(cornell, script, {"--bounces", "0", "--samples", "1", "--quiet"});
  CAPTURE(outcome.err);
  REQUIRE(outcome.status == 0);
  for (const std::string& name : preset_names()) {
    const std::string bytes = output::read_whole(folder / (name + ".png"));
    if (first.empty()) first = bytes;
    CHECK(bytes == first);
  }
}

}  // namespace
}  // namespace crsh
