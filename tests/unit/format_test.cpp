// How the sources look: as .clang-format and shaders/.clang-format make them, within 120 columns.

#include <doctest/doctest.h>

#include <algorithm>
#include <regex>
#include <set>
#include <sstream>

#include "support/program.h"
#include "support/source_tree.h"

namespace crsh {
namespace {

namespace fs = std::filesystem;

std::vector<fs::path> sources() { return test::files_of_project({".cpp", ".h", ".comp", ".glsl", ".vert", ".frag"}); }

/// Characters of a line of UTF-8.
size_t columns(const std::string& line) {
  return size_t(std::ranges::count_if(line, [](char byte) { return (byte & 0xc0) != 0x80; }));
}

/// The files that clang-format's warnings name: "FILE:LINE:COLUMN: error: ...".
std::set<std::string> files_named(const std::string& warnings) {
  static const std::regex warning("(^|\n)([^:\n]+):[0-9]+:[0-9]+: (error|warning):");
  std::set<std::string> files;
  for (std::sregex_iterator match(warnings.begin(), warnings.end(), warning), end; match != end; ++match)
    files.insert((*match)[2]);
  return files;
}

TEST_CASE("every source file is as clang-format makes it") {
  if (test::run_program("clang-format", {"--version"}).status != 0) {
    MESSAGE("skipped: clang-format is not installed");
    return;
  }
  std::vector<std::string> arguments = {"--dry-run", "--Werror"};
  for (const fs::path& file : sources()) arguments.push_back(file.string());
  REQUIRE(arguments.size() > 500);
  const test::Outcome outcome = test::run_program("clang-format", arguments);
  for (const std::string& file : files_named(outcome.err)) FAIL_CHECK("run clang-format -i " << file);
  CHECK(outcome.status == 0);
}

TEST_CASE("no line of a source file is longer than 120 columns") {
  for (const fs::path& file : sources()) {
    CAPTURE(file);
    std::istringstream text(test::text_of(file));
    size_t number = 0;
    for (std::string line; std::getline(text, line);) {
      ++number;
      CAPTURE(number);
      CHECK(columns(line) <= 120);
    }
  }
}

}  // namespace
}  // namespace crsh
