#pragma once
// What the embedded shaders declare, read from their SPIR-V: what they bind and by which names, push constants,
// workgroups.

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace crsh::gpu {

/// The SPIR-V words of a shader built from shaders/: "coherence/flag_heads.comp", "raster/surface.frag", or a variant
/// "rays/hash@hilbert.comp". Asserts that it exists.
[[nodiscard]] std::span<const uint32_t> embedded_spirv(std::string_view file);
/// Every embedded file, sorted: what the build found (keys and bounds are listed from this).
[[nodiscard]] std::vector<std::string_view> embedded_files();

/// The default value of a shader's specialisation constant: what a variant declares of itself. Asserts that it has one.
[[nodiscard]] uint32_t declared_constant(std::string_view file, uint32_t constant_id);

/// What a binding is. The first three in the order of Argument's alternatives (gpu/descriptors.h); texel buffers lie in
/// sets of tables only (gpu/buffer_set.h).
enum class Resource { storage_buffer, storage_image, acceleration_structure, texel_buffer };

/// Something that a shader binds. Of a storage buffer the name is that of its block's last member, the array
/// (`buffer Rays { Ray rays[]; }` is "rays"); of anything else that of the variable.
struct Declared {
  bool operator==(const Declared&) const = default;
  std::string name;
  Resource kind = Resource::storage_buffer;
};

/// "rays, hits, counters".
[[nodiscard]] std::string names_of(std::span<const Declared> declared);

/// The sets that shaders may bind: the arguments of a dispatch, and tables that are bound together.
inline constexpr uint32_t argument_set = 0, table_set = 1;

/// What a module binds, and what it says of itself; the small part of SPIR-V reflection that dispatches need.
struct Reflection {
  std::vector<Declared> arguments;  ///< set 0 by binding, 0 .. n-1 without gaps; no name twice (all asserted)
  std::vector<Declared> tables;     ///< set 1, as well
  uint32_t push_bytes = 0;          ///< size of the push constant block, at most 128 (asserted)
  uint32_t local_size[3] = {1, 1, 1};
  /// The constant_id behind each local size (layout(local_size_x_id = 0)), or no_constant.
  uint32_t local_size_id[3] = {no_constant, no_constant, no_constant};
  static constexpr uint32_t no_constant = UINT32_MAX;
  bool tells_lanes_apart = false;   ///< it reads gl_SubgroupID or gl_SubgroupInvocationID
  uint32_t colour_attachments = 0;  ///< that a fragment shader writes
};
[[nodiscard]] Reflection reflect(std::span<const uint32_t> spirv);
/// Of modules that share sets and push block, as a vertex and a fragment shader do.
[[nodiscard]] Reflection reflect_together(std::span<const std::span<const uint32_t>> modules);

}  // namespace crsh::gpu
