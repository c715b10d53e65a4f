#pragma once
// A storage buffer with an allocation of its own.

#include <vulkan/vulkan.h>

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "crsh/assertion.h"
#include "gpu/device.h"

namespace crsh::gpu {

/// Move-only storage buffer (also texel buffer, transfer source and target, vertex and indirect buffer). A default one
/// is empty.
class Buffer {
 public:
  Buffer() = default;
  Buffer(Device& device, uint64_t bytes, std::string_view name, bool host_visible = false);
  ~Buffer();
  Buffer(Buffer&& other) noexcept { *this = std::move(other); }
  Buffer& operator=(Buffer&& other) noexcept;

  [[nodiscard]] uint64_t bytes() const { return bytes_; }
  [[nodiscard]] VkBuffer handle() const { return buffer_; }
  [[nodiscard]] const std::string& name() const { return name_; }
  /// Mapped memory of a host-visible buffer, else null.
  [[nodiscard]] void* mapped() const { return mapped_; }

  /// Makes the buffer hold at least `bytes`; grows by half again at least, and then the CONTENTS ARE LOST.
  /// Never call it while recorded work that uses the buffer is not yet finished.
  void reserve(Device& device, uint64_t bytes, std::string_view name);

 private:
  Device* device_ = nullptr;
  VkBuffer buffer_ = VK_NULL_HANDLE;
  VkDeviceMemory memory_ = VK_NULL_HANDLE;
  void* mapped_ = nullptr;
  uint64_t bytes_ = 0, counted_ = 0;
  std::string name_;
};

/// A part of a buffer to bind; whole buffers convert by themselves. Bytes.
struct Binding {
  Binding(const Buffer& whole) : buffer(&whole), offset(0), bytes(whole.bytes()) {}  // NOLINT: meant to convert
  Binding(const Buffer& part_of, uint64_t first, uint64_t count) : buffer(&part_of), offset(first), bytes(count) {}
  const Buffer* buffer;
  uint64_t offset, bytes;
};

/// Copies bytes to and from device memory, at once (own submit, waits).
void upload_bytes(Device& device, const Buffer& target, uint64_t offset, const void* data, uint64_t bytes);
void download_bytes(Device& device, const Buffer& source, uint64_t offset, void* data, uint64_t bytes);

/// A new device buffer that holds `values` (16 bytes at least, so that it can always be bound).
template <class T>
[[nodiscard]] Buffer upload(Device& device, std::span<const T> values, std::string_view name) {
  Buffer buffer(device, values.size_bytes() ? values.size_bytes() : 16, name);
  if (!values.empty()) upload_bytes(device, buffer, 0, values.data(), values.size_bytes());
  return buffer;
}
template <class T>
[[nodiscard]] Buffer upload(Device& device, const std::vector<T>& values, std::string_view name) {
  return upload(device, std::span<const T>(values), name);
}

/// `count` elements from element `first` on.
template <class T>
[[nodiscard]] std::vector<T> download(Device& device, const Buffer& buffer, uint64_t count, uint64_t first = 0) {
  CRSH_ASSERT((first + count) * sizeof(T) <= buffer.bytes(), "a download past the end of " + buffer.name());
  std::vector<T> values(count);
  if (count) download_bytes(device, buffer, first * sizeof(T), values.data(), count * sizeof(T));
  return values;
}

}  // namespace crsh::gpu
