#include "scene/gltf/animations.h"

#include <algorithm>
#include <cmath>

#include "scene/gltf/accessor.h"
#include "scene/gltf/checked.h"
#include "scene/gltf/extension.h"
#include "scene/gltf/pointer.h"
#include "scene/properties.h"

namespace crsh::scene {
namespace {

Interpolation interpolation_of(const std::string& name, const std::string& where) {
  if (name.empty() || name == "LINEAR") return Interpolation::linear;
  if (name == "STEP") return Interpolation::step;
  if (name == "CUBICSPLINE") return Interpolation::cubic_spline;
  throw Fault(where + ".interpolation " + in_quotes(name, 20) + " is none of glTF's");
}

std::vector<float> read_times(Document& document, int64_t index) {
  const Accessor accessor(document, index);
  accessor.need_components({1});
  if (accessor.count() == 0) throw Fault(accessor.where() + " has no keys");
  document.spend(accessor.count());
  std::vector<float> out(accessor.count());
  for (size_t i = 0; i < out.size(); ++i) {
    out[i] = accessor.at(i).x;
    if (!std::isfinite(out[i]) || (i > 0 && out[i] < out[i - 1]))
      throw Fault(accessor.where() + " has times that fall or are not finite");
  }
  return out;
}

/// How many numbers a value has: as the property says, else as many as there are for each of `values`.
uint32_t width_of(const Accessor& accessor, uint32_t width, uint64_t values) {
  if (width > 0) return width;
  const uint64_t each = accessor.count() / values;
  return static_cast<uint32_t>(std::clamp<uint64_t>(each, 1, 0xFFFF));
}

/// Fills the channel's values and their width; `width` 0: as many as there are.
void read_values(Document& document, int64_t index, uint32_t width, Channel& out) {
  const Accessor accessor(document, index);
  const uint32_t components = width > 0 ? width : 1;
  accessor.need_components({components});
  const uint64_t values = out.times.size() * (out.interpolation == Interpolation::cubic_spline ? 3 : 1);
  out.width = width_of(accessor, width, values);
  if (accessor.count() * components != values * out.width)
    throw Fault(accessor.where() + " has not as many values as its animation has keys");
  document.spend(values * out.width);
  out.values.reserve(values * out.width);
  for (uint64_t i = 0; i < accessor.count(); ++i) {
    const glm::vec4 value = accessor.at(i);
    if (!std::isfinite(value.x + value.y + value.z + value.w))
      throw Fault(accessor.where() + " has a value that is not finite");
    for (uint32_t c = 0; c < components; ++c) out.values.push_back(value[static_cast<int>(c)]);
  }
}

/// Reads the channels of animations.
class ChannelReader {
 public:
  ChannelReader(Document& document, const Places& places, const Scene& scene, Notes& notes)
      : document_(document), places_(places), scene_(scene), notes_(notes) {}

  /// Appends the channel, once for each element that it drives, if crsh animates what it aims at. `where`: of its
  /// animation.
  void read(const tinygltf::Animation& animation, size_t index, const std::string& where, Animation& out) {
    const tinygltf::AnimationChannel& from = animation.channels[index];
    const std::optional<Aim> aim = aim_of(from, place(where + ".channels", static_cast<int64_t>(index)));
    if (!aim) return;
    for (const Target& target : aim->targets) {
      out.channels.push_back(keys(at(animation.samplers, from.sampler, where + ".samplers"),
                                  place(where + ".samplers", from.sampler), target, aim->width));
      out.duration = std::max(out.duration, out.channels.back().times.back());
    }
  }

 private:
  std::optional<Aim> aim_of(const tinygltf::AnimationChannel& from, const std::string& where) {
    const auto extension = Extension::of(from.target_extensions, "KHR_animation_pointer", where + ".target");
    const bool points = extension && from.target_path == "pointer";
    const std::string what = points ? extension->text("pointer") : from.target_path;
    if (!points && from.target_node >= static_cast<int64_t>(places_.nodes.node_of.size()))
      throw Fault(where + ".target.node is not in the file");
    const std::optional<Aim> aim =
        points ? aim_of_pointer(places_, scene_, what) : aim_of_path(places_, scene_, from.target_node, what);
    if (!aim) notes_.add("animation of " + in_quotes(what, 80));
    return aim;
  }

  Channel keys(const tinygltf::AnimationSampler& from, const std::string& where, const Target& target, uint32_t width) {
    Channel out;
    out.target = target;
    out.interpolation = interpolation_of(from.interpolation, where);
    out.times = read_times(document_, from.input);
    read_values(document_, from.output, width, out);
    return out;
  }

  Document& document_;
  const Places& places_;
  const Scene& scene_;
  Notes& notes_;
};

/// Notes which materials may let light through at some time though they do not now.
void mark_transmissive(const Animation& animation, std::vector<Material>& materials) {
  for (const Channel& channel : animation.channels) {
    if (channel.target.driven != Driven::material) continue;
    Material& material = materials[channel.target.object];
    const uint32_t property = channel.target.property;
    material.may_transmit |=
        property == material_transmission || (property == material_metallic && material.transmission > 0);
  }
}

}  // namespace

void read_animations(Document& document, const Places& places, Scene& scene, Notes& notes) {
  ChannelReader reader(document, places, scene, notes);
  const std::vector<tinygltf::Animation>& animations = document.model().animations;
  for (size_t a = 0; a < animations.size(); ++a) {
    Animation out;
    out.name = animations[a].name;
    for (size_t c = 0; c < animations[a].channels.size(); ++c)
      reader.read(animations[a], c, place("animations", static_cast<int64_t>(a)), out);
    mark_transmissive(out, scene.materials);
    scene.animations.push_back(std::move(out));
  }
}

}  // namespace crsh::scene
