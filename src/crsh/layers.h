#pragma once
// The table of layers that a picture can have: the command line, the film, the files and the viewer all iterate it.

#include <algorithm>
#include <array>
#include <bitset>
#include <cstddef>
#include <cstdint>
#include <initializer_list>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "shared/account.h"
#include "shared/kinds.h"

namespace crsh {

/// A vec4 that each surface the eye sees has on the device (surfaces/surfaces.h, shading/gather.h).
enum class SurfaceValue {
  position,   ///< xyz: metres
  normal,     ///< xyz: shading normal; w: transmission
  geometric,  ///< xyz: geometric normal; w: roughness
  incoming,   ///< xyz: direction of the ray that came; w: ratio of the indices of refraction
  diffuse,    ///< rgb
  specular,   ///< rgb: F0
  emission,   ///< rgb: cd/m²
  direct,     ///< rgb: what shadow rays let through, cd/m²
  total,      ///< rgb: all light, cd/m²; w: 1 where something was met
  brought     ///< rgb: the part of it that closest-hit rays of one kind brought
};

/// How a layer's pixels come about on the film (shading/film.cpp).
enum class LayerFill {
  mean,         ///< of a surface's value, over the samples
  first,        ///< a surface's value, of the first sample, which lies at the pixel's centre
  base_colour,  ///< mean of diffuse and the coloured part of specular
  visibility,   ///< mean of what the rays of one kind let through
  background,   ///< the background, as often as a sample met nothing
  depth,        ///< of the first sample, along the view axis
  object,       ///< number of the first sample's instance
  material,     ///< number of the first sample's material
  tests         ///< sum of one type of tests
};

/// What fills a layer. Made by the functions below.
struct LayerSource {
  LayerFill fill = LayerFill::mean;
  SurfaceValue value = SurfaceValue::total;  ///< of mean and first
  /// mean and first: the component of the vec4 that the first channel takes; tests: shared::tests_*
  uint32_t which = 0;
  uint32_t kind = 0;  ///< visibility and what was brought: of the rays (shared::kind_*)
};
[[nodiscard]] constexpr LayerSource mean_of(SurfaceValue value, uint32_t first_component = 0) {
  return {LayerFill::mean, value, first_component};
}
[[nodiscard]] constexpr LayerSource first_of(SurfaceValue value, uint32_t first_component = 0) {
  return {LayerFill::first, value, first_component};
}
[[nodiscard]] constexpr LayerSource visibility_of(uint32_t ray_kind) {
  return {LayerFill::visibility, SurfaceValue::total, 0, ray_kind};
}
[[nodiscard]] constexpr LayerSource brought_by(uint32_t ray_kind) {
  return {LayerFill::mean, SurfaceValue::brought, 0, ray_kind};
}
[[nodiscard]] constexpr LayerSource tests_of(uint32_t which) { return {LayerFill::tests, SurfaceValue::total, which}; }

/// How the viewer paints a layer (viewer/show.cpp).
enum class Paint {
  nothing,   ///< it is not among the things to show
  colour,    ///< three channels, linear
  grey,      ///< one channel, 0 is black and 1 is white
  heat,      ///< one channel on the heat scale
  extent,    ///< three channels, each from its least to its greatest value
  vector,    ///< three channels from -1 to 1
  distance,  ///< one channel, near is bright
  numbers    ///< a colour a number
};

/// The layer among the viewer's things to show.
struct LayerShow {
  Paint paint = Paint::nothing;
  std::string_view name = {}, help = {};
};

struct LayerRow {
  std::string_view name;      ///< --layers; "beauty"'s channels have no prefix
  std::string_view channels;  ///< their last parts, with commas between; empty: the name is the only channel's
  std::string_view help;
  LayerSource source;
  LayerShow show = {};
};

/// In the order of a file's layers.
inline constexpr auto layer_table = std::to_array<LayerRow>({
    {"beauty", "R,G,B,A", "light, premultiplied; A is coverage", mean_of(SurfaceValue::total)},
    {"Direct", "R,G,B", "light from lamps, straight", mean_of(SurfaceValue::direct)},
    {"Emission", "R,G,B", "light of the surface's own", mean_of(SurfaceValue::emission)},
    {"Reflection", "R,G,B", "light that reflection rays brought", brought_by(shared::kind_reflection)},
    {"Refraction", "R,G,B", "light that refraction rays brought", brought_by(shared::kind_refraction)},
    {"Background", "R,G,B", "light from where nothing is", {LayerFill::background}},
    {"Albedo", "R,G,B", "base colour", {LayerFill::base_colour}, {Paint::colour, "albedo", "Base colour"}},
    {"F0", "R,G,B", "reflectance seen straight on", mean_of(SurfaceValue::specular)},
    {"Shadow", "Y", "mean visibility of the lights, 0 to 1", visibility_of(shared::kind_shadow)},
    {"P",
     "X,Y,Z",
     "position, metres",
     first_of(SurfaceValue::position),
     {Paint::extent, "position", "Each axis from its least to its greatest value as red, green, blue"}},
    {"N",
     "X,Y,Z",
     "shading normal",
     first_of(SurfaceValue::normal),
     {Paint::vector, "normal", "Shading normals: x, y, z as red, green, blue"}},
    {"Z",
     "",
     "distance along the view axis, 1e10 where nothing is",
     {LayerFill::depth},
     {Paint::distance, "depth", "Near is bright"}},
    {"Object",
     "id",
     "number of the instance, 0 where nothing is",
     {LayerFill::object},
     {Paint::numbers, "objects", "A colour an object"}},
    {"Material",
     "id",
     "number of the material, 0 where nothing is",
     {LayerFill::material},
     {Paint::numbers, "materials", "A colour a material"}},
    {"Tests.triangle",
     "",
     "tests of rays against triangles",
     tests_of(shared::tests_triangle),
     {Paint::heat, "triangle tests", "Rays against triangles"}},
    {"Tests.node",
     "",
     "tests of ray nodes against triangles",
     tests_of(shared::tests_node),
     {Paint::heat, "node tests", "Ray nodes against triangles, shared among their rays"}},
    {"Tests.object",
     "",
     "tests against objects",
     tests_of(shared::tests_object),
     {Paint::heat, "object tests", "Nodes or rays against meshes and boxes"}},
});
inline constexpr size_t layer_count = layer_table.size();

/// A row of layer_table. Those that code speaks of have a name here.
class LayerId {
 public:
  constexpr explicit LayerId(size_t row) : row_(row) {}
  constexpr explicit operator size_t() const { return row_; }
  bool operator==(const LayerId&) const = default;
  static const LayerId beauty, reflection, refraction, albedo, shadow, normal, depth;

