#pragma once
// Images as read from files for comparison: every channel with the bits the file has.

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace crsh::output {

/// What a channel's bits mean: OpenEXR's half, float and uint, or PNG's 8 and 16 bits for 0..1.
enum class Sample { half, real, id, byte, word };

struct Channel {
  std::string name;  ///< "R", "Z", "N.X"
  Sample sample = Sample::real;
  std::vector<uint32_t> bits;  ///< a pixel, rows from the top
  [[nodiscard]] double value(size_t pixel) const;
};

enum class Format { exr, png };

struct Image {
  Format format = Format::exr;
  uint32_t width = 0, height = 0;
  int32_t left = 0, top = 0;      ///< of the first pixel (OpenEXR's data window)
  std::vector<Channel> channels;  ///< sorted by name
  [[nodiscard]] const Channel* find(std::string_view name) const;
};

/// Longest side of an image that is read or written.
inline constexpr uint32_t longest_side = 16384;

/// The layer that a channel belongs to: "beauty" for R, G, B, A and Y, "N" for "N.X", "Z" for "Z".
[[nodiscard]] std::string layer_of(std::string_view channel);

/// Whether `name` means this channel: its layer, or a part of its name that ends at a dot ("Tests.node" is in "Tests"),
/// with or without ".*", or the whole name.
[[nodiscard]] bool in_layer(std::string_view channel, std::string_view name);

/// An OpenEXR or PNG file, told apart by its first bytes. Throws UserError.
[[nodiscard]] Image read_image(const std::filesystem::path& path);

}  // namespace crsh::output
