#include "scene/bounding.h"

#include <algorithm>
#include <cmath>

#include "scene/smallest_sphere.h"

namespace crsh::scene {

namespace {

using glm::dmat3;
using glm::dvec3;

struct Stretch {
  double least = 0, largest = 0;
};

/// One Jacobi rotation: makes s[p][q] of a symmetric matrix zero.
void rotate_away(dmat3& s, int p, int q) {
  if (s[p][q] == 0) return;
  const double theta = (s[q][q] - s[p][p]) / (2 * s[p][q]);
  const double t = std::copysign(1.0, theta) / (std::abs(theta) + std::hypot(theta, 1.0));
  const double c = 1 / std::hypot(t, 1.0);
  dmat3 turn(1);
  turn[p][p] = turn[q][q] = c;
  turn[q][p] = t * c;
  turn[p][q] = -t * c;
  s = glm::transpose(turn) * s * turn;
  s[p][q] = s[q][p] = 0;
}

/// The least and largest singular value: square roots of the eigenvalues of AᵀA (cyclic Jacobi).
Stretch stretch_of(const dmat3& a) {
  dmat3 s = glm::transpose(a) * a;
  for (int sweep = 0; sweep < 12; ++sweep) {
    rotate_away(s, 0, 1);
    rotate_away(s, 0, 2);
    rotate_away(s, 1, 2);
  }
  const auto [least, largest] = std::minmax({s[0][0], s[1][1], s[2][2]});
  return {std::sqrt(std::max(least, 0.0)), std::sqrt(std::max(largest, 0.0))};
}

/// The greatest sum of the terms' magnitudes in any coordinate when a point of the sphere is transformed. Float
/// rounding is relative to this, even where a translation cancels the terms.
double largest_terms(const glm::dmat4& m, const Sphere& sphere) {
  double most = 0;
  for (int row = 0; row < 3; ++row) {
    double terms = std::abs(m[3][row]);
    for (int column = 0; column < 3; ++column)
      terms += std::abs(m[column][row]) * (std::abs(double(sphere.centre[column])) + sphere.radius);
    most = std::max(most, terms);
  }
  return most;
}

}  // namespace

void fill_bounds(Mesh& mesh) {
  mesh.sphere = smallest_sphere(mesh.positions);
  const dvec3 centre(mesh.sphere.centre);
  double similar = mesh.sphere.radius, affine = mesh.sphere.radius;
  for (const glm::uvec3& triangle : mesh.triangles) {
    const dvec3 a(mesh.positions[triangle.x]), b(mesh.positions[triangle.y]), c(mesh.positions[triangle.z]);
    const ExactSphere own = triangle_sphere(a, b, c);
    similar = std::max(similar, glm::distance(own.centre, centre) + own.radius);
    // An affine map moves the centre of the smallest sphere within the triangle: only the corners bound where it goes.
    affine = std::max(
        affine, std::max({glm::distance(a, centre), glm::distance(b, centre), glm::distance(c, centre)}) + own.radius);
  }
  mesh.cover_similar = rounded_outwards(similar);
  mesh.cover_affine = rounded_outwards(affine);
}

Sphere transformed_sphere(const Mesh& mesh, const glm::mat4& transform) {
  constexpr double similarity = 1e-6;   // singular values that differ by less, relatively, differ by rounding only
  constexpr double pad = 1.0 / 524288;  // 2^-19: for the rounding of float transforms and a triangle's own pad
  const glm::dmat4 exact(transform);
  const Stretch stretch = stretch_of(dmat3(exact));
  const bool similar = stretch.largest - stretch.least <= similarity * stretch.largest;
  const glm::vec3 centre(exact * glm::dvec4(mesh.sphere.centre, 1));
  const double radius = stretch.largest * (similar ? mesh.cover_similar : mesh.cover_affine);
  return {centre, rounded_outwards(radius + pad * largest_terms(exact, mesh.sphere))};
}

}  // namespace crsh::scene
