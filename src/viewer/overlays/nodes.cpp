// Ray nodes as balls and cones, bounds of objects as circles and boxes: lines above the picture.

#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <numbers>

#include "output/heat_map.h"
#include "scene/deform.h"
#include "scene/hide.h"
#include "viewer/overlays/overlays.h"

namespace crsh::viewer {
namespace {

constexpr size_t max_nodes = 300;  // drawn of a level
constexpr float widest = 1.2f;     // radians: wider cones are not drawn
constexpr int circle_steps = 32, cone_lines = 8;

/// The picture's matrix, which is for the file's coordinates, for those of the drawn world.
glm::mat4 of_drawn(const glm::dmat4& matrix, const glm::dvec3& origin) {
  return glm::mat4(glm::translate(matrix, origin));
}

/// Draws lines of the drawn world where the picture shows them.
class Pen {
 public:
  Pen(ImDrawList& list, const Picture& picture, const glm::dvec3& origin, const Layout& layout)
      : list_(list),
        to_image_(of_drawn(picture.world_to_ndc, origin)),
        to_camera_(of_drawn(picture.world_to_camera, origin)),
        layout_(layout) {}

  void line(glm::vec3 a, glm::vec3 b, ImU32 colour) const {
    glm::vec4 p = to_image_ * glm::vec4(a, 1), q = to_image_ * glm::vec4(b, 1);
    constexpr float nearest = 1e-3f;
    if (p.w < nearest && q.w < nearest) return;
    if (p.w < nearest) p = glm::mix(p, q, (nearest - p.w) / (q.w - p.w));
    if (q.w < nearest) q = glm::mix(q, p, (nearest - q.w) / (p.w - q.w));
    const glm::vec2 from = place(p), to = place(q);
    list_.AddLine({from.x, from.y}, {to.x, to.y}, colour, 1.3f);
  }

  void circle(glm::vec3 centre, glm::vec3 x, glm::vec3 y, ImU32 colour) const {
    glm::vec3 last = centre + x;
    for (int i = 1; i <= circle_steps; ++i) {
      const float angle = 2 * float(std::numbers::pi) * float(i) / circle_steps;
      const glm::vec3 next = centre + x * std::cos(angle) + y * std::sin(angle);
      line(last, next, colour);
      last = next;
    }
  }

  /// Draws a ball: its outline, and a circle within.
  void ball(glm::vec3 centre, float radius, ImU32 colour) const {
    const glm::vec3 right(to_camera_[0][0], to_camera_[1][0], to_camera_[2][0]),
        up(to_camera_[0][1], to_camera_[1][1], to_camera_[2][1]);
    circle(centre, right * radius, up * radius, colour);
  }

  void box(glm::vec3 low, glm::vec3 high, ImU32 colour) const {
    const auto corner = [&](int i) {
      return glm::vec3(i & 1 ? high.x : low.x, i & 2 ? high.y : low.y, i & 4 ? high.z : low.z);
    };
    for (int i = 0; i < 8; ++i)
      for (const int bit : {1, 2, 4})
        if (!(i & bit)) line(corner(i), corner(i | bit), colour);
  }

 private:
  [[nodiscard]] glm::vec2 place(glm::vec4 p) const {
    const glm::vec2 share = glm::clamp(glm::vec2(p) / p.w, glm::vec2(-20), glm::vec2(20));
    return layout_.low() + share * (layout_.high() - layout_.low());
  }

