#include "viewer/view.h"

#include <cstdlib>
#include <sstream>
#include <string_view>

#include "output/whole_file.h"

namespace crsh::test {

Outcome view(const std::string& scene, const std::string& script, std::vector<std::string> options) {
  const TemporaryFolder folder;
  const std::string path = folder / "script";
  output::write_whole(path, script);
  std::vector<std::string> arguments = {"--script", path};
  if (!scene.empty()) arguments.insert(arguments.begin(), scene);
  const char* validation = std::getenv("CRSH_TEST_VALIDATION");
  if (!validation || std::string_view(validation) != "0") arguments.push_back("--validation");
  arguments.insert(arguments.end(), options.begin(), options.end());
  return run_program(CRSH_BUILD_DIR "/crsh-view", arguments);
}

Outcome render_copied(const std::string& line, const std::string& file) {
  const std::string tail = "-o picture.png";
  std::string command = line.substr(0, line.rfind(tail)) + "--quiet -o '" + file + "'";
  command = "'" + crsh_path() + "'" + command.substr(command.find(' '));
  return run_program("sh", {"-c", command});
}

std::vector<std::string> lines_with(const std::string& text, const std::string& start) {
  std::vector<std::string> found;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);)
    if (line.starts_with(start)) found.push_back(line);
  return found;
}

}  // namespace crsh::test
