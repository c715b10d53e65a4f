// The floors of src/: a folder includes only what is below it, in the order of CMakeLists.txt.

#include <doctest/doctest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <map>
#include <regex>
#include <sstream>
#include <string>
#include <vector>

namespace crsh {
namespace {

namespace fs = std::filesystem;
const fs::path source = fs::path(CRSH_SOURCE_DIR) / "src";

std::string text_of(const fs::path& path) {
  std::ifstream file(path);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// The words of `set(NAME ...)` in CMakeLists.txt.
std::vector<std::string> words_of(const std::string& name) {
  const std::string text = text_of(fs::path(CRSH_SOURCE_DIR) / "CMakeLists.txt");
  const size_t begin = text.find("set(" + name + " ");
  REQUIRE(begin != std::string::npos);
  std::istringstream words(text.substr(begin + name.size() + 5, text.find(')', begin) - begin - name.size() - 5));
  return {std::istream_iterator<std::string>(words), {}};
}

/// By folder of src/: its floor, the ground's is 0. A folder's rooms are on its floor.
std::map<std::string, size_t> floor_of_folder() {
  std::map<std::string, size_t> floors;
  for (const char* list : {"floors", "window_floors"})
    for (const std::string& folder : words_of(list)) floors.emplace(folder, floors.size());
  for (const std::string& room : words_of("rooms_of_viewer")) floors.emplace("viewer/" + room, floors.at("viewer"));
  return floors;
}

/// Folders of what a file of src/ includes of src/.
std::vector<std::string> folders_included(const fs::path& file) {
  static const std::regex include("#include \"([^\"]+)/[^/\"]+\"");
  const std::string text = text_of(file);
  std::vector<std::string> folders;
  for (std::sregex_iterator match(text.begin(), text.end(), include), end; match != end; ++match)
    if ((*match)[1] != "shared") folders.push_back((*match)[1]);
  return folders;
}

TEST_CASE("a folder of src/ includes only what is on a floor below it") {
  const std::map<std::string, size_t> floors = floor_of_folder();
  size_t files = 0;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(source)) {
    const std::string kind = entry.path().extension().string();
    if (kind != ".h" && kind != ".cpp") continue;
    const std::string folder = fs::relative(entry.path().parent_path(), source).string();
    CAPTURE(entry.path());
    REQUIRE(floors.contains(folder));
    for (const std::string& included : folders_included(entry.path())) {
      CAPTURE(included);
      REQUIRE(floors.contains(included));
      CHECK(floors.at(included) <= floors.at(folder));
      ++files;
    }
  }
  CHECK(files > 500);
}

}  // namespace
}  // namespace crsh
