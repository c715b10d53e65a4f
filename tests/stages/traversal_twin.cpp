#include "traversal_twin.h"

namespace crsh::test {
namespace {

class Descent {
 public:
  explicit Descent(const WalkIn& in) : in_(in) {}

  Walk run(uint32_t depth, hierarchy::Range nodes) {
    walk_.levels.resize(depth);
    for (uint32_t node = nodes.first; node < nodes.end(); ++node)
      go_down(depth - 1, node, triangles_of_met_objects(depth - 1, node));
    return std::move(walk_);
  }

 private:
  [[nodiscard]] bool may_hit(uint32_t level, uint32_t node, const glm::vec4& sphere) const {
    return may_hit_sphere(in_.nodes[level][node], in_.intervals[level][node], sphere, in_.interval,
                          in_.cone_as_printed);
  }

  std::vector<uint32_t> triangles_of_met_objects(uint32_t level, uint32_t node) {
    std::vector<bool> met(in_.object_spheres.size(), true);
    for (size_t i = 0; in_.mesh_culling && i < met.size(); ++i) {
      met[i] = may_hit(level, node, in_.object_spheres[i]);
      ++walk_.mesh_tests;
    }
    std::vector<uint32_t> triangles;
    for (const glm::uvec4& block : in_.blocks)
      for (uint32_t t = 0; met[block.x] && t < block.z; ++t) triangles.push_back(block.y + t);
    return triangles;
  }

  void go_down(uint32_t level, uint32_t node, const std::vector<uint32_t>& candidates) {
    std::vector<uint32_t> left;
    for (const uint32_t triangle : candidates)
      if (may_hit(level, node, in_.triangle_spheres[triangle])) left.push_back(triangle);
    walk_.levels[level].tests += candidates.size();
    walk_.levels[level].hits += left.size();
    const glm::uvec2 children = in_.children[level][node];
    for (uint32_t child = children.x; level > 0 && child < children.y; ++child) go_down(level - 1, child, left);
    for (size_t i = 0; level == 0 && i < left.size(); ++i) walk_.pairs.push_back({node, left[i]});
  }

  const WalkIn& in_;
  Walk walk_;
};

}  // namespace

WalkIn read_for_walk(gpu::Recorder& recorder, const hierarchy::Hierarchy& hierarchy, const scene::GpuScene& scene,
                     const AlgorithmOptions& options) {
  WalkIn in;
  for (uint32_t l = 0; l < hierarchy.depth; ++l) {
    const hierarchy::Level& level = hierarchy.levels[l];
    in.nodes.push_back(recorder.read<shared::Node>(level.nodes, level.count));
    in.intervals.push_back(recorder.read<shared::Interval>(level.intervals, level.count));
    in.children.push_back(recorder.read<glm::uvec2>(level.children, level.count));
  }
  in.object_spheres = recorder.read<glm::vec4>(scene.object_spheres, scene.instance_count);
  in.triangle_spheres = recorder.read<glm::vec4>(scene.triangle_spheres, scene.triangle_count);
  in.blocks = recorder.read<glm::uvec4>(scene.blocks, scene.block_count);
  in.interval = options.interval;
  in.mesh_culling = options.mesh_culling;
  in.cone_as_printed = options.cone_test == ConeTest::as_printed;
  return in;
}

Walk walk(const WalkIn& in, uint32_t depth, hierarchy::Range nodes) { return Descent(in).run(depth, nodes); }

}  // namespace crsh::test
