#include "scene/smallest_sphere.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace crsh::scene {

namespace {

using glm::dvec3;

double squared_length(const dvec3& v) { return glm::dot(v, v); }

/// The smallest sphere with up to four given points on its boundary, to which points are added and from which they are
/// removed one at a time (section 3 of the paper). Each point's direction from the first one is made orthogonal to
/// those before it, and the centre moves along that.
class Boundary {
 public:
  [[nodiscard]] bool full() const { return count_ == 4; }
  /// How far outside the sphere p is: the difference of squared distances.
  [[nodiscard]] double excess(const dvec3& p) const { return squared_length(p - centre_) - squared_radius_; }
  [[nodiscard]] double squared_radius() const { return squared_radius_; }
  [[nodiscard]] const dvec3& centre() const { return centre_; }

  /// Puts p on the boundary. Returns false where p lies, up to rounding, in the plane or on the line of the others.
  bool push(const dvec3& p);
  /// Takes the last point off the boundary; the sphere itself stays until the next push.
  void pop() { --count_; }

 private:
  struct Step {
    dvec3 direction{0}, centre{0};
    double scale = 0, squared_radius = 0;
  };
  dvec3 first_{0}, centre_{0};
  double squared_radius_ = -1;  // without a point, so that every point is outside
  std::array<Step, 4> steps_;
  size_t count_ = 0;
};

bool Boundary::push(const dvec3& p) {
  Step step;
  if (count_ == 0) {
    first_ = p;
    step.centre = p;
  } else {
    const Step& last = steps_[count_ - 1];
    step.direction = p - first_;
    for (size_t i = 1; i < count_; ++i)
      step.direction -= steps_[i].direction * (2 / steps_[i].scale * glm::dot(steps_[i].direction, step.direction));
    step.scale = 2 * squared_length(step.direction);
    constexpr double dependent = 1e-24;  // below this squared sine a direction is a rounding error
    if (step.scale <= dependent * std::max(squared_radius_, squared_length(p - first_))) return false;
    const double outside = squared_length(p - last.centre) - last.squared_radius;
    const double move = outside / step.scale;
    step.centre = last.centre + step.direction * move;
    step.squared_radius = last.squared_radius + outside * move / 2;
  }
  centre_ = step.centre;
  squared_radius_ = step.squared_radius;
  steps_[count_++] = step;
  return true;
}

/// The points that may determine the sphere, those most likely to do so first.
class Candidates {
 public:
  /// Grows the sphere until it holds the first `end` points, too; afterwards the first `support_` of them determine it.
  void move_to_front(size_t end) {
    support_ = 0;
    if (sphere.full()) return;
    for (size_t i = 0; i < end; ++i) {
      if (sphere.excess(points_[i]) <= 0 || !sphere.push(points_[i])) continue;
      move_to_front(i);
      sphere.pop();
      std::rotate(points_.begin(), points_.begin() + static_cast<std::ptrdiff_t>(i),
                  points_.begin() + static_cast<std::ptrdiff_t>(i) + 1);
      ++support_;
    }
  }

  /// Makes it the smallest sphere around the points that determine it and p, which lies outside.
  void add(const dvec3& p) {
    points_.resize(support_);
    if (!sphere.push(p)) return;
    move_to_front(support_);
    sphere.pop();
    points_.insert(points_.begin(), p);
    ++support_;
  }

  Boundary sphere;

 private:
  std::vector<dvec3> points_;
  size_t support_ = 0;
};

/// The centre, by pivoting (section 4 of the paper): adds the farthest point as long as the sphere grows by that.
dvec3 centre_of(std::span<const glm::vec3> points) {
  constexpr double growth = 1 + 1e-14;  // a smaller growth is a rounding error
  Candidates candidates;
  candidates.add(dvec3(points.front()));
  for (double before = -1; candidates.sphere.squared_radius() > before * growth;) {
    before = candidates.sphere.squared_radius();
    const auto nearer = [&](const glm::vec3& a, const glm::vec3& b) {
      return candidates.sphere.excess(dvec3(a)) < candidates.sphere.excess(dvec3(b));
    };
    const dvec3 farthest(*std::max_element(points.begin(), points.end(), nearer));
    if (candidates.sphere.excess(farthest) > 0) candidates.add(farthest);
  }
  return candidates.sphere.centre();
}

}  // namespace

Sphere smallest_sphere(std::span<const glm::vec3> points) {
  if (points.empty()) return {};
  const glm::vec3 centre(centre_of(points));
  double squared = 0;
  for (const glm::vec3& p : points) squared = std::max(squared, squared_length(dvec3(p) - dvec3(centre)));
  const double radius = std::sqrt(squared);
  const float nearest = static_cast<float>(radius);
  return {centre, nearest > radius * (1 + 1e-15) || radius == 0 ? nearest : std::nextafter(nearest, INFINITY)};
}

ExactSphere triangle_sphere(const dvec3& a, const dvec3& b, const dvec3& c) {
  const dvec3 corners[] = {a, b, c};
  for (int i = 0; i < 3; ++i) {  // opposite an angle of 90 degrees or more the edge is a diameter
    const dvec3 &p = corners[i], &q = corners[(i + 1) % 3], &r = corners[(i + 2) % 3];
    if (glm::dot(q - p, r - p) <= 0) return {(q + r) / 2.0, std::sqrt(squared_length(q - r)) / 2};
  }
  const dvec3 ab = b - a, ac = c - a, normal = glm::cross(ab, ac);
  const dvec3 to_centre = (glm::cross(normal, ab) * squared_length(ac) + glm::cross(ac, normal) * squared_length(ab)) /
                          (2 * squared_length(normal));
  return {a + to_centre, std::sqrt(squared_length(to_centre))};
}

float rounded_outwards(double x) { return std::nextafter(static_cast<float>(x * (1 + 1e-6)), INFINITY); }

}  // namespace crsh::scene
