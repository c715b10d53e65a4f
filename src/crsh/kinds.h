#pragma once
// The table of ray kinds, which the command line, the counters and the layers all iterate.

#include <array>
#include <cstddef>
#include <string_view>

#include "shared/ray.h"

namespace crsh {

inline constexpr size_t kind_count = shared::kind_count;

struct RayKind {
  std::string_view name;      ///< --rays, --key KIND=, statistics
  std::string_view creation;  ///< shader below shaders/
  std::string_view best_key;  ///< file below shaders/rays/keys/
  bool at_last_bounce;        ///< cast also from the last bounce's surfaces (k <= B), not only before it (k < B)
};

/// By shared::kind_shadow, kind_reflection, kind_refraction.
inline constexpr std::array<RayKind, kind_count> ray_kinds = {{
    {"shadow", "rays/shadow", "hilbert", true},
    {"reflection", "rays/reflection", "interleaved", false},
    {"refraction", "rays/refraction", "interleaved", false},
}};

}  // namespace crsh