 private:
  size_t row_;
};

[[nodiscard]] constexpr const LayerRow& row_of(LayerId id) { return layer_table[static_cast<size_t>(id)]; }

/// The layer of this name. Throws (in a constant: does not compile) where there is none.
[[nodiscard]] constexpr LayerId layer_named(std::string_view name) {
  for (size_t row = 0; row < layer_count; ++row)
    if (layer_table[row].name == name) return LayerId(row);
  throw std::logic_error("no such layer");
}
inline constexpr LayerId LayerId::beauty = layer_named("beauty");
inline constexpr LayerId LayerId::reflection = layer_named("Reflection");
inline constexpr LayerId LayerId::refraction = layer_named("Refraction");
inline constexpr LayerId LayerId::albedo = layer_named("Albedo");
inline constexpr LayerId LayerId::shadow = layer_named("Shadow");
inline constexpr LayerId LayerId::normal = layer_named("N");
inline constexpr LayerId LayerId::depth = layer_named("Z");

/// Whether its pixels are whole numbers.
[[nodiscard]] constexpr bool is_numbers(LayerId id) {
  return row_of(id).source.fill == LayerFill::object || row_of(id).source.fill == LayerFill::material;
}

/// Names of its channels, as in an EXR: "R", "Direct.R", "Z".
[[nodiscard]] inline std::vector<std::string> channels_of(LayerId id) {
  const LayerRow& row = row_of(id);
  const std::string prefix = id == LayerId::beauty ? "" : std::string(row.name) + ".";
  std::vector<std::string> names;
  for (std::string_view left = row.channels; !left.empty();) {
    const std::string_view last = left.substr(0, left.find(','));
    names.push_back(prefix + std::string(last));
    left.remove_prefix(std::min(last.size() + 1, left.size()));
  }
  return names.empty() ? std::vector{std::string(row.name)} : names;
}

/// A layer's name in a Picture: the beauty's is empty.
[[nodiscard]] inline std::string picture_layer(LayerId id) {
  return id == LayerId::beauty ? std::string() : std::string(row_of(id).name);
}

/// Which layers are wanted.
class LayerSet {
 public:
  LayerSet() = default;
  LayerSet(std::initializer_list<LayerId> ids) {
    for (const LayerId id : ids) add(id);
  }
  void add(LayerId id) { bits_.set(static_cast<size_t>(id)); }
  void add(const LayerSet& others) { bits_ |= others.bits_; }
  [[nodiscard]] bool has(LayerId id) const { return bits_.test(static_cast<size_t>(id)); }
  [[nodiscard]] bool has_any(std::initializer_list<LayerId> ids) const { return (bits_ & LayerSet(ids).bits_).any(); }
  /// In the order of the table.
  [[nodiscard]] std::vector<LayerId> members() const {
    std::vector<LayerId> ids;
    for (size_t row = 0; row < layer_count; ++row)
      if (bits_.test(row)) ids.emplace_back(row);
    return ids;
  }
  [[nodiscard]] static LayerSet all() {
    LayerSet set;
    set.bits_.set();
    return set;
  }
  /// All that come about in this way.
  [[nodiscard]] static LayerSet filled_by(LayerFill fill) {
    LayerSet set;
    for (size_t row = 0; row < layer_count; ++row)
      if (layer_table[row].source.fill == fill) set.add(LayerId(row));
    return set;
  }
  bool operator==(const LayerSet&) const = default;

 private:
  std::bitset<layer_count> bits_;
};

/// What an EXR holds unless --layers says otherwise.
inline const LayerSet default_layers = {LayerId::beauty, LayerId::albedo, LayerId::normal, LayerId::depth};

/// Names in a Picture of all layers of the set.
[[nodiscard]] inline std::vector<std::string> picture_layers(const LayerSet& layers) {
  std::vector<std::string> names;
  for (const LayerId id : layers.members()) names.push_back(picture_layer(id));
  return names;
}

}  // namespace crsh
