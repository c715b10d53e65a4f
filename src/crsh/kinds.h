#pragma once
// The table of ray kinds as C++ sees it: shaders/shared/kinds.h has the rows.

#include <algorithm>
#include <optional>
#include <string_view>

#include "crsh/per_kind.h"

namespace crsh {

struct RayKind {
  std::string_view name;      ///< --rays, --key KIND=, statistics, ray files
  std::string_view creation;  ///< shader below shaders/
  bool any_hit = false;  ///< blocked and tinted by any hit; else its closest hits are the next generation's surfaces
  bool one_a_light = false;         ///< one a surface and light; else one a surface
  bool shares_origin = false;       ///< those of one light begin at one place: direction alone sorts them
  bool at_last_bounce = false;      ///< cast also from the last bounce's surfaces (k <= B), not only before (k < B)
  bool at_first_bounce = false;     ///< cast only from what the camera sees (k = 0)
  bool adds_light = true;           ///< to the picture; else it shows in a layer of its own only
  bool mirrors_everything = false;  ///< where --override-mirror is given
  bool goes_through = false;        ///< shows what lies behind a surface that is not wholly there
  uint32_t turn = 0;                ///< of closest-hit kinds: shared::path_bits bits of a path
  std::string_view best_key;        ///< file below shaders/rays/keys/

  /// Whether the surfaces of bounce `k` cast it, where there are `bounces` generations of closest-hit rays.
  [[nodiscard]] constexpr bool cast_at(uint32_t k, uint32_t bounces) const {
    return (k < bounces || at_last_bounce) && (k == 0 || !at_first_bounce);
  }
};

/// By shared::kind_*.
inline constexpr PerKind<RayKind> ray_kinds = [] {
  using namespace shared;
  uint32_t closest = 0;
  const auto row = [&](std::string_view name, std::string_view creation, uint32_t properties) {
    const auto has = [&](uint32_t property) { return (properties & property) != 0; };
    return RayKind{.name = name,
                   .creation = creation,
                   .any_hit = has(ray_any_hit),
                   .one_a_light = has(ray_a_light),
                   .shares_origin = has(ray_shared_origin),
                   .at_last_bounce = has(ray_at_last_bounce),
                   .at_first_bounce = has(ray_at_first_bounce),
                   .adds_light = !has(ray_adds_no_light),
                   .mirrors_everything = has(ray_override),
                   .goes_through = has(ray_goes_through),
                   .turn = has(ray_any_hit) ? 0 : closest++,
                   .best_key = has(ray_shared_origin) ? "hilbert" : "interleaved"};
  };
#define CRSH_RAY_KIND(name, number, properties) row(#name, "rays/" #name, properties),
  return PerKind<RayKind>{CRSH_RAY_KINDS(CRSH_RAY_KIND)};
#undef CRSH_RAY_KIND
}();

/// The number of the kind of this name.
[[nodiscard]] constexpr std::optional<uint32_t> kind_named(std::string_view name) {
  for (uint32_t kind = 0; kind < kind_count; ++kind)
    if (ray_kinds[kind].name == name) return kind;
  return {};
}

/// What rows cannot be: code that goes by the properties rests on it.
[[nodiscard]] constexpr bool is_sound(const RayKind& kind) {
  if (kind.any_hit) return kind.one_a_light || !kind.adds_light;  // direct light is a light's
  return !kind.one_a_light && !kind.at_last_bounce && kind.adds_light;
}
static_assert(std::ranges::all_of(ray_kinds, is_sound), "a ray kind's properties do not go together");
#define CRSH_IN_ORDER(name, number, properties) \
  static_assert(kind_named(#name) == number, "rows of ray kinds stand in the order of their numbers");
CRSH_RAY_KINDS(CRSH_IN_ORDER)
#undef CRSH_IN_ORDER
static_assert(kind_count <= 32 && shared::closest_kind_count <= 8, "more ray kinds than numbers for them");

}  // namespace crsh
