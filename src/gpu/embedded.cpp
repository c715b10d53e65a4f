#include "gpu/embedded.h"

#include <algorithm>

#include "assertion.h"
#include "gpu/program.h"

namespace crsh::gpu {

std::span<const uint32_t> embedded_spirv(std::string_view file) {
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
