#pragma once
// Paths of output files: {frame} stands for the frame's number.

#include <cstdint>
#include <string>

#include "output/image.h"

namespace crsh::output {

/// "out-{frame}.png", "{frame:6}/a.exr" or "-" (PNG on standard output).
class PathPattern {
 public:
  /// Throws UserError (wrong usage) for anything but .exr, .png and "-", and for a malformed {frame:N}.
  explicit PathPattern(const std::string& text);

  [[nodiscard]] Format format() const { return format_; }
  [[nodiscard]] bool to_stdout() const { return text_ == "-"; }
  /// Whether each frame has a path of its own.
  [[nodiscard]] bool has_frame() const;
  /// The number in four digits, or in N for {frame:N}; in more where it needs more.
  [[nodiscard]] std::string at(uint32_t frame) const;
  [[nodiscard]] const std::string& text() const { return text_; }

 private:
  std::string text_;
  Format format_ = Format::png;
};

}  // namespace crsh::output
