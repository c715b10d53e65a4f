#pragma once
// OpenEXR files: scanlines, ZIP. The same picture and attributes give the same bytes.

#include <filesystem>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "crsh/picture.h"
#include "output/image.h"

namespace crsh::output {

/// String attributes of the file, by name.
using Attributes = std::vector<std::pair<std::string, std::string>>;

struct EncodedExr {
  std::string bytes;
  uint64_t clamped = 0;  ///< half values beyond 65504, which were written as 65504
};

/// How whole numbers are written. Few programs read OpenEXR's uint; float is exact up to 2^24.
enum class Ids { real, uint };

/// The layers of these names (the beauty's is ""): the beauty as half, the others as float, numbers as `ids` says.
/// Writes worldToCamera, worldToNDC and `attributes`; no path, date, time or device.
[[nodiscard]] EncodedExr encode_exr(const Picture& picture, std::span<const std::string> layers,
                                    const Attributes& attributes, Ids ids = Ids::real);

/// encode_exr to a file that appears whole or not at all. Returns the number of clamped values.
uint64_t write_exr(const std::filesystem::path& path, const Picture& picture, std::span<const std::string> layers,
                   const Attributes& attributes, Ids ids = Ids::real);

/// Reads the first part of an OpenEXR file. It must be flat and not subsampled. Throws UserError that begins with
/// `name`.
[[nodiscard]] Image decode_exr(const std::string& bytes, const std::string& name);

}  // namespace crsh::output
