// What needs no renderer: help, version, and every kind of wrong usage.

#include <doctest/doctest.h>

#include "support/program.h"
#include "support/temporary_folder.h"

namespace crsh {
namespace {

using doctest::Contains;
using test::crsh;

/// One line on standard error, nothing on standard output, exit status 2.
void check_misuse(const std::vector<std::string>& arguments, const std::string& message) {
  const test::Outcome outcome = crsh(arguments);
  CAPTURE(outcome.err);
  CHECK(outcome.status == 2);
  CHECK(outcome.out.empty());
  CHECK(outcome.error_lines() == 1);
  CHECK(outcome.err.starts_with("crsh: "));
  CHECK(outcome.err.find(message) != std::string::npos);
}

TEST_CASE("--version says version and commit on standard output") {
  const test::Outcome outcome = crsh({"--version"});
  CHECK(outcome.status == 0);
  CHECK(outcome.out.starts_with("crsh 0."));
  CHECK(outcome.err.empty());
}

TEST_CASE("help is data, in lines of 80 characters, and names every subcommand") {
  const test::Outcome general = crsh({"help"});
  CHECK(general.status == 0);
  CHECK(crsh({"--help"}).out == general.out);
  for (const char* command : {"render", "bench", "diff", "info"}) {
    CHECK(general.out.find(command) != std::string::npos);
    const test::Outcome outcome = crsh({"help", command});
    CHECK(outcome.status == 0);
    CHECK(outcome.out.find("Examples:") != std::string::npos);
    CHECK(crsh({command, "--help"}).out == outcome.out);
    for (size_t begin = 0, end; (end = outcome.out.find('\n', begin)) != std::string::npos; begin = end + 1)
      CHECK(end - begin <= 84);
  }
}

TEST_CASE("test-only options are not in the help") {
  const std::string help = crsh({"help", "render"}).out;
  CHECK(help.find("--mutation") == std::string::npos);
  CHECK(help.find("--first-capacity") == std::string::npos);
  CHECK(help.find("--validation") != std::string::npos);
}

TEST_CASE("wrong usage of crsh itself") {
  check_misuse({}, "a command is missing");
  check_misuse({"bend"}, "bend: no such command");
  check_misuse({"help", "bend"}, "bend: no such command");
  check_misuse({"help", "render", "diff"}, "one command at a time");
}

TEST_CASE("a wrong option is one line, exit status 2") {
  check_misuse({"render"}, "SCENE is missing");
  check_misuse({"render", "a.glb"}, "-o FILE is missing");
  check_misuse({"render", "a.glb", "-o"}, "-o");
  check_misuse({"render", "a.glb", "-o", "a.png", "--sise", "1x1"}, "--sise: no such option");
  check_misuse({"render", "a.glb", "b.glb", "-o", "a.png"}, "b.glb: one argument too many");
  check_misuse({"render", "a.glb", "-o", "a.png", "--size", "0x0"},
               "--size 0x0: WIDTHxHEIGHT is allowed, each from 1 to 16384");
  check_misuse({"render", "a.glb", "-o", "a.png", "--size", "100000x100000"}, "each from 1 to 16384");
  check_misuse({"render", "a.glb", "-o", "a.png", "--algorithm", "bvh9"}, "brute, bvh, rah, crsh-2017, crsh");
  check_misuse({"render", "a.glb", "-o", "a.png", "--eye", "nan,0,0"}, "three finite numbers");
  check_misuse({"render", "a.glb", "-o", "a.jpg"}, "ends in .exr or .png");
  check_misuse({"render", "a.glb", "-o", "a.exr", "--layers", "Z,Colour"}, "Colour: no such layer: choose of beauty, ");
  check_misuse({"diff", "a"}, "B is missing");
  check_misuse({"info", "a", "b"}, "b: one argument too many");
}

TEST_CASE("outputs that do not go together are wrong usage") {
  check_misuse({"render", "a.glb", "-o", "-", "--stats", "-"}, "two outputs on standard output");
  check_misuse({"render", "a.glb", "-o", "-", "-o", "-"}, "two outputs on standard output");
  check_misuse({"render", "a.glb", "-o", "a.png", "-o", "./a.png"}, "two outputs into one file");
  check_misuse({"render", "a.glb", "-o", "a.png", "--frames", "0..2"}, "several frames need {frame}");
  check_misuse({"render", "a.glb", "-o", "-", "--frames", "0..2"}, "several frames need {frame}");
  check_misuse({"render", "a.glb", "-o", "{frame}.png", "--frames", "0..2", "--time", "1"}, "give one");
  check_misuse({"render", "a.glb", "-o", "a.png", "--eye", "1,1,1", "--target", "1,1,1"}, "the same point");
  check_misuse({"render", "a.glb", "-o", "a.png", "--eye", "1,1,1", "--camera", "0"}, "give one");
  check_misuse({"render", "a.glb", "-o", "a.png", "--fov", "40", "--orthographic", "2"}, "give one");
}

TEST_CASE("a place that cannot be written to is known before the scene is looked at") {
  const test::TemporaryFolder folder;
  const std::string missing = folder / "no/a.png";
  const test::Outcome outcome = crsh({"render", "no.glb", "-o", missing});
  CHECK(outcome.status == 1);
  CHECK(outcome.error_lines() == 1);
  CHECK(outcome.err ==
        "crsh: " + missing + ": the folder " + (folder / "no") + " does not exist: create it or choose another path\n");
  CHECK(crsh({"render", "no.glb", "-o", folder / "a.png", "--stats", folder.path()}).err.find("is a folder") !=
        std::string::npos);
  CHECK(folder.size() == 0);
}

TEST_CASE("standard output that is full is an error") {
  const test::Outcome outcome = crsh({"help"}, "/dev/full");
  CHECK(outcome.status == 1);
  CHECK(outcome.err == "crsh: standard output: cannot be written (No space left on device)\n");
}

}  // namespace
}  // namespace crsh
