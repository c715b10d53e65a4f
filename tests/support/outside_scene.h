#pragma once
// A scene that names a file outside its own folder.

#include <cstring>
#include <filesystem>
#include <string>

#include "output/whole_file.h"
#include "support/temporary_folder.h"

namespace crsh::test {

/// Writes a triangle whose positions lie beside its folder; returns its path.
inline std::string outside_scene(const TemporaryFolder& folder) {
  const float positions[9] = {0, 0, 0, 1, 0, 0, 0, 1, 0};
  std::string bytes(sizeof positions, '\0');
  std::memcpy(bytes.data(), positions, sizeof positions);
  std::filesystem::create_directories(folder / "scene");
  output::write_whole(folder / "three.bin", bytes);
  output::write_whole(folder / "scene/s.gltf", R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],
"nodes":[{"mesh":0}],"meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],
"accessors":[{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"}],
"bufferViews":[{"buffer":0,"byteLength":36}],"buffers":[{"byteLength":36,"uri":"../three.bin"}]})");
  return folder / "scene/s.gltf";
}

}  // namespace crsh::test
