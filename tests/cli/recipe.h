#pragma once
// What CONTRIBUTING.md's "One of each, step by step" tells its reader to do.

#include <set>
#include <string>
#include <vector>

namespace crsh::test {

/// A new file, or code that goes into one of the project's.
struct Edit {
  std::string file;       ///< in the tree
  std::string line;       ///< where in the file, without its indentation; empty: the file is new
  bool in_place = false;  ///< of the line; else before it
  std::string code;
};

struct Recipe {
  std::vector<Edit> edits;
  std::vector<std::string> commands;  ///< to be run in the tree, in this order
  [[nodiscard]] std::set<std::string> files() const;
};

/// The step under this heading. Code follows "`FILE`:", "`FILE`, before `LINE`:" or "`FILE`, in place of `LINE`:";
/// blocks without a language are commands. Throws std::runtime_error where there is no such heading, or code that is
/// said to go nowhere.
[[nodiscard]] Recipe recipe(const std::string& heading);

/// The code between ``` that follows these words of CONTRIBUTING.md.
[[nodiscard]] std::string code_after(const std::string& words);

}  // namespace crsh::test
