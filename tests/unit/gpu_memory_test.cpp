// The memory budget, the growth of buffers, and the choice of a device: each test opens devices of its own.

#include <doctest/doctest.h>

#include <cctype>
#include <string>

#include "crsh/error.h"
#include "gpu/buffer.h"
#include "support/device.h"

namespace crsh::gpu {
namespace {

TEST_SUITE_BEGIN("subset");

DeviceRequest request_with(uint64_t memory_budget, uint64_t first_capacity) {
  DeviceRequest request = test::device().request();
  request.memory_budget = memory_budget;
  request.first_capacity = first_capacity;
  return request;
}

TEST_CASE("an allocation past the budget throws and leaves the account as it was") {
  Device device(request_with(1 << 20, 0));
  {
    const Buffer fits(device, 600'000, "fits");
    const uint64_t before = device.allocated_bytes();
    CHECK(device.available_bytes() == (1 << 20) - before);
    try {
      const Buffer too_much(device, 600'000, "too much");
      FAIL("the second buffer was allocated");
    } catch (const OutOfMemory& error) {
      CHECK(error.name == "too much");
      CHECK(error.needed >= 1'200'000);
      CHECK(error.available == 1 << 20);
    }
    CHECK(device.allocated_bytes() == before);
  }
  CHECK(device.allocated_bytes() == 0);
  CHECK(device.peak_bytes() >= 600'000);
}

TEST_CASE("copies do not count as device memory") {
  Device device(request_with(4096, 0));
  const std::vector<uint32_t> values(1024, 7);
  const Buffer all = upload(device, values, "all of the budget");
  CHECK(download<uint32_t>(device, all, 1024) == values);
  CHECK(device.available_bytes() == 0);
}

TEST_CASE("a buffer that no device could hold throws") {
  CHECK_THROWS_AS(Buffer(test::device(), uint64_t(1) << 60, "exbibyte"), OutOfMemory);
}

TEST_CASE("a buffer larger than one allocation throws, whatever the budget") {
  const uint64_t limit = test::device().limits().max_allocation;
  if (limit < uint64_t(1) << 60) CHECK_THROWS_AS(Buffer(test::device(), limit + 4, "one too large"), OutOfMemory);
}

TEST_CASE("a reserved buffer grows by half again, and not past the budget for its own sake") {
  Device device(request_with(100'000, 0));
  Buffer buffer;
  buffer.reserve(device, 10'000, "growing");
  CHECK(buffer.bytes() == 10'000);
  buffer.reserve(device, 9'000, "growing");
  CHECK(buffer.bytes() == 10'000);
  buffer.reserve(device, 10'001, "growing");
  CHECK(buffer.bytes() >= 15'000);
  buffer.reserve(device, 80'000, "growing");
  CHECK(buffer.bytes() < 100'000);
  CHECK(device.peak_bytes() <= 100'000);
  CHECK_THROWS_AS(buffer.reserve(device, 200'000, "growing"), OutOfMemory);
  CHECK(device.allocated_bytes() == 0);
}

TEST_CASE("with a first capacity an empty buffer starts from there") {
  Device device(request_with(0, 64));
  Buffer small, large;
  small.reserve(device, 16, "small");
  CHECK(small.bytes() == 64);
  large.reserve(device, 1000, "large");
  CHECK(large.bytes() >= 1000);
  CHECK(large.bytes() < 1600);
}

/// The message of the UserError that opening a device with this selector throws, or an empty text.
std::string error_of(const std::string& selector) {
  try {
    DeviceRequest request;
    request.selector = selector;
    const Device device(request);
  } catch (const UserError& error) {
    CHECK(error.status() == Exit::failed);
    return error.what();
  }
  return "";
}

TEST_CASE("a device is chosen by index, UUID, and part of its name in any case") {
  const std::vector<DeviceInfo> devices = list_devices();
  REQUIRE(!devices.empty());
  for (const DeviceInfo& device : devices) {
    CAPTURE(device.name);
    CHECK(device.uuid.size() == 36);
    CHECK(!device.api_version.empty());
    if (!device.unusable.empty()) continue;
    std::string name = device.name;
    for (char& c : name) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    CHECK(error_of(std::to_string(device.index)).empty());
    CHECK(error_of(device.uuid).empty());
    CHECK(error_of(name.substr(1)).empty());
  }
}

TEST_CASE("a selector that matches nothing is answered with the list of devices") {
  const std::string message = error_of("no such device");
  CHECK(message.find("'no such device'") != std::string::npos);
  CHECK(message.find(list_devices()[0].name) != std::string::npos);
}

TEST_CASE("a Vulkan error becomes a sentence, and a want of memory OutOfMemory") {
  check(VK_SUCCESS, "resting");
  CHECK_THROWS_AS(check(VK_ERROR_OUT_OF_DEVICE_MEMORY, "drawing"), OutOfMemory);
  CHECK_THROWS_AS(check(VK_ERROR_OUT_OF_HOST_MEMORY, "drawing"), OutOfMemory);
  CHECK_THROWS_WITH_AS(check(VK_ERROR_FORMAT_NOT_SUPPORTED, "making an image"),
                       "making an image failed: the device does not support the image format", UserError);
  try {
    check(VK_ERROR_DEVICE_LOST, "rendering");
  } catch (const UserError& error) {
    CHECK(std::string(error.what()).find("lost while rendering") != std::string::npos);
    CHECK(error.mend() == Mend::less_work);
  }
}

TEST_SUITE_END();

}  // namespace
}  // namespace crsh::gpu
