#include "scene/gltf/animations.h"

#include <algorithm>
#include <cmath>

#include "scene/gltf/accessor.h"

namespace crsh::scene {
namespace {

Interpolation interpolation_of(const Fields& sampler) {
  const std::string& name = sampler.text("interpolation");
  if (name.empty() || name == "LINEAR") return Interpolation::linear;
  if (name == "STEP") return Interpolation::step;
  if (name == "CUBICSPLINE") return Interpolation::cubic_spline;
  throw Fault(sampler.name_of("interpolation") + " " + in_quotes(name, 20) + " is none of glTF's");
}

std::optional<Path> path_of(const std::string& name) {
  if (name == "translation") return Path::translation;
  if (name == "rotation") return Path::rotation;
  if (name == "scale") return Path::scale;
  return {};
}

std::vector<float> read_times(Document& document, uint64_t index) {
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

std::vector<glm::vec4> read_values(Document& document, uint64_t index, uint32_t components, uint64_t needed) {
  const Accessor accessor(document, index);
  accessor.need_components({components});
  if (accessor.count() != needed) throw Fault(accessor.where() + " has not as many values as its animation has keys");
  document.spend(needed);
  std::vector<glm::vec4> out(needed);
  for (size_t i = 0; i < out.size(); ++i) {
    out[i] = accessor.at(i);
    if (!std::isfinite(out[i].x + out[i].y + out[i].z + out[i].w))
      throw Fault(accessor.where() + " has a value that is not finite");
  }
  return out;
}

/// The channel that `fields` describes, if crsh animates what it aims at.
std::optional<Channel> read_channel(Document& document, const Fields& animation, const Fields& fields,
                                    const NodeMap& nodes, const Scene& scene, Notes& notes) {
  const std::optional<Fields> target = fields.object("target");
  if (!target) throw Fault(fields.name_of("target") + " is missing");
  const std::optional<Path> path = path_of(target->text("path"));
  if (!path) {
    const std::string& what = target->text("path");
    notes.add("animation of " + (what == "weights" ? std::string("morph targets") : in_quotes(what, 40)));
    return {};
  }
  const std::optional<uint64_t> file_node = target->whole("node");
  if (!file_node) return {};
  if (*file_node >= nodes.node_of.size()) throw Fault(target->name_of("node") + " is not in the file");
  const std::optional<uint32_t> node = nodes.node_of[*file_node];
  if (!node || scene.nodes[*node].matrix) return {};  // out of sight, or fixed by its matrix
  const Fields sampler = animation.element("samplers", fields.needed_whole("sampler"));
  Channel out{*node, *path, interpolation_of(sampler), read_times(document, sampler.needed_whole("input")), {}};
  const uint64_t values_a_key = out.interpolation == Interpolation::cubic_spline ? 3 : 1;
  out.values = read_values(document, sampler.needed_whole("output"), *path == Path::rotation ? 4 : 3,
                           out.times.size() * values_a_key);
  return out;
}

}  // namespace

void read_animations(Document& document, const NodeMap& nodes, Scene& scene, Notes& notes) {
  const Fields root = document.root();
  for (size_t a = 0; a < root.size("animations"); ++a) {
    const Fields fields = root.element("animations", a);
    Animation out;
    out.name = fields.text("name");
    for (size_t c = 0; c < fields.size("channels"); ++c) {
      auto channel = read_channel(document, fields, fields.element("channels", c), nodes, scene, notes);
      if (!channel) continue;
      out.duration = std::max(out.duration, channel->times.back());
      out.channels.push_back(std::move(*channel));
    }
    scene.animations.push_back(std::move(out));
  }
}

}  // namespace crsh::scene
