// The library as others find it: installed, moved, and linked by the program that src/crsh/README.md shows; and the
// build of a server, which has no windows.

#include <doctest/doctest.h>

#include <half.h>
#include <stdlib.h>

#include <cstring>
#include <filesystem>
#include <string>
#include <vector>

#include "output/image.h"
#include "output/whole_file.h"
#include "support/program.h"
#include "support/temporary_folder.h"

namespace crsh {
namespace {

namespace fs = std::filesystem;

const fs::path tree = CRSH_SOURCE_DIR;
const std::string cornell = CRSH_SOURCE_DIR "/scenes/cornell.glb";

#ifdef __SANITIZE_ADDRESS__
const std::string flags = "-fsanitize=address,undefined";
#else
const std::string flags;
#endif

/// The code in the README that begins with ```LANGUAGE.
std::string example(const std::string& language) {
  const std::string text = output::read_whole(tree / "src/crsh/README.md");
  const size_t at = text.find("```" + language + "\n");
  REQUIRE(at != std::string::npos);
  const size_t begin = text.find('\n', at) + 1;
  return text.substr(begin, text.find("```", begin) - begin);
}

std::string run(const std::string& program, const std::vector<std::string>& arguments) {
  const test::Outcome outcome = test::run_program(program, arguments);
  CAPTURE(program);
  CAPTURE(outcome.out);
  CAPTURE(outcome.err);
  REQUIRE(outcome.status == 0);
  return outcome.out;
}

/// Installs to one place and moves all to another: nothing in it may know where it was.
fs::path installed(const test::TemporaryFolder& folder) {
  const fs::path before = folder.path() / "before", after = folder.path() / "after";
  run("cmake", {"--install", CRSH_BUILD_DIR, "--component", "library", "--prefix", before.string()});
  fs::rename(before, after);
  return after;
}

/// Every installed header, each the first of a file of its own.
std::string include_all(const fs::path& prefix, const fs::path& project) {
  std::string files;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(prefix / "include")) {
    if (!entry.is_regular_file()) continue;
    const std::string header = fs::relative(entry.path(), prefix / "include").string();
    const std::string name = "header" + std::to_string(files.size()) + ".cpp";
    output::write_whole(project / name, "#include <" + header + ">\n#include <" + header + ">\n");
    files += " " + name;
    const std::string text = output::read_whole(entry.path());
    for (const char* inside : {"vulkan", "\"gpu/", "\"scene/", "fmt/", "nlohmann"})
      CHECK_MESSAGE(text.find(std::string(inside)) == std::string::npos, header);
  }
  return files;
}

/// Builds the README's program against the library at `prefix`, with all its headers besides.
fs::path built_by_another(const fs::path& prefix, const fs::path& project) {
  fs::create_directories(project);
  output::write_whole(project / "main.cpp", example("cpp"));
  const std::string headers = include_all(prefix, project);
  CHECK(headers.size() > 100);
  output::write_whole(project / "CMakeLists.txt",
                      example("cmake") + "add_library(headers OBJECT" + headers +
                          ")\ntarget_link_libraries(headers PRIVATE crsh::crsh)\n" +
                          "target_compile_options(headers PRIVATE -Wall -Wextra -Werror)\n"
                          "set_target_properties(headers PROPERTIES NO_SYSTEM_FROM_IMPORTED ON)\n");
  run("cmake", {"-G", "Ninja", "-S", project.string(), "-B", (project / "build").string(),
                "-DCMAKE_PREFIX_PATH=" + prefix.string(), "-DCMAKE_CXX_FLAGS=" + flags, "-DCMAKE_BUILD_TYPE=Release"});
  run("cmake", {"--build", (project / "build").string()});
  return project / "build/yours";
}

std::vector<float> floats_of(const std::string& bytes) {
  std::vector<float> values(bytes.size() / sizeof(float));
  std::memcpy(values.data(), bytes.data(), values.size() * sizeof(float));
  return values;
}

TEST_CASE("a program of someone else's, linked to the installed library, gets the floats of crsh render") {
  const test::TemporaryFolder folder;
  const fs::path program = built_by_another(installed(folder), folder.path() / "yours");
  ::setenv("ASAN_OPTIONS", "detect_leaks=0", 0);  // the driver's: crsh/leaks.h is not installed
  const std::vector<float> values = floats_of(run(program.string(), {cornell}));
  REQUIRE(test::crsh({"render", cornell, "-q", "--size", "64x48", "-o", folder / "a.exr"}).status == 0);
  const output::Image image = output::read_image(folder / "a.exr");
  REQUIRE(values.size() == size_t(64) * 48 * 4);
  size_t different = 0, lit = 0;
  for (const size_t channel : {0, 1, 2, 3}) {
    const std::vector<uint32_t>& bits = image.find(std::string(1, "RGBA"[channel]))->bits;
    for (size_t pixel = 0; pixel < bits.size(); ++pixel) {
      different += bits[pixel] != Imath::half(values[4 * pixel + channel]).bits();
      lit += bits[pixel] != 0;
    }
  }
  CHECK(different == 0);
  CHECK(lit > 5000);
}

TEST_CASE("the library is found by its minor version only") {
  const test::TemporaryFolder folder;
  const fs::path prefix = installed(folder);
  const auto find = [&](const std::string& version) {
    const fs::path project = folder.path() / version;
    fs::create_directories(project);
    output::write_whole(project / "CMakeLists.txt",
                        "cmake_minimum_required(VERSION 3.25)\nproject(x LANGUAGES CXX)\n"
                        "find_package(crsh " +
                            version + " REQUIRED)\n");
    return test::run_program("cmake", {"-G", "Ninja", "-S", project.string(), "-B", (project / "build").string(),
                                       "-DCMAKE_PREFIX_PATH=" + prefix.string()});
  };
  CHECK(find("0.1").status == 0);
  const test::Outcome other = find("0.2");
  CHECK(other.status != 0);
  CHECK(other.err.find("0.1.0") != std::string::npos);
}

/// Configures this tree as on a machine that has no GLFW.
test::Outcome configure(const std::string& folder, const std::string& viewer, const std::string& tests) {
  return test::run_program("cmake", {"-G", "Ninja", "-S", tree.string(), "-B", folder, "-DCRSH_VIEWER=" + viewer,
                                     "-DBUILD_TESTING=" + tests, "-DCMAKE_DISABLE_FIND_PACKAGE_glfw3=ON"});
}

/// None of these words is in the file.
void check_absent(const std::string& path, const std::vector<std::string>& words) {
  const std::string text = output::read_whole(path);
  for (const std::string& word : words) CHECK_MESSAGE(text.find(word) == std::string::npos, word);
}

TEST_CASE("without the viewer the build asks for no window library, and makes the library all the same") {
  const test::TemporaryFolder folder;
  const test::Outcome without = configure(folder / "OFF", "OFF", "OFF");
  CAPTURE(without.err);
  REQUIRE(without.status == 0);
  check_absent(folder / "OFF/build.ninja", {"imgui", "glfw"});
  check_absent(folder / "OFF/compile_commands.json", {"src/viewer/", "src/gpu/window/", "tests/"});
  const std::string targets = run("cmake", {"--build", folder / "OFF", "--target", "help"});
  CHECK(targets.find("crsh_library") != std::string::npos);
  CHECK(targets.find("crsh-view") == std::string::npos);

  const test::Outcome with = configure(folder / "ON", "ON", "OFF");  // it would have been asked for
  CHECK(with.status != 0);
  CHECK(with.err.find("libglfw3-dev") != std::string::npos);
}

TEST_CASE("without the viewer the tests link nothing of it") {
  const test::TemporaryFolder folder;
  REQUIRE(configure(folder / "OFF", "OFF", "ON").status == 0);
  CHECK(output::read_whole(folder / "OFF/build.ninja").find("test_unit") != std::string::npos);
  check_absent(folder / "OFF/build.ninja", {"imgui", "glfw", "crsh_viewer", "test_viewer"});
}

}  // namespace
}  // namespace crsh
