#pragma once
// Descriptor sets that live for one submit.

#include <vulkan/vulkan.h>

#include <initializer_list>
#include <string_view>
#include <variant>
#include <vector>

#include "gpu/acceleration.h"
#include "gpu/buffer.h"
#include "gpu/image.h"
#include "gpu/program.h"

namespace crsh::gpu {

/// Something a shader binds: a buffer, a part of one, an image (as storage image, layout GENERAL), or the device's own
/// hierarchy.
using Argument = std::variant<Binding, const Image*, const AccelerationStructure*>;

/// Ordinary sets from as many pools as a submit needs; reset() takes them all back.
class Descriptors {
 public:
  explicit Descriptors(Device& device) : device_(device) {}
  ~Descriptors();
  Descriptors(const Descriptors&) = delete;
  Descriptors& operator=(const Descriptors&) = delete;

  /// A set that binds `arguments`; their number, kinds and sizes are asserted. `name` is the shader's.
  [[nodiscard]] VkDescriptorSet describe(VkDescriptorSetLayout layout, const Reflection& reflection,
                                         std::initializer_list<Argument> arguments, std::string_view name);
  void reset();

 private:
  [[nodiscard]] VkDescriptorSet allocate(VkDescriptorSetLayout layout);
  void add_pool();

  Device& device_;
  std::vector<VkDescriptorPool> pools_;
  size_t current_ = 0;  ///< the pool that is being filled
};

}  // namespace crsh::gpu
