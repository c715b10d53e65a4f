#include "viewer/shader_folder.h"

#include <fmt/format.h>
#include <stdlib.h>

#include <algorithm>
#include <cstdio>
#include <cstring>
#include <fstream>

#include "crsh/error.h"
#include "gpu/embedded.h"
#include "output/whole_file.h"

namespace crsh::viewer {
namespace {

namespace fs = std::filesystem;

/// A temporary folder, which is removed with all that is in it.
class Folder {
 public:
  Folder() {
    std::string name = (fs::temp_directory_path() / "crsh-shader-XXXXXX").string();
    if (!::mkdtemp(name.data())) throw UserError(name + ": no folder could be made there");
    path_ = name;
  }
  ~Folder() {
    std::error_code ignored;
    fs::remove_all(path_, ignored);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  [[nodiscard]] const fs::path& path() const { return path_; }

 private:
  fs::path path_;
};

/// A shader's name as the build makes it (tools/cmake/shaders.cmake): "path-no-shuffle@VARIANT.comp".
struct Name {
  std::string source, variant;
  bool no_shuffle = false;
};

Name parsed(std::string name) {
  Name made;
  const std::string ending = name.substr(name.rfind('.'));
  name = name.substr(0, name.rfind('.'));
  if (const size_t at = name.find('@'); at != std::string::npos)
    made.variant = name.substr(at + 1), name = name.substr(0, at);
  made.no_shuffle = name.ends_with("-no-shuffle");
  if (made.no_shuffle) name = name.substr(0, name.size() - std::strlen("-no-shuffle"));
  made.source = name + ending;
  return made;
}

std::string in_quotes(const fs::path& path) { return "'" + path.string() + "'"; }

/// Runs a command and returns what it prints; `status` becomes its exit status.
std::string output_of(const std::string& command, int& status) {
  FILE* pipe = ::popen((command + " 2>&1").c_str(), "r");
  if (!pipe) throw UserError("glslangValidator cannot be started: install the Debian package glslang-tools");
  std::string text;
  char part[4096];
  for (size_t count; (count = std::fread(part, 1, sizeof(part), pipe)) > 0;) text.append(part, count);
  status = ::pclose(pipe);
  return text;
}

/// The compiler's first error.
std::string first_error(const std::string& text) {
  const size_t at = text.find("ERROR:");
  const std::string from = at == std::string::npos ? text : text.substr(at);
  return from.substr(0, from.find('\n'));
}

std::string line_after(const fs::path& file, const std::string& start) {
  std::ifstream text(file);
  for (std::string line; std::getline(text, line);)
    if (line.starts_with(start)) return line.substr(start.size());
  return {};
}

std::vector<std::string> includes_of(const fs::path& file) {
  std::vector<std::string> includes;
  std::ifstream text(file);
  const std::string start = "#include \"";
  for (std::string line; std::getline(text, line);)
    if (line.starts_with(start)) includes.push_back(line.substr(start.size(), line.rfind('"') - start.size()));
  return includes;
}

}  // namespace

ShaderFolder::ShaderFolder(fs::path root) : root_(std::move(root)), built_(fs::last_write_time("/proc/self/exe")) {
  if (!fs::is_directory(root_ / "shared"))
    throw UserError("CRSH_SHADER_DIR: " + root_.string() + " is not the folder shaders/ of a checkout");
}

/// When a file or one that it includes was changed last.
ShaderFolder::Time ShaderFolder::newest(const fs::path& file, int depth) {
  std::error_code missing;
  Time time = fs::last_write_time(file, missing);
  if (missing || depth > 16) return Time::min();
  Known& known = files_[file.string()];
  if (known.time != time) known = {time, includes_of(file)};
  for (const std::string& include : known.includes) time = std::max(time, newest(root_ / include, depth + 1));
  return time;
}

std::vector<uint32_t> ShaderFolder::compile(const std::string& name) {
  const Name parts = parsed(name);
  const Folder folder;
  std::string flags = "--quiet --target-env vulkan1.3 --target-env spirv1.5 -I" + in_quotes(root_);
  if (!parts.variant.empty()) {
    const std::string variants = line_after(root_ / parts.source, "// variants: ");
    output::write_whole(folder.path() / "variant.glsl",
                        fmt::format("#include \"{}/{}.glsl\"\n", variants, parts.variant));
    flags += " -I" + in_quotes(folder.path());
  }
  if (parts.no_shuffle) flags += " -DCRSH_NO_SHUFFLE";
  const fs::path result = folder.path() / "result.spv";
  int status = 0;
  const std::string text = output_of(
      fmt::format("glslangValidator {} -o {} {}", flags, in_quotes(result), in_quotes(root_ / parts.source)), status);
  if (status != 0) throw UserError(fmt::format("{}: {}", name, first_error(text)));
  const std::string bytes = output::read_whole(result);
  std::vector<uint32_t> words(bytes.size() / sizeof(uint32_t));
  std::memcpy(words.data(), bytes.data(), words.size() * sizeof(uint32_t));
  return words;
}

bool ShaderFolder::look(const std::vector<std::string>& in_use) {
  std::map<std::string, Time> times;
  Time latest = Time::min();
  for (const std::string& name : in_use) {
    const Name parts = parsed(name);
    Time time = newest(root_ / parts.source);
    if (!parts.variant.empty())
      time =
          std::max(time, newest(root_ / line_after(root_ / parts.source, "// variants: ") / (parts.variant + ".glsl")));
    if (time > built_ && done_[name] != time) times[name] = time, latest = std::max(latest, time);
  }
  if (times.empty() || latest == failed_) return false;  // each error is told once
  failed_ = latest;
  std::map<std::string, std::vector<uint32_t>> made;
  for (const auto& [name, time] : times) {
    made[name] = compile(name);
    if (const std::string fault = gpu::misfit(name, made[name]); !fault.empty())
      throw UserError(fmt::format("{}: {}; the old one stays: such a change needs a build", name, fault));
  }
  failed_ = Time::min();
  for (auto& [name, words] : made) gpu::replace_spirv(name, std::move(words));
  for (const auto& [name, time] : times) done_[name] = time;
  return true;
}

}  // namespace crsh::viewer
