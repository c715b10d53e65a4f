#pragma once
// Checks for errors of the programmer. They stay on in release builds.
// (Not "assert.h": src/ is on the include path, and <cassert> would find it.)

#include <string_view>

namespace crsh {

/// Prints file, line and message to stderr and aborts.
[[noreturn]] void assertion_failed(const char* file, int line, std::string_view message);

}  // namespace crsh

/// Aborts with `message` (anything that converts to a string view, built only on failure) unless `condition` holds.
#define CRSH_ASSERT(condition, message) ((condition) ? void(0) : ::crsh::assertion_failed(__FILE__, __LINE__, message))
