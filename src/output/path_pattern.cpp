#include "output/path_pattern.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <string_view>

#include "crsh/error.h"

namespace crsh::output {
namespace {

constexpr std::string_view opening = "{frame";

/// A field "{frame}" or "{frame:N}" at `position`: how many digits it asks for, and its length. Throws UserError.
struct Field {
  int digits = 4;
  size_t length = opening.size() + 1;
};

Field field_at(std::string_view text, size_t position) {
  const std::string_view rest = text.substr(position + opening.size());
  if (rest.starts_with('}')) return {};
  if (rest.size() >= 3 && rest[0] == ':' && rest[1] >= '1' && rest[1] <= '9' && rest[2] == '}')
    return {rest[1] - '0', opening.size() + 3};
  throw UserError("a frame's number is written {frame}, or {frame:N} for N digits, 1 to 9", Exit::usage);
}

std::string lower_extension(const std::string& path) {
  std::string extension = std::filesystem::path(path).extension().string();
  std::ranges::transform(extension, extension.begin(), [](unsigned char c) { return std::tolower(c); });
  return extension;
}

Format format_of(const std::string& path) {
  const std::string extension = lower_extension(path);
  if (extension == ".exr") return Format::exr;
  if (extension == ".png" || path == "-") return Format::png;
  throw UserError("an output is a path that ends in .exr or .png, or - for PNG on standard output", Exit::usage);
}

}  // namespace

PathPattern::PathPattern(const std::string& text) : text_(text), format_(format_of(text)) {
  [[maybe_unused]] const std::string checked = at(0);
}

bool PathPattern::has_frame() const { return text_.find(opening) != std::string::npos; }

std::string PathPattern::at(uint32_t frame) const {
  std::string path;
  size_t done = 0;
  for (size_t next; (next = text_.find(opening, done)) != std::string::npos;) {
    const Field field = field_at(text_, next);
    path += text_.substr(done, next - done) + fmt::format("{:0{}}", frame, field.digits);
    done = next + field.length;
  }
  return path + text_.substr(done);
}

}  // namespace crsh::output
