#pragma once
// Small glTF files made in the tests, and a folder of their own to lie in.

#include <unistd.h>
#include <cstdint>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "scene/gltf/load.h"
#include "scene/scene.h"

namespace crsh::test {

/// A folder that lives as long as the object.
class Folder {
 public:
  Folder() {
    static int count = 0;
    path_ = std::filesystem::temp_directory_path() /
            ("crsh-scene-" + std::to_string(getpid()) + "-" + std::to_string(count++));
    std::filesystem::create_directories(path_);
  }
  ~Folder() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;

  [[nodiscard]] std::filesystem::path path(const std::string& name) const { return path_ / name; }
  std::filesystem::path write(const std::string& name, const std::string& content) const {
    std::ofstream(path(name), std::ios::binary) << content;
    return path(name);
  }

 private:
  std::filesystem::path path_;
};

inline std::string base64(const std::string& bytes) {
  static const char digits[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string out;
  for (size_t i = 0; i < bytes.size(); i += 3) {
    uint32_t word = 0;
    for (size_t k = 0; k < 3; ++k) word = word << 8u | (i + k < bytes.size() ? static_cast<uint8_t>(bytes[i + k]) : 0u);
    for (size_t k = 0; k < 4; ++k) out += i + k <= bytes.size() ? digits[word >> (18 - 6 * k) & 63u] : '=';
  }
  return out;
}

template <class T>
std::string bytes_of(const std::vector<T>& values) {
  std::string out(values.size() * sizeof(T), '\0');
  if (!values.empty()) std::memcpy(out.data(), values.data(), out.size());
  return out;
}

inline std::string glb_chunk(uint32_t type, std::string content, char padding) {
  while (content.size() % 4 != 0) content += padding;
  return bytes_of<uint32_t>({static_cast<uint32_t>(content.size()), type}) + content;
}

/// A glTF file in the making. Members are JSON texts that tests may replace.
struct GltfText {
  std::string buffer;  ///< all binary data
  std::vector<std::string> views, accessors;
  std::string primitives;  ///< of mesh 0
  std::string nodes = R"({"mesh":0})";
  std::string scenes = R"("scenes":[{"nodes":[0]}],"scene":0)";
  std::string more;  ///< further members of the root, each with a comma before it
  std::string asset = R"({"version":"2.0"})";
  std::string more_buffers;  ///< behind the first, each with a comma before it

  /// Appends a bufferView with `content`; `options` are further members.
  size_t view(const std::string& content, const std::string& options = "") {
    while (buffer.size() % 4 != 0) buffer += '\0';
    views.push_back(R"({"buffer":0,"byteOffset":)" + std::to_string(buffer.size()) + R"(,"byteLength":)" +
                    std::to_string(content.size()) + options + "}");
    buffer += content;
    return views.size() - 1;
  }

  /// Appends an accessor; `options` are further members ("bufferView" among them).
  size_t accessor(const std::string& type, int component, size_t count, const std::string& options) {
    accessors.push_back(R"({"type":")" + type + R"(","componentType":)" + std::to_string(component) + R"(,"count":)" +
                        std::to_string(count) + options + "}");
    return accessors.size() - 1;
  }

  /// Values of one accessor with a view of its own.
  template <class T>
  size_t values(const std::string& type, int component, size_t count, const std::vector<T>& data,
                const std::string& options = "") {
    const size_t place = view(bytes_of(data));
    return accessor(type, component, count, R"(,"bufferView":)" + std::to_string(place) + options);
  }

  size_t positions(const std::vector<float>& data) { return values("VEC3", 5126, data.size() / 3, data); }

  [[nodiscard]] std::string text(const std::string& buffer_members) const {
    const auto list = [](const std::vector<std::string>& items) {
      std::string out;
      for (const std::string& item : items) out += (out.empty() ? "" : ",") + item;
      return out;
    };
    std::string out = R"({"asset":)" + asset + "," + scenes + R"(,"nodes":[)" + nodes +
                      R"(],"meshes":[{"name":"m","primitives":[)" + primitives + "]}]";
    out += R"(,"accessors":[)" + list(accessors) + R"(],"bufferViews":[)" + list(views) +
           R"(],"buffers":[{"byteLength":)" + std::to_string(buffer.size());
    return out + buffer_members + "}" + more_buffers + "]" + more + "}";
  }

  /// A .gltf with its data embedded.
  [[nodiscard]] std::string gltf() const {
    return text(R"(,"uri":"data:application/octet-stream;base64,)" + base64(buffer) + "\"");
  }

  [[nodiscard]] std::string glb() const {
    const std::string chunks = glb_chunk(0x4E4F534A, text(""), ' ') + glb_chunk(0x004E4942, buffer, '\0');
    return bytes_of<uint32_t>({0x46546C67, 2, static_cast<uint32_t>(12 + chunks.size())}) + chunks;
  }

  [[nodiscard]] scene::Scene load(const std::string& which = "") const {
    const Folder folder;
    return scene::load(folder.write("scene.gltf", gltf()), which);
  }
};

inline const std::vector<float> unit_square = {0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0};

/// One triangle of three vertices, without indices.
inline GltfText one_triangle() {
  GltfText out;
  out.positions({0, 0, 0, 1, 0, 0, 0, 1, 0});
  out.primitives = R"({"attributes":{"POSITION":0}})";
  return out;
}

}  // namespace crsh::test
