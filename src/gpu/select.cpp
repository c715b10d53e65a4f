// Chooses the device: by index, UUID or part of the name; else a real GPU before a software device.

#include <algorithm>
#include <array>
#include <cctype>

#include "crsh/error.h"
#include "gpu/instance.h"

namespace crsh::gpu {
namespace {

std::string lower(std::string text) {
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

/// Lower is better; "cpu" comes last.
size_t rank(const DeviceInfo& device) {
  static constexpr std::array<std::string_view, 5> order = {"discrete", "integrated", "virtual", "other", "cpu"};
  return static_cast<size_t>(std::find(order.begin(), order.end(), device.type) - order.begin());
}

bool matches(const DeviceInfo& device, const std::string& selector) {
  return selector.empty() || lower(selector) == device.uuid ||
         lower(device.name).find(lower(selector)) != std::string::npos;
}

/// "0: llvmpipe (cpu); 1: ..." with the reason where a device is unusable.
std::string list(const std::vector<DeviceInfo>& devices) {
  std::string text;
  for (const DeviceInfo& device : devices) {
    text += (text.empty() ? "" : "; ") + std::to_string(device.index) + ": " + device.name + " (" + device.type;
    text += device.unusable.empty() ? ")" : ", unusable: " + device.unusable + ")";
  }
  return text;
}

/// The device with the index that the selector is, if any. Indices are tried before names, which may hold the same
/// digits.
const DeviceInfo* by_index(const std::vector<DeviceInfo>& devices, const std::string& selector) {
  for (const DeviceInfo& device : devices)
    if (std::to_string(device.index) == selector) return &device;
  return nullptr;
}

const DeviceInfo* best_match(const std::vector<DeviceInfo>& devices, const std::string& selector) {
  const DeviceInfo* best = nullptr;
  const auto order = [](const DeviceInfo& device) { return std::pair(!device.unusable.empty(), rank(device)); };
  for (const DeviceInfo& device : devices)
    if (matches(device, selector) && (!best || order(device) < order(*best))) best = &device;
  return best;
}

}  // namespace

uint32_t select_device(const std::vector<DeviceInfo>& devices, const std::string& selector) {
  const DeviceInfo* device = by_index(devices, selector);
  if (!device) device = best_match(devices, selector);
  if (!device) throw UserError("no Vulkan device is called '" + selector + "'; there are " + list(devices));
  if (device->unusable.empty()) return device->index;
  if (!selector.empty()) throw UserError("device " + device->name + " cannot be used: " + device->unusable);
  throw UserError(
      "no Vulkan device can be used (" + list(devices) + "): install the Debian package mesa-vulkan-drivers",
      Exit::no_device);
}

}  // namespace crsh::gpu
