#pragma once
// The account: tests of one batch by ray and by node, for the layers Tests.*. Where such a layer is asked for, kernels
// that test add to it (lib/account.glsl). At the end of the batch each node's tests are shared equally among its rays,
// and each ray's are added to its pixel.

#include <array>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include "gpu/buffer.h"
#include "gpu/recorder.h"
#include "hierarchy/hierarchy.h"
#include "rays/batch.h"
#include "shared/account.h"

namespace crsh::hierarchy {

/// Which types of tests are wanted, by shared::tests_*.
using WantedTests = std::array<bool, shared::tests_count>;

/// The rays of a batch and the surfaces that they come from.
struct AccountIn {
  const rays::Batch& batch;
  const Hierarchy& hierarchy;  ///< depth 0: no nodes
  const gpu::Buffer& order;    ///< uint a sorted position: the ray; not read without nodes
  uint32_t first_surface = 0;  ///< the batch's slot 0 of each segment
  const gpu::Buffer& pixels;   ///< vec4 a surface, whose w has the bits of its pixel (Surfaces::diffuse)
};

/// One word a ray, in creation order, and one a node of each level. A kernel that tests is dispatched as kernel(path),
/// binds buffer_or(any buffer), and has first(type, level) pushed. With an account that nothing is asked of, as
/// no_account, the kernel is compiled without it.
class Account {
 public:
  /// Empties the account for a batch of so many rays and its hierarchy. May submit.
  void begin(gpu::Recorder& recorder, WantedTests wanted, uint32_t rays, const Hierarchy& hierarchy);

  /// The kernel, specialised for the tests that are wanted; `constants` are its own specialisation constants.
  [[nodiscard]] gpu::Kernel kernel(std::string path, std::vector<std::pair<uint32_t, uint32_t>> constants = {}) const;
  /// The buffer to bind: the account's, or `stand_in`, which is not used, where nothing is wanted.
  [[nodiscard]] const gpu::Buffer& buffer_or(const gpu::Buffer& stand_in) const;
  /// Slot of ray 0 (level 0) or of node 0 of a level; 0 where this type is not wanted. Rays are tested against
  /// triangles and objects, nodes count as tests_node or tests_object.
  [[nodiscard]] uint32_t first(uint32_t type, uint32_t level) const;

  [[nodiscard]] bool wants(uint32_t type) const { return wanted_[type]; }
  /// Adds the batch's tests of this type to `tests`: uvec2 a pixel of the image, 64-bit fixed point.
  void share(gpu::Recorder& recorder, const AccountIn& in, uint32_t type, const gpu::Buffer& tests) const;

 private:
  void share_rays(gpu::Recorder& recorder, const AccountIn& in, uint32_t type, const gpu::Buffer& tests) const;
  void share_nodes(gpu::Recorder& recorder, const AccountIn& in, uint32_t type, uint32_t level,
                   const gpu::Buffer& tests) const;

  WantedTests wanted_{};
  std::vector<std::array<uint32_t, shared::tests_count>> first_;  ///< a level, from that of the rays on
  gpu::Buffer buffer_;
};

/// An account that nothing is asked of.
inline const Account no_account;

}  // namespace crsh::hierarchy
