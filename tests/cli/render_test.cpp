// crsh render, end to end: files, standard output, messages, statistics.

#include <doctest/doctest.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <nlohmann/json.hpp>
#include <sstream>

#include "output/image.h"
#include "output/png.h"
#include "output/whole_file.h"
#include "support/program.h"
#include "support/temporary_folder.h"

namespace crsh {
namespace {

namespace fs = std::filesystem;
using test::crsh;
const std::string cornell = CRSH_SOURCE_DIR "/scenes/cornell.glb";

/// crsh render of a small picture of cornell.glb.
test::Outcome render(std::vector<std::string> options) {
  options.insert(options.begin(), {"render", cornell, "--size", "24x16", "--bounces", "1"});
  return crsh(options);
}

TEST_CASE("a render writes EXR and PNG of the size, and says which device runs") {
  const test::TemporaryFolder folder;
  const test::Outcome outcome = render({"-o", folder / "a.exr", "-o", folder / "a.png"});
  CAPTURE(outcome.err);
  REQUIRE(outcome.status == 0);
  CHECK(outcome.out.empty());
  CHECK(outcome.err.find("device: ") != std::string::npos);
  const output::Image exr = output::read_image(folder / "a.exr");
  CHECK(exr.width == 24);
  CHECK(exr.height == 16);
  for (const char* channel : {"R", "G", "B", "A", "Z", "N.X", "N.Y", "N.Z", "Albedo.R"}) CHECK(exr.find(channel));
  CHECK(output::read_image(folder / "a.png").width == 24);
  CHECK(folder.size() == 2);
}

TEST_CASE("two runs give the same bytes under different names") {
  const test::TemporaryFolder folder;
  REQUIRE(render({"-o", folder / "first.exr"}).status == 0);
  REQUIRE(render({"-o", folder / "second.exr"}).status == 0);
  CHECK(output::read_whole(folder / "first.exr") == output::read_whole(folder / "second.exr"));
}

TEST_CASE("a quiet render says nothing, a verbose one how long each stage took") {
  const test::TemporaryFolder folder;
  CHECK(render({"-o", folder / "a.png", "-q"}).err.empty());
  CHECK(render({"-o", folder / "a.png", "-v"}).err.find("final intersection") != std::string::npos);
}

TEST_CASE("- is PNG on standard output, and only that") {
  const test::Outcome outcome = render({"-o", "-"});
  REQUIRE(outcome.status == 0);
  CHECK(output::decode_png(outcome.out, "stdout").height == 16);
}

TEST_CASE("--layers chooses what is in the EXR") {
  const test::TemporaryFolder folder;
  REQUIRE(render({"-o", folder / "a.exr", "--layers", "Z,N"}).status == 0);
  CHECK(output::read_image(folder / "a.exr").channels.size() == 4);
}

TEST_CASE("all layers are in the EXR when asked for, the same in every run, and can be compared one by one") {
  const test::TemporaryFolder folder;
  const std::string a = folder / "a.exr", b = folder / "b.exr", c = folder / "c.exr";
  REQUIRE(render({"-o", a, "--layers", "all"}).status == 0);
  REQUIRE(render({"-o", b, "--layers", "all"}).status == 0);
  CHECK(output::read_whole(a) == output::read_whole(b));
  const output::Image image = output::read_image(a);
  CHECK(image.channels.size() == 38);
  CHECK(image.find("Object.id")->sample == output::Sample::real);
  REQUIRE(render({"-o", c, "--layers", "all", "--algorithm", "rah"}).status == 0);
  for (const char* layer : {"beauty", "Direct", "Reflection.*", "Shadow.Y", "P", "Material.id"})
    CHECK(crsh({"diff", a, c, "--exact", "--layers", layer}).out == "equal\n");
  CHECK(crsh({"diff", a, c, "--exact", "--layers", "Tests.triangle"}).status == 3);
}

TEST_CASE("frames go to files of their own") {
  const test::TemporaryFolder folder;
  const test::Outcome outcome = render({"-o", folder / "f-{frame}.png", "--frames", "8..10", "--progress", "json"});
  REQUIRE(outcome.status == 0);
  for (const char* name : {"f-0008.png", "f-0009.png", "f-0010.png"}) CHECK(fs::exists(folder / name));
  CHECK(folder.size() == 3);
  size_t written = 0;
  std::istringstream lines(outcome.err);
  for (std::string line; std::getline(lines, line);) {
    const auto event = nlohmann::json::parse(line);
    if (event["event"] == "written") ++written;
    if (event["event"] == "progress") CHECK((event["frame"] >= 8 && event["frames"] == 3 && event["done"] <= 1));
  }
  CHECK(written == 3);
}

/// Every line is JSON: its events' texts, by the event.
std::multimap<std::string, std::string> events_in(const std::string& text) {
  std::multimap<std::string, std::string> events;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    const auto event = nlohmann::json::parse(line, nullptr, false);
    CAPTURE(line);
    REQUIRE(event.is_object());
    events.emplace(event["event"], event.value("text", event.value("path", "")));
  }
  return events;
}

TEST_CASE("with --progress json every line on standard error is JSON: notes, exposure, times, errors of any kind") {
  const test::TemporaryFolder folder;
  const test::Outcome done = render({"-o", folder / "a.exr", "-o", folder / "a.png", "--progress", "json", "-v",
                                     "--light", "0,1,0", "--exposure", "auto"});
  REQUIRE(done.status == 0);
  const auto events = events_in(done.err);
  CHECK(events.count("written") == 2);
  CHECK(events.count("progress") > 0);
  const auto has_note = [&](const std::string& part) {
    const auto [first, last] = events.equal_range("note");
    return std::any_of(first, last, [&](const auto& note) { return note.second.find(part) != std::string::npos; });
  };
  for (const char* part : {"device: ", "--light 0,1,0,", "exposure: ", "pipelines"}) CHECK(has_note(part));
  const std::vector<std::vector<std::string>> failures = {{"-o", folder / "a.jpg"},
                                                          {"-o", folder / "a.png", "--samples", "none"},
                                                          {"-o", folder / "no/a.png"},
                                                          {"-o", folder / "b.png", "--camera", "nosuch"}};
  for (std::vector<std::string> failure : failures) {
    for (const std::vector<std::string>& form :
         std::vector<std::vector<std::string>>{{"--progress", "json"}, {"--progress=json"}}) {
      std::vector<std::string> options = failure;
      options.insert(options.end(), form.begin(), form.end());
      const test::Outcome outcome = render(options);
      CHECK(outcome.status != 0);
      const auto errors = events_in(outcome.err);
      CHECK(errors.count("error") == 1);
    }
  }
}

TEST_CASE("a few values that are clamped are said with -v alone, many always") {
  const test::TemporaryFolder folder;
  const auto said = [&](std::vector<std::string> more) {
    more.insert(more.end(), {"-o", folder / "a.exr"});
    return render(more).err.find("were clamped") != std::string::npos;
  };
  CHECK(said({"--background", "1e6,1e6,1e6", "--eye", "0,0,50", "--target", "0,0,100"}));
  CHECK_FALSE(said({}));
}

TEST_CASE("a camera that was chosen is printed as options, which give the same bytes") {
  const test::TemporaryFolder folder;
  const std::string open = folder / "open.gltf";
  output::write_whole(open, R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],
"meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],
"accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3","min":[0,0,0],"max":[1,2,0.5]}],
"bufferViews":[{"buffer":0,"byteLength":36}],
"buffers":[{"byteLength":36,
"uri":"data:application/octet-stream;base64,AAAAAAAAAAAAAAAAAACAPwAAAAAAAAA/AAAAAAAAAEAAAAAA"}]})");
  const test::Outcome chosen =
      crsh({"render", open, "--size", "40x30", "-o", folder / "a.png", "-o", folder / "a.exr"});
  CAPTURE(chosen.err);
  REQUIRE(chosen.status == 0);
  std::vector<std::string> pasted = {"render", open, "--size", "40x30", "-o", folder / "b.png", "-o", folder / "b.exr"};
  std::istringstream words(chosen.err);
  for (std::string word; words >> word;)
    if (word == "--eye" || word == "--target" || word == "--light") {
      pasted.push_back(word);
      words >> word;
      pasted.push_back(word);
    }
  REQUIRE(pasted.size() == 14);
  const test::Outcome again = crsh(pasted);
  REQUIRE(again.status == 0);
  CHECK(again.err.find("no camera was given") == std::string::npos);
  CHECK(output::read_whole(folder / "a.png") == output::read_whole(folder / "b.png"));
  CHECK(crsh({"diff", folder / "a.exr", folder / "b.exr", "--exact", "--layers", "all"}).out == "equal\n");
}

