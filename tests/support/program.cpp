#include "support/program.h"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <iterator>

#include "support/temporary_folder.h"

namespace crsh::test {
namespace {

std::string content(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

void redirect(int stream, const std::string& path) {
  const int file = ::open(path.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
  ::dup2(file, stream);
  ::close(file);
}

[[noreturn]] void become(const std::string& program, const std::vector<std::string>& arguments) {
  std::vector<char*> line = {const_cast<char*>(program.c_str())};
  for (const std::string& argument : arguments) line.push_back(const_cast<char*>(argument.c_str()));
  line.push_back(nullptr);
  ::execvp(program.c_str(), line.data());
  ::_exit(127);
}

}  // namespace

size_t Outcome::error_lines() const { return static_cast<size_t>(std::ranges::count(err, '\n')); }

Outcome run_program(const std::string& program, const std::vector<std::string>& arguments,
                    const std::string& stdout_path) {
  const TemporaryFolder folder;
  const std::string out = stdout_path.empty() ? folder / "out" : stdout_path, err = folder / "err";
  const pid_t child = ::fork();
  if (child == 0) {
    redirect(STDOUT_FILENO, out);
    redirect(STDERR_FILENO, err);
    become(program, arguments);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  return {WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status), stdout_path.empty() ? content(out) : "",
          content(err)};
}

std::string crsh_path() {
  const char* chosen = std::getenv("CRSH_BINARY");
  return chosen ? chosen : CRSH_BUILD_DIR "/crsh";
}

Outcome crsh(const std::vector<std::string>& arguments, const std::string& stdout_path) {
  return run_program(crsh_path(), arguments, stdout_path);
}

}  // namespace crsh::test
