#include "support/device.h"

#include <cstdlib>
#include <memory>
#include <string_view>

namespace crsh::test {
namespace {

std::unique_ptr<gpu::Device>& slot() {
  static std::unique_ptr<gpu::Device> device;
  return device;
}

std::string_view environment(const char* name) {
  const char* value = std::getenv(name);
  return value ? value : "";
}

}  // namespace

gpu::Device& device() {
  if (!slot()) {
    gpu::DeviceRequest request;
    request.selector = environment("CRSH_TEST_DEVICE");
    request.validation = environment("CRSH_TEST_VALIDATION") != "0";
    slot() = std::make_unique<gpu::Device>(request);
  }
  return *slot();
}

uint64_t close_device() {
  const uint64_t messages = slot() ? slot()->validation_messages() : 0;
  slot().reset();
  return messages;
}

}  // namespace crsh::test
