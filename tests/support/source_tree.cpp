#include "support/source_tree.h"

#include <algorithm>
#include <fstream>
#include <iterator>

namespace crsh::test {

namespace fs = std::filesystem;

std::vector<fs::path> files_of_project(const std::vector<std::string>& extensions) {
  std::vector<fs::path> files;
  const auto take = [&](const fs::directory_entry& entry) {
    if (entry.is_regular_file() && std::ranges::count(extensions, entry.path().extension().string()))
      files.push_back(entry.path());
  };
  const fs::path top = CRSH_SOURCE_DIR;
  for (const fs::directory_entry& entry : fs::directory_iterator(top)) take(entry);
  for (const char* folder : {"src", "shaders", "scenes", "tests", "tools"})
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(top / folder)) take(entry);
  std::ranges::sort(files);
  return files;
}

std::string text_of(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  return {std::istreambuf_iterator<char>(stream), {}};
}

}  // namespace crsh::test
