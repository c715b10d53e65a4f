#pragma once
// URIs of a glTF file: embedded data, or files beside it.

#include <cstdint>
#include <filesystem>
#include <limits>
#include <string>
#include <string_view>
#include <vector>

namespace crsh::scene {

using Bytes = std::vector<uint8_t>;

/// Which files a scene's URIs may name: those in its own folder and below, or any.
enum class Reach { folder, anywhere };

/// The first `most` bytes of a regular file. Throws a Fault for anything else (a folder, a pipe, a device).
[[nodiscard]] Bytes read_file(const std::filesystem::path& path, uint64_t most = std::numeric_limits<uint64_t>::max());

/// The first `most` bytes behind a URI: decoded data, or a local file's content (relative to `folder`).
/// Nothing is fetched from elsewhere: a Fault. An OutsideFault where the file, all links followed, is beyond `reach`.
[[nodiscard]] Bytes read_uri(const std::string& uri, const std::filesystem::path& folder, Reach reach,
                             uint64_t most = std::numeric_limits<uint64_t>::max());

/// How a message calls a URI: the file's name, or "embedded data".
[[nodiscard]] std::string uri_name(const std::string& uri);

}  // namespace crsh::scene
