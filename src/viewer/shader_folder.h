#pragma once
// Shaders that a developer edits while the viewer runs (CRSH_SHADER_DIR).

#include <cstdint>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace crsh::viewer {

/// The folder shaders/ of a checkout. Compiles with glslangValidator what is newer than this program.
class ShaderFolder {
 public:
  /// Throws UserError where there is no such folder.
  explicit ShaderFolder(std::filesystem::path root);

  /// Of the shaders in use ("coherence/trim.comp", "rays/hash@hilbert.comp") compiles those of which a file has
  /// changed, and puts them in the place of the built-in ones: all or, where one is wrong, none. Returns whether any
  /// was; the caller makes pipelines anew. Throws UserError: the compiler's line, or what no longer fits.
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
  Time built_;  ///< when this program was
  std::map<std::string, Known> files_;
  Time failed_ = Time::min();         ///< the newest file of what was wrong
  std::map<std::string, Time> done_;  ///< by shader: the newest file of what was compiled
};

}  // namespace crsh::viewer
