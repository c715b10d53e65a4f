#pragma once
// Tangents for meshes that have none.

#include <cstdint>
#include <span>

#include "scene/scene.h"

namespace crsh::scene {

/// Gives tangents, by MikkTSpace, to vertices that have none and whose triangles' materials need them. The texture
/// coordinates are those of the material's normal map, before KHR_texture_transform: TANGENT in a file means them, and
/// shaders turn the frame by the transform, which may be animated. Vertices at which tangents differ are doubled.
/// Triangles without normals are flat, and each has its own.
void fill_tangents(Mesh& mesh, std::span<const Material> materials);
/// The same for all meshes, on two threads.
void fill_tangents(Scene& scene);

/// Appends copies of vertices, with every attribute that they have.
void append_copies(Mesh& mesh, std::span<const uint32_t> vertices);

}  // namespace crsh::scene
