#pragma once
// A copy of the tree that can be changed, and built where the changes matter.

#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "recipe.h"
#include "support/program.h"

namespace crsh::test {

class TreeCopy {
 public:
  /// Sources, and this build's compiled shaders. `name` is a folder of the build's; a build may have one at a time.
  explicit TreeCopy(const std::string& name);
  ~TreeCopy();
  TreeCopy(const TreeCopy&) = delete;
  TreeCopy& operator=(const TreeCopy&) = delete;

  void apply(const Recipe& recipe);
  /// Replaces what the file holds once. Throws std::runtime_error where it does not hold it.
  void replace(const std::string& file, const std::string& what, const std::string& with);

  /// crsh, and test programs of these files, below build/: of the changed files and what includes them, however far
  /// away, compiled anew, and the rest as this build has it.
  void build(const std::vector<std::string>& test_files);

  /// A command line, in the copy, without validation layers.
  [[nodiscard]] Outcome run(const std::string& command) const;
  /// Number of sources that the last build compiled anew because of what was changed.
  [[nodiscard]] size_t compiled() const { return compiled_; }
  [[nodiscard]] const std::filesystem::path& path() const { return path_; }

 private:
  void write(const std::string& file, const std::string& text);

  std::filesystem::path path_;
  std::set<std::string> changed_;  ///< files
  size_t compiled_ = 0;
};

/// All tests of a folder of tests/.
[[nodiscard]] std::vector<std::string> tests_in(const std::string& folder);

}  // namespace crsh::test
