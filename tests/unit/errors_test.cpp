// What is thrown: in the library's own words, which the command line turns into those of its options.

#include <doctest/doctest.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include "cli/mend.h"
#include "crsh/error.h"
#include "frame/state.h"
#include "gpu/device.h"
#include "scene/gltf/fault.h"

namespace crsh {
namespace {

namespace fs = std::filesystem;

static_assert(std::is_base_of_v<std::exception, UserError>);
static_assert(std::is_base_of_v<std::exception, gpu::OutOfMemory>);
static_assert(std::is_base_of_v<std::exception, scene::Fault>);
static_assert(std::is_base_of_v<std::exception, PortionTooLarge>);

/// The code of every file of src/ by its path, without comments.
std::vector<std::pair<std::string, std::string>> sources() {
  static const std::regex comment("//[^\n]*");
  std::vector<std::pair<std::string, std::string>> found;
  const fs::path root = fs::path(CRSH_SOURCE_DIR) / "src";
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(root)) {
    if (entry.path().extension() != ".h" && entry.path().extension() != ".cpp") continue;
    std::ifstream file(entry.path());
    const std::string text{std::istreambuf_iterator<char>(file), {}};
    found.emplace_back(fs::relative(entry.path(), root).string(), std::regex_replace(text, comment, ""));
  }
  return found;
}

/// All that the expression's first group matches.
std::set<std::string> matches(const std::string& text, const std::regex& expression) {
  std::set<std::string> found;
  for (std::sregex_iterator match(text.begin(), text.end(), expression), end; match != end; ++match)
    found.insert((*match)[1]);
  return found;
}

TEST_CASE("no string below the command line speaks of its options") {
  static const std::regex speaks(R"re(("[^"\n]*(--[a-z]|crsh (info|help|render|diff)\b)[^"\n]*"))re");
  size_t files = 0;
  for (const auto& [path, code] : sources()) {
    if (path.starts_with("cli/") || path.starts_with("viewer/")) continue;
    CAPTURE(path);
    for (const std::string& text : matches(code, speaks)) CHECK(text == "none");
    ++files;
  }
  CHECK(files > 100);
}

TEST_CASE("whatever is thrown derives from std::exception") {
  static const std::regex thrown("\\bthrow ([A-Za-z_:]+)");
  static const std::regex derived("\\b(?:struct|class) ([A-Za-z]+) : (?:public )?std::(?:runtime_error|exception)");
  static const std::regex further("\\b(?:struct|class) ([A-Za-z]+) : (?:public )?(?:UserError|Fault) ");
  std::set<std::string> types, sound;
  for (const auto& [path, code] : sources()) {
    types.merge(matches(code, thrown));
    sound.merge(matches(code, derived));
    sound.merge(matches(code, further));
  }
  CHECK(types.size() >= 5);
  for (const std::string& type : types) {
    CAPTURE(type);
    CHECK((type.starts_with("std::") || sound.contains(type.substr(type.rfind(':') + 1))));
  }
}

TEST_CASE("an error says what helps, in plain words and in options") {
  CHECK(std::string(UserError("a: b; c").what()) == "a: b; c");
  CHECK(cli::line_of(UserError("a: b; c")) == "a: b; c");
  const UserError error("no room for 9x9 pixels", Mend::smaller_image, Exit::usage);
  CHECK(std::string(error.what()) == "no room for 9x9 pixels: choose a smaller image");
  CHECK(cli::line_of(error) == "no room for 9x9 pixels: choose a smaller --size");
  CHECK(error.status() == Exit::usage);
}

TEST_CASE("whatever helps has plain words, and words for the command line") {
  static const std::regex speaks("--[a-z]|crsh info");
  for (size_t mend = 1; mend < mend_count; ++mend) {
    CAPTURE(mend);
    CHECK_FALSE(mends[mend].empty());
    CHECK_FALSE(std::regex_search(std::string(mends[mend]), speaks));
    CHECK(std::regex_search(cli::line_of(UserError("", static_cast<Mend>(mend))), speaks));
  }
}

TEST_CASE("a chosen light becomes an option to paste") {
  CHECK(cli::option_of(LightOption{glm::vec3(1, -0.5f, 3), 25.5f}) == "--light 1,-0.5,3,25.5");
  CHECK(cli::option_of(LightOption{glm::vec3(0), {}}) == "--light 0,0,0");
}

}  // namespace
}  // namespace crsh
