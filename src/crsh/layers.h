#pragma once
// The table of layers that a picture can have, which the command line, the film and the files all iterate.

#include <algorithm>
#include <array>
#include <bitset>
#include <cstddef>
#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

namespace crsh {

/// Rows of layer_table.
enum class LayerId {
  beauty,
  direct,
  emission,
  reflection,
  refraction,
  background,
  albedo,
  f0,
  shadow,
  position,
  normal,
  depth,
  object,
  material,
  triangle_tests,
  node_tests,
  object_tests
};
inline constexpr size_t layer_count = 17;

struct LayerRow {
  std::string_view name;      ///< --layers; "beauty"'s channels have no prefix
  std::string_view channels;  ///< their last parts, with commas between; empty: the name is the only channel's
  std::string_view help;
};

/// By LayerId.
inline constexpr std::array<LayerRow, layer_count> layer_table = {{
    {"beauty", "R,G,B,A", "light, premultiplied; A is coverage"},
    {"Direct", "R,G,B", "light from lamps, straight"},
    {"Emission", "R,G,B", "light of the surface's own"},
    {"Reflection", "R,G,B", "light that reflection rays brought"},
    {"Refraction", "R,G,B", "light that refraction rays brought"},
    {"Background", "R,G,B", "light from where nothing is"},
    {"Albedo", "R,G,B", "base colour"},
    {"F0", "R,G,B", "reflectance seen straight on"},
    {"Shadow", "Y", "mean visibility of the lights, 0 to 1"},
    {"P", "X,Y,Z", "position, metres"},
    {"N", "X,Y,Z", "shading normal"},
    {"Z", "", "distance along the view axis, 1e10 where nothing is"},
    {"Object", "id", "number of the instance, 0 where nothing is"},
    {"Material", "id", "number of the material, 0 where nothing is"},
    {"Tests.triangle", "", "tests of rays against triangles"},
    {"Tests.node", "", "tests of ray nodes against triangles"},
    {"Tests.object", "", "tests against objects"},
}};

[[nodiscard]] constexpr const LayerRow& row_of(LayerId id) { return layer_table[static_cast<size_t>(id)]; }

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
  [[nodiscard]] bool has(LayerId id) const { return bits_.test(static_cast<size_t>(id)); }
  [[nodiscard]] bool has_any(std::initializer_list<LayerId> ids) const { return (bits_ & LayerSet(ids).bits_).any(); }
  [[nodiscard]] static LayerSet all() {
    LayerSet set;
    set.bits_.set();
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
  for (size_t id = 0; id < layer_count; ++id)
    if (layers.has(static_cast<LayerId>(id))) names.push_back(picture_layer(static_cast<LayerId>(id)));
  return names;
}

}  // namespace crsh
