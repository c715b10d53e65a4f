#pragma once
// Errors of the user: thrown anywhere, caught once in each main.

#include <stdexcept>
#include <string>

namespace crsh {

/// Exit statuses of every program of the project (README, "Exit status").
enum class Exit : int { done = 0, failed = 1, usage = 2, differ = 3, no_device = 77 };

/// Something the user can mend: one line that names the thing, the reason and the mend.
class UserError : public std::runtime_error {
 public:
  explicit UserError(const std::string& message, Exit status = Exit::failed)
      : std::runtime_error(message), status_(status) {}
  [[nodiscard]] Exit status() const { return status_; }

 private:
  Exit status_;
};

}  // namespace crsh
