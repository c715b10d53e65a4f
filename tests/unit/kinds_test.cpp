// The table of ray kinds: what C++ and shaders read from it, and arrays by kind.

#include <doctest/doctest.h>

#include <set>
#include <string>

#include "crsh/kinds.h"
#include "crsh/options.h"
#include "gpu/program.h"

using namespace crsh;

namespace {

template <class T, size_t... Index>
consteval bool made_of(std::index_sequence<Index...>) {
  return std::is_constructible_v<PerKind<T>, decltype(Index, T())...>;
}
template <class T, size_t count>
constexpr bool made_of_values = made_of<T>(std::make_index_sequence<count>());

static_assert(made_of_values<int, 1>, "one for all");
static_assert(made_of_values<int, kind_count>);
static_assert(!made_of_values<int, kind_count - 1>, "a kind without a value");
static_assert(!made_of_values<int, kind_count + 1>);
static_assert(!std::is_default_constructible_v<PerKind<int>>, "numbers have to be said");
static_assert(!std::is_convertible_v<int, PerKind<int>>);
static_assert(std::is_default_constructible_v<PerKind<std::string>>);

/// A kind for trying out properties.
constexpr RayKind occlusion = {.any_hit = true, .at_first_bounce = true, .adds_light = false};

}  // namespace

TEST_CASE("an array by kind is made of one value, or of a function of the kind") {
  for (const uint32_t value : PerKind<uint32_t>(7)) CHECK(value == 7);
  const PerKind<uint32_t> squares([](uint32_t kind) { return kind * kind; });
  for (uint32_t kind = 0; kind < kind_count; ++kind) CHECK(squares[kind] == kind * kind);
  CHECK(squares != PerKind<uint32_t>(7));
}

TEST_CASE("every ray kind has a name of its own and a creation shader") {
  std::set<std::string_view> names;
  for (uint32_t kind = 0; kind < kind_count; ++kind) {
    const RayKind& row = ray_kinds[kind];
    CAPTURE(row.name);
    CHECK(names.insert(row.name).second);
    CHECK(kind_named(row.name) == kind);
    CHECK_FALSE(gpu::embedded_spirv(std::string(row.creation) + ".comp").empty());
  }
  CHECK_FALSE(kind_named("glossy"));
}

TEST_CASE("shaders read the same properties as C++") {
  uint32_t closest = 0;
  for (uint32_t kind = 0; kind < kind_count; ++kind) {
    CAPTURE(ray_kinds[kind].name);
    CHECK(ray_kinds[kind].any_hit == (shared::any_hit_kinds >> kind & 1));
    if (!ray_kinds[kind].any_hit) CHECK(ray_kinds[kind].turn == closest++);
    CHECK(ray_kinds[kind].turn < 1u << shared::path_bits);
  }
  CHECK(closest == shared::closest_kind_count);
}

TEST_CASE("paths are written as in every ray file so far: a bit a bounce, 1 where refracted") {
  if (shared::closest_kind_count == 2) CHECK(shared::path_bits == 1);
  CHECK(ray_kinds[shared::kind_reflection].turn == 0);
  CHECK(ray_kinds[shared::kind_refraction].turn == 1);
}

TEST_CASE("kinds are cast at the bounces that their properties say") {
  const RayKind& shadow = ray_kinds[shared::kind_shadow];
  const RayKind& reflection = ray_kinds[shared::kind_reflection];
  CHECK(shadow.cast_at(0, 0));
  CHECK(shadow.cast_at(2, 2));
  CHECK_FALSE(reflection.cast_at(0, 0));
  CHECK(reflection.cast_at(1, 2));
  CHECK(occlusion.cast_at(0, 2));
  CHECK_FALSE(occlusion.cast_at(1, 2));
}

TEST_CASE("properties that contradict each other are no row") {
  CHECK(is_sound(occlusion));
  CHECK_FALSE(is_sound({.any_hit = true}));                        // whose light?
  CHECK_FALSE(is_sound({.one_a_light = true}));                    // its hits are no light's
  CHECK_FALSE(is_sound({.at_last_bounce = true}));                 // there is no next generation
  CHECK_FALSE(is_sound({.any_hit = false, .adds_light = false}));  // its hits are gathered
}

TEST_CASE("presets and the default rays go by properties") {
  const AlgorithmOptions ours = preset("crsh"), objects = preset("crsh-bvh");
  for (uint32_t kind = 0; kind < kind_count; ++kind) {
    const bool shared_origin = ray_kinds[kind].shares_origin;
    CHECK(ours.levels[kind] == (shared_origin ? 5 : 4));
    CHECK(ours.keys[kind] == (shared_origin ? "hilbert" : "interleaved"));
    CHECK(objects.keys[kind] == (shared_origin ? "hilbert" : "origin-direction"));
    CHECK(RenderOptions().rays[kind] == ray_kinds[kind].adds_light);
  }
}
