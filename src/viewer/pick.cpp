#include "viewer/pick.h"

#include <cmath>
#include <limits>

#include "scene/deform.h"

namespace crsh::viewer {
namespace {

bool meets(const scene::Sphere& sphere, const Sight& ray) {
  const glm::vec3 to = sphere.centre - ray.origin;
  const float along = glm::dot(to, ray.direction) / glm::dot(ray.direction, ray.direction);
  const glm::vec3 off = to - ray.direction * along;
  return glm::dot(off, off) <= sphere.radius * sphere.radius * 1.01f;
}

/// The distance along the ray to a triangle, infinite where it misses (Möller and Trumbore 1997).
float distance_to(const Sight& ray, glm::vec3 a, glm::vec3 b, glm::vec3 c) {
  constexpr float nothing = std::numeric_limits<float>::infinity();
  const glm::vec3 ab = b - a, ac = c - a, p = glm::cross(ray.direction, ac);
  const float determinant = glm::dot(ab, p);
  if (determinant == 0) return nothing;
  const glm::vec3 from = ray.origin - a, q = glm::cross(from, ab);
  const float u = glm::dot(from, p) / determinant, v = glm::dot(ray.direction, q) / determinant;
  const float t = glm::dot(ac, q) / determinant;
  return u >= 0 && v >= 0 && u + v <= 1 && t > 0 ? t : nothing;
}

}  // namespace

std::optional<glm::vec3> pick(const scene::Scene& scene, const scene::Pose& pose, const std::vector<bool>& hidden,
                              const Sight& sight) {
  float nearest = std::numeric_limits<float>::infinity();
  for (uint32_t i = 0; i < scene.instances.size(); ++i) {
    const scene::Mesh& mesh = scene.meshes[scene.instances[i].mesh];
    const glm::mat4 inverse =
        glm::inverse(pose.instances[i]);  // not finite for a flattened instance, which is then never hit
    const Sight ray{glm::vec3(inverse * glm::vec4(sight.origin, 1)),
                    glm::vec3(inverse * glm::vec4(sight.direction, 0))};
    if (hidden[i] || !meets(scene::posed_sphere(scene, pose, i), sight)) continue;
    const std::vector<glm::vec3> positions = scene::posed_positions(scene, pose, i);
    for (const glm::uvec3& t : mesh.triangles)
      nearest = std::min(nearest, distance_to(ray, positions[t.x], positions[t.y], positions[t.z]));
  }
  if (!std::isfinite(nearest)) return {};
  return sight.origin + sight.direction * nearest;
}

}  // namespace crsh::viewer
