#pragma once
// Runs programs as a user does.

#include <string>
#include <vector>

namespace crsh::test {

struct Outcome {
  int status = 0;        ///< exit status; 128 + signal where one ended it
  std::string out, err;  ///< what it wrote
  [[nodiscard]] size_t error_lines() const;
};

/// `program` is looked up in PATH; `stdout_path`, when not empty, is where standard output goes.
[[nodiscard]] Outcome run_program(const std::string& program, const std::vector<std::string>& arguments,
                                  const std::string& stdout_path = {});

/// crsh of this build, or of CRSH_BINARY in the environment.
[[nodiscard]] Outcome crsh(const std::vector<std::string>& arguments, const std::string& stdout_path = {});

/// The path of that crsh.
[[nodiscard]] std::string crsh_path();

}  // namespace crsh::test
