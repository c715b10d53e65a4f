#pragma once
// Errors of the user: thrown anywhere, caught once in each main.

#include <array>
#include <cstddef>
#include <stdexcept>
#include <string>
#include <string_view>

namespace crsh {

/// Exit statuses of every program of the project (README, "Exit status").
enum class Exit : int { done = 0, failed = 1, usage = 2, differ = 3, no_device = 77 };

/// What helps. The library says it in plain words; a program may say it in the words of its own options.
enum class Mend {
  none,  ///< the reason says it, or nothing helps
  more_memory,
  smaller_image,
  less_work,
  fewer_levels,
  known_object,
  other_algorithm,
  other_device,
  other_algorithm_or_device,
  smaller_scene_or_other_device
};
inline constexpr size_t mend_count = 10;

/// By Mend.
inline constexpr std::array<std::string_view, mend_count> mends = {"",
                                                                   "allow more memory",
                                                                   "choose a smaller image",
                                                                   "try less work a submit",
                                                                   "choose fewer levels",
                                                                   "choose one of those",
                                                                   "choose another algorithm",
                                                                   "choose another device",
                                                                   "choose another algorithm or device",
                                                                   "leave some out, or choose another device"};

/// Something the user can mend: one line that names the thing, the reason and the mend.
class UserError : public std::runtime_error {
 public:
  /// The line as it stands.
  explicit UserError(const std::string& line, Exit status = Exit::failed)
      : std::runtime_error(line), reason_(line), status_(status) {}
  /// The line is "reason: mend".
  UserError(const std::string& reason, Mend mend, Exit status = Exit::failed)
      : std::runtime_error(reason + ": " + std::string(mends[static_cast<size_t>(mend)])),
        reason_(reason),
        mend_(mend),
        status_(status) {}

  /// The thing and what is wrong with it: the line without its mend.
  [[nodiscard]] const std::string& reason() const { return reason_; }
  [[nodiscard]] Mend mend() const { return mend_; }
  [[nodiscard]] Exit status() const { return status_; }

 private:
  std::string reason_;
  Mend mend_ = Mend::none;
  Exit status_;
};

}  // namespace crsh