TEST_CASE("statistics hold the command, the effective options and every stage") {
  const test::TemporaryFolder folder;
  const test::Outcome outcome = render({"-o", folder / "a.png", "--stats", "-", "--algorithm", "rah"});
  REQUIRE(outcome.status == 0);
  const auto json = nlohmann::json::parse(outcome.out);
  CHECK(json["schema"] == "crsh-stats/1");
  CHECK(json["command"][1] == "render");
  CHECK(json["options"]["algorithm"] == "rah");
  CHECK(json["options"]["size"] == "24x16");
  CHECK(json["options"]["ray-order"] == "tiles");
  CHECK(json["image"]["width"] == 24);
  CHECK(json["options"]["cone-test"] == "signed");
  CHECK(json["stages"].size() == 10);
  CHECK(json["pipeline_ms"]["max"] > 0);
  CHECK(json["frames"] == 1);
  CHECK(json["scene"]["triangles"] > 100);
  CHECK(json["memory"]["device_peak_bytes"] > 0);
  for (const auto& rays : json["rays"]) {
    CHECK(rays["brute_force_tests"] == rays["count"].get<uint64_t>() * json["scene"]["triangles"].get<uint64_t>());
    for (const auto& level : rays["levels"])
      CHECK(level["tests"] == level["hits"].get<uint64_t>() + level["misses"].get<uint64_t>());
  }
}

