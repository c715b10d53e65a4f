// The window: it opens, resizes, minimises, closes, and says what is wrong.

#include <doctest/doctest.h>
#include <unistd.h>

#include <cstdio>

#include "output/image.h"
#include "output/whole_file.h"
#include "support/outside_scene.h"
#include "viewer/view.h"

namespace crsh {
namespace {

using test::cornell;
using test::lines_with;
using test::quick;
using test::TemporaryFolder;
using test::view;

/// Nothing went wrong, and nothing was said.
void check_well(const test::Outcome& outcome) {
  CAPTURE(outcome.err);
  CHECK(outcome.status == 0);
  CHECK(outcome.err.empty());
}

TEST_CASE("it opens, draws, and its screenshot is the whole window" * doctest::test_suite("subset")) {
  const TemporaryFolder folder;
  check_well(view(cornell, "resize 640 480\nwait\nscreenshot " + (folder / "a.png") + "\n"));
  const output::Image image = output::read_image(folder / "a.png");
  CHECK(image.width == 640);
  CHECK(image.height == 480);
}

TEST_CASE("--after without a script ends with the picture, however early the renderer's thread comes to rest") {
  for (int again = 0; again < 2; ++again) {
    const TemporaryFolder folder;
    std::vector<std::string> options = {cornell,        "--size",         "320x200", "--after",       "3",
                                        "--screenshot", folder / "a.png", "--save",  folder / "b.png"};
    options.insert(options.end(), quick.begin(), quick.end());
    check_well(test::run_program(CRSH_BUILD_DIR "/crsh-view", options));
    CHECK(output::read_image(folder / "a.png").width > 100);
    CHECK(output::read_image(folder / "b.png").width > 100);
  }
}

TEST_CASE("a script's first wait ends with a picture") {
  std::vector<std::string> options = quick;
  options.insert(options.end(), {"--size", "320x200"});
  const test::Outcome outcome = view(cornell, "wait\nprint-memory\n", options);
  check_well(outcome);
  CHECK(outcome.out.starts_with("memory: device "));
  CHECK(outcome.out.find("memory: device 0 ") == std::string::npos);
}

TEST_CASE("--after of a file that is no scene ends with its reason, not without end") {
  const test::Outcome outcome = test::run_program(CRSH_BUILD_DIR "/crsh-view", {"/nowhere/scene.glb", "--after", "3"});
  CHECK(outcome.status == 1);
  CHECK(outcome.err.find("/nowhere/scene.glb") != std::string::npos);
}

TEST_CASE("it shrinks to one pixel and grows again") {
  const TemporaryFolder folder;
  check_well(view(cornell, "wait\nresize 1 1\nwait\nresize 400 300\nwait\nscreenshot " + (folder / "a.png") + "\n"));
  CHECK(output::read_image(folder / "a.png").width == 400);
}

TEST_CASE("it is minimised and comes back") {
  check_well(view(cornell, "resize 300 200\nwait\nminimise\nframes 5\nrestore\nwait\n"));
}

TEST_CASE("a broken file that is dropped says why, and the scene that was there stays") {
  const TemporaryFolder folder;
  output::write_whole(folder / "broken.glb", "this is no scene");
  const std::string script = "resize 300 200\nwait\ndrop " + (folder / "broken.glb") +
                             "\nrest\ndrag left 150 60 170 80\nwait\nprint-command\n";
  const test::Outcome outcome = view(cornell, script);
  CHECK(outcome.status == 0);
  CHECK(outcome.error_lines() == 1);
  CHECK(outcome.err.find("broken.glb") != std::string::npos);
  CHECK(outcome.out.find("cornell.glb") != std::string::npos);
}

TEST_CASE("a scene that is dropped takes the place of the other") {
  const test::Outcome outcome = view(cornell, "resize 300 200\nwait\ndrop " + test::moving + "\nwait\nprint-command\n");
  check_well(outcome);
  CHECK(outcome.out.find("moving.glb") != std::string::npos);
}

TEST_CASE("without a scene it waits for one") {
  check_well(view("", "resize 300 200\nframes 3\ndrop " + cornell + "\nframes 20\nwait\n"));
}

TEST_CASE("--allow-outside reads a scene's files outside its folder, and is part of the command that it prints") {
  const TemporaryFolder folder;
  const std::string scene = test::outside_scene(folder);
  const test::Outcome refused = view(scene, "frames 3\n");
  CHECK(refused.status == 1);
  CHECK(refused.err.find("lies outside the scene's folder") != std::string::npos);
  CHECK(refused.err.find("(--allow-outside)") != std::string::npos);
  std::vector<std::string> options = quick;
  options.emplace_back("--allow-outside");
  const test::Outcome outcome = view(scene, "resize 300 200\nwait\nprint-command\n", options);
  check_well(outcome);
  CHECK(outcome.out.find(" --allow-outside ") != std::string::npos);
}

TEST_CASE("a scene that is broken from the start ends a script with its reason") {
  const test::Outcome outcome = view("/nowhere/scene.glb", "frames 3\n");
  CHECK(outcome.status == 1);
  CHECK(outcome.err.find("/nowhere/scene.glb") != std::string::npos);
}

TEST_CASE("F5 loads the scene again and keeps the view") {
  const TemporaryFolder folder;
  output::write_whole(folder / "a.glb", output::read_whole(cornell));
  const test::Outcome outcome = view(
      folder / "a.glb",
      "resize 300 200\nwait\ndrag left 100 60 130 70\nwait\nprint-command\nkey F5\nframes 10\nwait\nprint-command\n");
  check_well(outcome);
  const auto lines = lines_with(outcome.out, "crsh render");
  REQUIRE(lines.size() == 2);
  CHECK(lines[0] == lines[1]);
}

TEST_CASE("--watch loads the scene again when its file changes") {
  // A script's words have no spaces; the project's path may have some.
  const std::string stem = "/tmp/crsh-watched-" + std::to_string(::getpid()), path = stem + ".glb",
                    other = stem + "-2.glb";
  output::write_whole(path, output::read_whole(cornell));
  output::write_whole(other, output::read_whole(test::moving));
  const std::string script =
      "resize 600 200\nwait\nprint-command\ncopy " + other + " " + path + "\nexpect picture\nwait\nprint-command\n";
  const test::Outcome outcome = view(path, script, {"--bounces", "0", "--samples", "1", "--quiet", "--watch"});
  std::remove(path.c_str());
  std::remove(other.c_str());
  CAPTURE(outcome.err);
  CHECK(outcome.status == 0);
  CHECK(lines_with(outcome.out, "crsh render").size() == 2);
}

TEST_CASE("--size is the picture's, not the window's") {
  const test::Outcome outcome = view(test::moving, "frames 10\nwait\nprint-command\n",
                                     {"--bounces", "0", "--samples", "1", "--quiet", "--size", "320x200"});
  check_well(outcome);
  CHECK(outcome.out.find("--size 320x200") != std::string::npos);
}

TEST_CASE("wrong usage is one line and status 2") {
  for (const std::vector<std::string>& options :
       std::vector<std::vector<std::string>>{{"--budget", "soon"}, {"--no-such"}, {"--key", "file"}}) {
    const test::Outcome outcome = test::run_program(CRSH_BUILD_DIR "/crsh-view", options);
    CHECK(outcome.status == 2);
    CHECK(outcome.error_lines() == 1);
  }
}

TEST_CASE("a script with an unknown command or widget is refused with its line") {
  test::Outcome outcome = view(cornell, "wait\njump 3\n");
  CHECK(outcome.status == 1);
  CHECK(outcome.err.find(":2: jump") != std::string::npos);
  outcome = view(cornell, "click no such thing\n");
  CHECK(outcome.status == 1);
  CHECK(outcome.err.find(":1: no widget") != std::string::npos);
}

}  // namespace
}  // namespace crsh
