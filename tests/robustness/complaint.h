#pragma once
// What load() says of files made in the tests.

#include <doctest/doctest.h>

#include <filesystem>
#include <string>

#include "../unit/scene_file.h"
#include "crsh/error.h"
#include "scene/gltf/load.h"

namespace crsh::test {

/// The line that load() refuses `path` with; empty where it loads.
inline std::string complaint(const std::filesystem::path& path) {
  try {
    (void)scene::load(path);
    return "";
  } catch (const UserError& error) {
    const std::string line = error.what();
    CHECK(line.starts_with(path.string() + ": "));
    CHECK(line.find("; ") != std::string::npos);
    CHECK(line.find('\n') == std::string::npos);
    CHECK(error.status() == Exit::failed);
    return line;
  }
}

inline std::string complaint(const std::string& content) {
  const Folder folder;
  return complaint(folder.write("scene.gltf", content));
}

inline std::string complaint(const GltfText& file) { return complaint(file.gltf()); }

inline bool says(const std::string& line, const std::string& part) {
  INFO(line);
  CHECK(line.find(part) != std::string::npos);
  return line.find(part) != std::string::npos;
}

inline std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const size_t at = text.find(from);
  REQUIRE(at != std::string::npos);
  return text.replace(at, from.size(), to);
}

}  // namespace crsh::test