  ImDrawList& list_;
  glm::mat4 to_image_, to_camera_;
  const Layout& layout_;
};

ImU32 heat(double place, int alpha) {
  const auto c = output::heat_colour(0.15 + 0.85 * place);
  return IM_COL32(c[0], c[1], c[2], alpha);
}

void draw_node(const Pen& pen, const RayNode& node, float reach, ImU32 colour) {
  pen.ball(node.centre, std::max(node.radius, 1e-6f), colour);
  if (node.half_angle > widest) return;
  const glm::vec3 aside = std::abs(node.axis.y) < 0.9f ? glm::vec3(0, 1, 0) : glm::vec3(1, 0, 0);
  const glm::vec3 x = glm::normalize(glm::cross(node.axis, aside)), y = glm::cross(node.axis, x);
  const float end = node.radius + reach * std::tan(node.half_angle);
  const glm::vec3 far = node.centre + node.axis * reach;
  pen.circle(far, x * end, y * end, colour);
  for (int i = 0; i < cone_lines; ++i) {
    const float angle = 2 * float(std::numbers::pi) * float(i) / cone_lines;
    const glm::vec3 side = x * std::cos(angle) + y * std::sin(angle);
    pen.line(node.centre + side * node.radius, far + side * end, colour);
  }
}

/// The places in sorted order of the rays of the pixel under the cursor.
std::vector<uint32_t> places_under_cursor(const NodeFrame& frame, const Layout& layout) {
  const ImVec2 mouse = ImGui::GetIO().MousePos;
  const glm::vec2 share = (glm::vec2(mouse.x, mouse.y) - layout.low()) / (layout.high() - layout.low());
  std::vector<uint32_t> places;
  if (share.x < 0 || share.y < 0 || share.x >= 1 || share.y >= 1) return places;
  const uint32_t pixel =
      uint32_t(share.y * float(frame.order.height)) * frame.order.width + uint32_t(share.x * float(frame.order.width));
  for (auto at = std::ranges::lower_bound(frame.places, std::pair(pixel, 0u));
       at != frame.places.end() && at->first == pixel; ++at)
    places.push_back(at->second);
  return places;
}

void draw_chosen_nodes(const Pen& pen, const Model& model, const Layout& layout) {
  const NodeFrame& frame = *model.left.node_frame;
  std::vector<const RayNode*> chosen;
  const std::vector<uint32_t> places =
      model.nodes_of_all ? std::vector<uint32_t>() : places_under_cursor(frame, layout);
  for (const RayNode& node : frame.nodes) {
    const auto holds = [&](uint32_t place) { return place >= node.first && place < node.end; };
    if (node.level == model.nodes_level && (model.nodes_of_all || std::ranges::any_of(places, holds)))
      chosen.push_back(&node);
  }
  const size_t step = (chosen.size() + max_nodes - 1) / max_nodes;
  for (size_t i = 0; i < chosen.size(); i += step) {
    const double place = chosen.size() > 1 ? double(i) / double(chosen.size() - 1) : 0.8;
    draw_node(pen, *chosen[i], frame.reaches[size_t(chosen[i] - frame.nodes.data())],
              heat(place, model.nodes_of_all ? 150 : 235));
  }
}

/// Draws the spheres of meshes (section 3.2.1), or the boxes of the object hierarchy where the algorithm has one.
void draw_bounds(const Pen& pen, const Model& model) {
  const scene::Scene& scene = *model.scene();
  const scene::Pose pose = scene.pose(model.left.shown->seconds, model.animations());
  const auto hidden = scene::hidden_instances(scene, model.command.options.hidden);
  const bool boxes = model.has_object_hierarchy() && model.left.node_frame &&
                     !model.left.node_frame->boxes.empty();  // else they may be those of an algorithm chosen before
  for (uint32_t i = 0; !boxes && i < scene.instances.size(); ++i) {
    if (hidden[i]) continue;
    const scene::Sphere sphere = scene::posed_sphere(scene, pose, i);
    pen.ball(sphere.centre, sphere.radius, heat(double(i) / double(scene.instances.size()), 220));
  }
  if (!boxes) return;
  for (const ObjectBox& box : model.left.node_frame->boxes)
    if (box.depth == model.box_depth) pen.box(box.low, box.high, heat(double(box.depth) / 8, 220));
}

}  // namespace

void draw_nodes_and_boxes(const Model& model, const Layout& layout) {
  const glm::dvec3 origin = model.scene() ? model.scene()->origin : glm::dvec3(0);
  const Pen pen(*ImGui::GetBackgroundDrawList(), model.left.shown->picture, origin, layout);
  if (model.show_bounds && model.scene()) draw_bounds(pen, model);
  if (model.show_nodes && model.left.node_frame) draw_chosen_nodes(pen, model, layout);
}

}  // namespace crsh::viewer
