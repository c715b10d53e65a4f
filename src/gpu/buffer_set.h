#pragma once
// Buffers that kernels read together: one descriptor set, made once and bound whole.

#include <vulkan/vulkan.h>

#include <span>
#include <string_view>
#include <vector>

#include "gpu/buffer.h"
#include "gpu/reflection.h"

namespace crsh::gpu {

/// How a shader reads a buffer of a set: as a storage buffer, or by texelFetch() of a utextureBuffer. Texel buffers
/// count as sampled images, of which every device has 16 a stage at least; of storage buffers it may have but 4.
enum class ReadAs { storage, texels_r32u, texels_rgba32u };

/// Move-only: descriptor set 1 of the kernels that take it (`layout(set = 1, binding = ...)`), which declare all of it
/// with the same names in the same order. It holds no buffers: where one is made anew, so is the set.
class BufferSet {
 public:
  struct Member {
    std::string_view name;  ///< as shaders declare it (Declared)
    const Buffer& buffer;
    ReadAs read_as = ReadAs::storage;
  };

  BufferSet() = default;
  /// Members are bindings 0, 1, ... Of a texel buffer at most Limits::max_texels texels are seen.
  BufferSet(Device& device, std::span<const Member> members);
  ~BufferSet();
  BufferSet(BufferSet&& other) noexcept { *this = std::move(other); }
  BufferSet& operator=(BufferSet&& other) noexcept;

  [[nodiscard]] VkDescriptorSet handle() const { return set_; }
  [[nodiscard]] const std::vector<Declared>& members() const { return members_; }

 private:
  void allocate();
  void write(std::span<const Member> members);
  [[nodiscard]] VkBufferView view_of(const Member& member);

  Device* device_ = nullptr;
  std::vector<Declared> members_;
  std::vector<VkBufferView> views_;
  VkDescriptorSetLayout layout_ = VK_NULL_HANDLE;
  VkDescriptorPool pool_ = VK_NULL_HANDLE;
  VkDescriptorSet set_ = VK_NULL_HANDLE;
};

/// A set's layout: `declared` by binding, seen by these stages.
[[nodiscard]] VkDescriptorSetLayout make_set_layout(Device& device, std::span<const Declared> declared,
                                                    VkShaderStageFlags stages);
[[nodiscard]] VkDescriptorType descriptor_type(Resource kind);

/// Who may see a set of tables: any kernel and any draw, so that all their layouts of it agree.
inline constexpr VkShaderStageFlags table_stages =
    VK_SHADER_STAGE_COMPUTE_BIT | VK_SHADER_STAGE_VERTEX_BIT | VK_SHADER_STAGE_FRAGMENT_BIT;

}  // namespace crsh::gpu
