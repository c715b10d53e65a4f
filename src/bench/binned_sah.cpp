#include "bench/binned_sah.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <numeric>
#include <span>

#include "scene/deform.h"
#include "scene/playing.h"
#include "shared/object.h"

namespace crsh::bench {
namespace {

/// A top-down build of which only the cost is kept.
class BinnedBuild {
 public:
  explicit BinnedBuild(std::vector<SahBox> boxes) : boxes_(std::move(boxes)) {}

  double run() {
    std::vector<uint32_t> all(boxes_.size());
    std::iota(all.begin(), all.end(), 0u);
    const SahBox root = box_of(all);
    return all.size() < 2 ? 0 : build(all, root, true) / root.half_area();
  }

 private:
  static constexpr int bins = 32;
  struct Bin {
    SahBox box;
    uint32_t count = 0;
  };
  struct Split {
    int axis = -1, bin = 0;  ///< the first bin on the right
    double cost = std::numeric_limits<double>::infinity();
  };

  [[nodiscard]] glm::vec3 middle(uint32_t i) const { return 0.5f * (boxes_[i].low + boxes_[i].high); }

  [[nodiscard]] SahBox box_of(std::span<const uint32_t> ids) const {
    SahBox box;
    for (const uint32_t i : ids) box.include(boxes_[i]);
    return box;
  }

  [[nodiscard]] SahBox middles_of(std::span<const uint32_t> ids) const {
    SahBox box;
    for (const uint32_t i : ids) box.include({middle(i), middle(i)});
    return box;
  }

  [[nodiscard]] int bin_of(uint32_t i, const SahBox& middles, int axis) const {
    const float extent = middles.high[axis] - middles.low[axis];
    return std::min(bins - 1, int((middle(i)[axis] - middles.low[axis]) / extent * bins));
  }

  void try_axis(std::span<const uint32_t> ids, const SahBox& middles, int axis, Split& best) const {
    if (!(middles.high[axis] > middles.low[axis])) return;
    std::array<Bin, bins> bin{};
    for (const uint32_t i : ids) {
      Bin& own = bin[bin_of(i, middles, axis)];
      own.box.include(boxes_[i]);
      ++own.count;
    }
    std::array<double, bins> right{};
    Bin sum;
    for (int b = bins - 1; b > 0; --b) {
      sum.box.include(bin[b].box), sum.count += bin[b].count;
      right[b] = sum.count ? sum.count * sum.box.half_area() : std::numeric_limits<double>::infinity();
    }
    sum = {};
    for (int b = 1; b < bins; ++b) {
      sum.box.include(bin[b - 1].box), sum.count += bin[b - 1].count;
      if (sum.count && sum.count * sum.box.half_area() + right[b] < best.cost)
        best = {axis, b, sum.count * sum.box.half_area() + right[b]};
    }
  }

  double build(std::span<uint32_t> ids, const SahBox& box, bool is_root = false) const {
    const double area = box.half_area(), as_leaf = shared::triangle_cost * double(ids.size()) * area;
    if (ids.size() == 1) return as_leaf;
    const SahBox middles = middles_of(ids);
    Split split;
    for (int axis = 0; axis < 3; ++axis) try_axis(ids, middles, axis, split);
    auto half = ids.begin() + std::ptrdiff_t(ids.size() / 2);
    if (split.axis >= 0)
      half = std::partition(ids.begin(), ids.end(),
                            [&](uint32_t i) { return bin_of(i, middles, split.axis) < split.bin; });
    const std::span<uint32_t> left(ids.begin(), half), right(half, ids.end());
    const double as_node = 2.0 * shared::box_cost * area + build(left, box_of(left)) + build(right, box_of(right));
    return ids.size() <= shared::max_leaf_triangles && !is_root ? std::min(as_leaf, as_node) : as_node;
  }

  std::vector<SahBox> boxes_;
};

}  // namespace

double SahBox::half_area() const {
  const glm::dvec3 size = glm::max(glm::dvec3(high) - glm::dvec3(low), glm::dvec3(0));
  return size.x * size.y + size.y * size.z + size.z * size.x;
}

void SahBox::include(const SahBox& other) {
  low = glm::min(low, other.low);
  high = glm::max(high, other.high);
}

double binned_sah_cost(std::vector<SahBox> boxes) { return BinnedBuild(std::move(boxes)).run(); }

std::vector<SahBox> world_boxes(const scene::Scene& scene, const Variant& variant) {
  const scene::Pose pose =
      scene.pose(variant.seconds.back(), scene::playing(scene, variant.options.animation).animations);
  std::vector<SahBox> boxes;
  for (uint32_t i = 0; i < scene.instances.size(); ++i) {
    const scene::Mesh& mesh = scene.meshes[scene.instances[i].mesh];
    const std::vector<glm::vec3> positions = scene::posed_positions(scene, pose, i);
    for (const glm::uvec3& triangle : mesh.triangles) {
      SahBox box;
      for (int corner = 0; corner < 3; ++corner) {
        const glm::vec3 point = pose.instances[i] * glm::vec4(positions[triangle[corner]], 1);
        box.include({point, point});
      }
      boxes.push_back(box);
    }
  }
  return boxes;
}

Table sah_table(const std::vector<SceneResults>& scenes, const std::vector<double>& binned) {
  Table table{.title = "The object hierarchy against a binned SAH build on the host", .columns = {"SAH COST"}};
  for (const SceneResults& scene : scenes) table.columns.push_back(upper(scene.name));
  std::vector<std::string> reference = {"binned SAH build"};
  for (const double cost : binned) reference.push_back(fmt::format("{:.2f}", cost));
  table.rows.push_back(std::move(reference));
  for (size_t variant = 0; variant < scenes.front().results.size(); ++variant) {
    if (!has_object_hierarchy(scenes.front().results[variant].variant)) continue;
    std::vector<std::string> cost = {row_name(scenes.front().results[variant])}, ratio = {"  / binned"};
    for (size_t scene = 0; scene < scenes.size(); ++scene) {
      const double own = scenes[scene].results[variant].counters.object_hierarchy.sah_cost;
      cost.push_back(fmt::format("{:.2f}", own));
      ratio.push_back(binned[scene] > 0 ? fmt::format("{:.3f}", own / binned[scene]) : "-");
    }
    table.rows.push_back(std::move(cost));
    table.rows.push_back(std::move(ratio));
  }
  table.note = "Expected tests of a ray that meets the whole scene's box.";
  return table;
}

}  // namespace crsh::bench
