#pragma once
// The device that all tests of one executable share.

#include <cstdint>

#include "gpu/device.h"

namespace crsh::test {

/// Opened at first use: with validation unless CRSH_TEST_VALIDATION=0, chosen by CRSH_TEST_DEVICE.
[[nodiscard]] gpu::Device& device();

/// Closes it and returns the number of its validation messages.
uint64_t close_device();

}  // namespace crsh::test
