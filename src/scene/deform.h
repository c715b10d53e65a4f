#pragma once
// Meshes that deform: by morph targets (glTF 2.0, section 3.7.2.2), then by the joints of a skin (section 3.7.3).

#include <vector>

#include "scene/scene.h"

namespace crsh::scene {

/// Fills what is known of influences and displacements: joint_count, joint_boxes and target_boxes.
void fill_deform_bounds(Mesh& mesh);

/// Whether its shape is worked out anew each frame.
[[nodiscard]] bool deforms(const Scene& scene, const Instance& instance);

/// The mesh's positions as this pose deforms them, to which the instance's transform applies.
[[nodiscard]] std::vector<glm::vec3> posed_positions(const Scene& scene, const GeometryPose& pose, uint32_t instance);

/// World bounds of an instance that deforms, from those of its joints' vertices: never too small, and quick to find.
[[nodiscard]] Bounds posed_bounds(const Scene& scene, const GeometryPose& pose, uint32_t instance);

/// Whether the instance's triangles are turned inside out: by its transform, or by more of its joints than not.
[[nodiscard]] bool is_mirrored(const Scene& scene, const GeometryPose& pose, uint32_t instance);

/// Around all of an instance (section 3.2.1), whether it deforms or not; empty where it is hidden.
[[nodiscard]] Sphere posed_sphere(const Scene& scene, const GeometryPose& pose, uint32_t instance);

/// The matrix of an influence's joint.
[[nodiscard]] const glm::mat4& joint_matrix(const std::vector<glm::mat4>& joints, uint32_t joint);

}  // namespace crsh::scene
