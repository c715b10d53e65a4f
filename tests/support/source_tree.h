#pragma once
// The project's own files, for tests that read them.

#include <filesystem>
#include <string>
#include <vector>

namespace crsh::test {

/// Files of the project with one of these extensions (".md"), in the order of their paths: those at its top, and all
/// below src/, shaders/, scenes/, tests/ and tools/.
[[nodiscard]] std::vector<std::filesystem::path> files_of_project(const std::vector<std::string>& extensions);

[[nodiscard]] std::string text_of(const std::filesystem::path& file);

}  // namespace crsh::test