/// What is counted of rays, without times and memory.
nlohmann::json rays_in(const test::Outcome& outcome) { return nlohmann::json::parse(outcome.out)["rays"]; }

TEST_CASE("small buffers, submits and memory change no byte of the EXR and no counter") {
  const test::TemporaryFolder folder;
  const test::Outcome usual = render({"-o", folder / "usual.exr", "--stats", "-"});
  REQUIRE(usual.status == 0);
  const std::vector<std::vector<std::string>> troubles = {
      {"--first-capacity", "1"}, {"--first-capacity", "64", "--submit-work", "65536", "--max-memory", "256"}};
  for (std::vector<std::string> trouble : troubles) {
    trouble.insert(trouble.end(), {"-o", folder / "troubled.exr", "--stats", "-"});
    const test::Outcome troubled = render(trouble);
    CAPTURE(troubled.err);
    REQUIRE(troubled.status == 0);
    CHECK(output::read_whole(folder / "usual.exr") == output::read_whole(folder / "troubled.exr"));
    CHECK(rays_in(usual) == rays_in(troubled));
  }
}

TEST_CASE("too little --max-memory is one line that names the least, exit status 1, and no file") {
  const test::TemporaryFolder folder;
  const test::Outcome outcome = crsh({"render", CRSH_SOURCE_DIR "/scenes/office.glb", "-o", folder / "a.png", "-q",
                                      "--size", "24x16", "--bounces", "0", "--max-memory", "1"});
  CHECK(outcome.status == 1);
  CHECK(outcome.error_lines() == 1);
  CHECK(outcome.err.starts_with("crsh: a memory budget of 1 MiB is too little"));
  CHECK(outcome.err.ends_with(": give a larger --max-memory\n"));
  CHECK(outcome.err.find("it needs at least ") != std::string::npos);
  CHECK(folder.size() == 0);
}

TEST_CASE("a full disk is one line, exit status 1, and no file") {
  const test::TemporaryFolder folder;
  fs::create_symlink("/dev/full", folder / "full.png");
  const test::Outcome outcome = render({"-o", folder / "full.png", "-q"});
  CHECK(outcome.status == 1);
  CHECK(outcome.error_lines() == 1);
  CHECK(outcome.err.find("full.png: cannot be written (No space left on device)") != std::string::npos);
  CHECK(folder.size() == 1);
}

TEST_CASE("an unknown device, camera or scene is one line, exit status 1 or 2") {
  const test::TemporaryFolder folder;
  for (const char* option : {"--device", "--camera", "--scene", "--animation"}) {
    const test::Outcome outcome = render({"-o", folder / "a.png", "-q", option, "nosuch"});
    CAPTURE(option);
    CHECK((outcome.status == 1 || outcome.status == 2));
    CHECK(outcome.error_lines() == 1);
    CHECK(outcome.err.find("nosuch") != std::string::npos);
  }
  CHECK(folder.size() == 0);
}

TEST_CASE("without any Vulkan device the exit status is 77 and a package is named") {
  ::setenv("VK_ICD_FILENAMES", "/no/such.json", 1);
  ::setenv("VK_DRIVER_FILES", "/no/such.json", 1);
  const test::TemporaryFolder folder;
  const test::Outcome outcome = render({"-o", folder / "a.png"}), info = crsh({"info"});
  ::unsetenv("VK_ICD_FILENAMES");
  ::unsetenv("VK_DRIVER_FILES");
  for (const test::Outcome& each : {outcome, info}) {
    CHECK(each.status == 77);
    CHECK(each.err.find("mesa-vulkan-drivers") != std::string::npos);
  }
}

TEST_CASE("SIGTERM while rendering ends it by that signal, without any file") {
  const test::TemporaryFolder folder;
  const std::string path = test::crsh_path(), out = folder / "big.exr";
  const pid_t child = ::fork();
  if (child == 0) {
    ::execl(path.c_str(), path.c_str(), "render", cornell.c_str(), "-o", out.c_str(), "--size", "1024x1024",
            "--samples", "64", "-q", nullptr);
    ::_exit(127);
  }
  ::usleep(1'500'000);
  ::kill(child, SIGTERM);
  int status = 0;
  ::waitpid(child, &status, 0);
  CHECK(WIFSIGNALED(status));
  CHECK(folder.size() == 0);
}

}  // namespace
}  // namespace crsh
