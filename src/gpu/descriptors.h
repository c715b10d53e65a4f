#pragma once
// Descriptor sets that live for one submit.

#include <vulkan/vulkan.h>

#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "gpu/acceleration.h"
#include "gpu/buffer.h"
#include "gpu/buffer_set.h"
#include "gpu/image.h"
#include "gpu/program.h"

namespace crsh::gpu {

/// Something for a shader to bind, under the name that the shader declares it by (gpu/reflection.h): a buffer, a part
/// of one, an image (as storage image, layout GENERAL), or the device's own hierarchy. Or, without a name, the tables
/// that are its set 1. All are referred to, not copied.
struct Argument {
  using Bound = std::variant<Binding, const Image*, const AccelerationStructure*, const BufferSet*>;

  Argument(std::string_view as, const Binding& binding) : name(as), bound(binding) {}
  Argument(std::string_view as, const Image& image) : name(as), bound(&image) {}
  Argument(std::string_view as, const AccelerationStructure& structure) : name(as), bound(&structure) {}
  Argument(const BufferSet& tables) : bound(&tables) {}  // NOLINT: meant to convert

  std::string_view name;
  Bound bound;
};
using Arguments = std::span<const Argument>;

/// What stands in the place of an argument's name is a set of tables.
[[nodiscard]] inline bool is_tables(const Argument& argument) {
  return std::holds_alternative<const BufferSet*>(argument.bound);
}

/// Why arguments of these names, in any order, are not what a shader declares; empty where they are. The shader is
/// called `shader`.
[[nodiscard]] std::string misnamed(std::string_view shader, std::span<const Declared> declared,
                                   std::span<const std::string_view> names);

/// Ordinary sets from as many pools as a submit needs; reset() takes them all back.
class Descriptors {
 public:
  explicit Descriptors(Device& device) : device_(device) {}
  ~Descriptors();
  Descriptors(const Descriptors&) = delete;
  Descriptors& operator=(const Descriptors&) = delete;

  /// A set that binds all of `arguments` but tables; names, number, kinds and sizes are asserted. `shader` is what the
  /// shader is called.
  [[nodiscard]] VkDescriptorSet describe(VkDescriptorSetLayout layout, const Reflection& reflection,
                                         Arguments arguments, std::string_view shader);
  void reset();

 private:
  [[nodiscard]] VkDescriptorSet allocate(VkDescriptorSetLayout layout);
  void add_pool();

  Device& device_;
  std::vector<VkDescriptorPool> pools_;
  size_t current_ = 0;  ///< the pool that is being filled
};

}  // namespace crsh::gpu
