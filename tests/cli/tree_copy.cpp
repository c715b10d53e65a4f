#include "tree_copy.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <map>
#include <sstream>
#include <stdexcept>

#include "output/whole_file.h"

namespace crsh::test {
namespace {

namespace fs = std::filesystem;

const fs::path tree = CRSH_SOURCE_DIR;

void require(const Outcome& outcome, const std::string& command) {
  if (outcome.status) throw std::runtime_error(command + " failed:\n" + outcome.out + outcome.err);
}

/// Which files of a tree include which, from their text: as the compiler finds them, but for what is generated.
class Includes {
 public:
  explicit Includes(const fs::path& root) : root_(root) {
    for (const char* folder : {"src", "shaders", "tests"})
      for (const fs::directory_entry& entry : fs::recursive_directory_iterator(root / folder))
        if (is_source(entry)) read(fs::relative(entry.path(), root).string());
  }

  /// Files that include one of these, however far away, and these themselves.
  [[nodiscard]] std::set<std::string> that_reach(const std::set<std::string>& files) const {
    std::set<std::string> found;
    std::vector<std::string> left(files.begin(), files.end());
    while (!left.empty()) {
      const std::string file = left.back();
      left.pop_back();
      if (!found.insert(file).second) continue;
      const auto [begin, end] = includers_.equal_range(file);
      for (auto each = begin; each != end; ++each) left.push_back(each->second);
    }
    return found;
  }

 private:
  static bool is_source(const fs::directory_entry& entry) {
    static const std::set<std::string> kinds = {".cpp", ".h", ".comp", ".glsl", ".vert", ".frag"};
    return entry.is_regular_file() && kinds.contains(entry.path().extension().string());
  }

  void read(const std::string& file) {
    std::istringstream lines(output::read_whole(root_ / file));
    for (std::string line; std::getline(lines, line);) {
      if (!line.starts_with("#include \"")) continue;
      const std::string name = line.substr(10, line.find('"', 10) - 10);
      for (const fs::path& folder :
           {fs::path(file).parent_path(), fs::path("src"), fs::path("shaders"), fs::path("tests")})
        if (fs::exists(root_ / folder / name)) includers_.emplace((folder / name).lexically_normal().string(), file);
    }
  }

  fs::path root_;
  std::multimap<std::string, std::string> includers_;  ///< by what is included
};

std::string trimmed(const std::string& line) {
  const size_t begin = line.find_first_not_of(' ');
  return begin == std::string::npos ? "" : line.substr(begin);
}

/// The text with the code before, or in place of, the one line that is so.
std::string inserted(const std::string& text, const Edit& edit) {
  std::istringstream lines(text);
  std::string result;
  size_t places = 0;
  for (std::string line; std::getline(lines, line); result += line + "\n") {
    if (trimmed(line) != edit.line) continue;
    result += edit.code;
    if (edit.in_place) line.clear();
    ++places;
  }
  if (places != 1) throw std::runtime_error(fmt::format("{} has {} lines {}", edit.file, places, edit.line));
  return result;
}

}  // namespace

TreeCopy::TreeCopy(const std::string& name) : path_(fs::path(CRSH_BUILD_DIR) / name) {
  fs::remove_all(path_);
  fs::create_directories(path_ / "tools");
  fs::create_directories(path_ / "build");
  for (const char* folder : {"shaders", "src", "tests", "tools/cmake"})
    require(run_program("cp", {"-a", (tree / folder).string(), (path_ / folder).string()}), "cp");
  fs::create_directory_symlink(tree / "scenes", path_ / "scenes");
  // Younger than their sources: make compiles only what changes.
  require(run_program("cp", {"-r", CRSH_BUILD_DIR "/shaders", (path_ / "build").string()}), "cp");
}

TreeCopy::~TreeCopy() {
  std::error_code ignored;
  fs::remove_all(path_, ignored);
}

void TreeCopy::write(const std::string& file, const std::string& text) {
  output::write_whole(path_ / file, text);
  changed_.insert(file);
}

void TreeCopy::apply(const Recipe& recipe) {
  for (const Edit& edit : recipe.edits) {
    const bool exists = fs::exists(path_ / edit.file);
    if (exists == edit.line.empty())
      throw std::runtime_error(edit.file + (exists ? " is there already" : " is not there"));
    write(edit.file, exists ? inserted(output::read_whole(path_ / edit.file), edit) : edit.code);
  }
}

void TreeCopy::replace(const std::string& file, const std::string& what, const std::string& with) {
  std::string text = output::read_whole(path_ / file);
  const size_t at = text.find(what);
  if (at == std::string::npos) throw std::runtime_error(file + " does not say " + what);
  write(file, text.replace(at, what.size(), with));
}

void TreeCopy::build(const std::vector<std::string>& test_files) {
  std::vector<std::string> sources;
  for (const std::string& file : Includes(path_).that_reach(changed_)) {
    if (file.ends_with(".cpp")) sources.push_back(file);
    else if (file.ends_with(".comp")) fs::last_write_time(path_ / file, fs::file_time_type::clock::now());
  }
  compiled_ = sources.size();
  for (const std::string& test : test_files)  // what reads or writes the tree has to do so with the copy
    if (output::read_whole(path_ / test).find("CRSH_SOURCE_DIR") != std::string::npos) sources.push_back(test);
  require(run_program("cmake", {"-G", "Unix Makefiles", "-S", (path_ / "tests/extension").string(), "-B",
                                (path_ / "build").string(), "-DCOPY=" + path_.string(), "-DBUILD=" CRSH_BUILD_DIR,
                                fmt::format("-DCHANGED={}", fmt::join(sources, ";")),
                                fmt::format("-DTESTS={}", fmt::join(test_files, ";"))}),
          "cmake");
  require(run_program("cmake", {"--build", (path_ / "build").string(), "-j2"}), "cmake --build");
}

Outcome TreeCopy::run(const std::string& command) const {
  return run_program("sh", {"-c", "cd '" + path_.string() + "' && export CRSH_TEST_VALIDATION=0 && " + command});
}

std::vector<std::string> tests_in(const std::string& folder) {
  std::vector<std::string> files;
  for (const fs::directory_entry& entry : fs::directory_iterator(tree / "tests" / folder))
    if (entry.path().extension() == ".cpp") files.push_back(fs::relative(entry.path(), tree).string());
  std::ranges::sort(files);
  return files;
}

}  // namespace crsh::test
