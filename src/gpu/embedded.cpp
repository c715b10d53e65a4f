#include "gpu/embedded.h"

#include <algorithm>
#include <map>
#include <mutex>
#include <string>

#include "crsh/assertion.h"
#include "gpu/program.h"

namespace crsh::gpu {

namespace {

/// Files that are used in place of embedded ones. The map never moves its values, so that spans into them stay valid.
struct Replaced {
  std::mutex mutex;
  std::map<std::string, std::vector<uint32_t>, std::less<>> files;
};

Replaced& replaced() {
  static Replaced files;
  return files;
}

}  // namespace

void replace_spirv(std::string_view file, std::vector<uint32_t> words) {
  const std::lock_guard lock(replaced().mutex);
  replaced().files[std::string(file)] = std::move(words);
}

std::span<const uint32_t> embedded_spirv(std::string_view file) {
  {
    const std::lock_guard lock(replaced().mutex);
    if (const auto found = replaced().files.find(file); found != replaced().files.end()) return found->second;
  }
  const EmbeddedFile* entry = embedded_table;
  while (!entry->name.empty() && entry->name != file) ++entry;
  CRSH_ASSERT(!entry->name.empty(), "no shader is called " + std::string(file));
  return {entry->first, entry->end};
}

std::vector<std::string_view> embedded_files() {
  std::vector<std::string_view> names;
  for (const EmbeddedFile* entry = embedded_table; !entry->name.empty(); ++entry) names.push_back(entry->name);
  std::sort(names.begin(), names.end());
  return names;
}

}  // namespace crsh::gpu
