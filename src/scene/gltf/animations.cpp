#include "scene/gltf/animations.h"

#include <algorithm>
#include <cmath>

#include "scene/gltf/accessor.h"
#include "scene/gltf/checked.h"

namespace crsh::scene {
namespace {

Interpolation interpolation_of(const std::string& name, const std::string& where) {
  if (name.empty() || name == "LINEAR") return Interpolation::linear;
  if (name == "STEP") return Interpolation::step;
  if (name == "CUBICSPLINE") return Interpolation::cubic_spline;
  throw Fault(where + ".interpolation " + in_quotes(name, 20) + " is none of glTF's");
}

std::optional<Path> path_of(const std::string& name) {
  if (name == "translation") return Path::translation;
  if (name == "rotation") return Path::rotation;
  if (name == "scale") return Path::scale;
  return {};
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

std::vector<glm::vec4> read_values(Document& document, int64_t index, uint32_t components, uint64_t needed) {
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

std::string left_out(const std::string& path) {
  return "animation of " + (path == "weights" ? std::string("morph targets") : in_quotes(path, 40));
}

/// Reads the channels of one animation.
class ChannelReader {
 public:
  ChannelReader(Document& document, const NodeMap& nodes, const Scene& scene, Notes& notes)
      : document_(document), nodes_(nodes), scene_(scene), notes_(notes) {}

  /// The channel, if crsh animates what it aims at. `where`: of its animation.
  std::optional<Channel> read(const tinygltf::Animation& animation, size_t index, const std::string& where) {
    const tinygltf::AnimationChannel& from = animation.channels[index];
    const std::optional<Path> path = path_of(from.target_path);
    if (!path) return notes_.add(left_out(from.target_path)), std::nullopt;
    const std::optional<uint32_t> node = node_of(from, place(where + ".channels", static_cast<int64_t>(index)));
    if (!node) return {};
    return keys(at(animation.samplers, from.sampler, where + ".samplers"), place(where + ".samplers", from.sampler),
                *node, *path);
  }

 private:
  /// The scene's node that the channel moves; none where it is out of sight, or fixed by its matrix.
  std::optional<uint32_t> node_of(const tinygltf::AnimationChannel& from, const std::string& where) const {
    if (from.target_node < 0) return {};
    const auto file_node = static_cast<size_t>(from.target_node);
    if (file_node >= nodes_.node_of.size()) throw Fault(where + ".target.node is not in the file");
    const std::optional<uint32_t> node = nodes_.node_of[file_node];
    return node && scene_.nodes[*node].matrix ? std::nullopt : node;
  }

  Channel keys(const tinygltf::AnimationSampler& from, const std::string& where, uint32_t node, Path path) {
    Channel out{node, path, interpolation_of(from.interpolation, where), read_times(document_, from.input), {}};
    const uint64_t values_a_key = out.interpolation == Interpolation::cubic_spline ? 3 : 1;
    out.values = read_values(document_, from.output, path == Path::rotation ? 4 : 3, out.times.size() * values_a_key);
    return out;
  }

  Document& document_;
  const NodeMap& nodes_;
  const Scene& scene_;
  Notes& notes_;
};

}  // namespace

void read_animations(Document& document, const NodeMap& nodes, Scene& scene, Notes& notes) {
  ChannelReader reader(document, nodes, scene, notes);
  const std::vector<tinygltf::Animation>& animations = document.model().animations;
  for (size_t a = 0; a < animations.size(); ++a) {
    Animation out;
    out.name = animations[a].name;
    for (size_t c = 0; c < animations[a].channels.size(); ++c) {
      auto channel = reader.read(animations[a], c, place("animations", static_cast<int64_t>(a)));
      if (!channel) continue;
      out.duration = std::max(out.duration, channel->times.back());
      out.channels.push_back(std::move(*channel));
    }
    scene.animations.push_back(std::move(out));
  }
}

}  // namespace crsh::scene
