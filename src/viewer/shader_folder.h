#pragma once
// Shaders that a developer edits while the viewer runs (CRSH_SHADER_DIR).

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace crsh::viewer {

/// The folder shaders/ of a checkout. What is newer there than this program is compiled with glslangValidator.
class ShaderFolder {
 public:
  /// Throws UserError where there is no such folder.
  explicit ShaderFolder(std::filesystem::path root);

  /// Compiles those of the shaders in use ("coherence/trim.comp", "rays/hash@hilbert.comp") whose files have changed,
  /// and puts them in the place of the built-in ones: all of them, or none where one is wrong. Returns whether it did;
  /// the caller then makes pipelines anew. Throws UserError with the compiler's line, or with what no longer fits the
  /// program.
  bool look(const std::vector<std::string>& in_use);

 private:
  using Time = std::filesystem::file_time_type;

  [[nodiscard]] Time newest(const std::filesystem::path& file, int depth = 0);
  [[nodiscard]] std::vector<uint32_t> compile(const std::string& name);

  struct Known {
    Time time = Time::min();
    std::vector<std::string> includes;
  };
  std::filesystem::path root_;
  Time built_;  ///< when this program was built
  std::map<std::string, Known> files_;
  Time failed_ = Time::min();         ///< time of the newest file when compiling failed last
  std::map<std::string, Time> done_;  ///< by shader: time of its newest file when it was compiled last
};

}  // namespace crsh::viewer
