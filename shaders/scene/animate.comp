#version 460
// Moves the scene's triangles to where their instances stand this frame, and with them each triangle's smallest
// sphere (section 3.2.1; the spheres of whole objects are moved by scene::transformed_sphere). Lane: a drawn triangle.
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
layout(local_size_x = 64) in;
#include "lib/invocation.glsl"
#include "lib/triangle.glsl"
#include "shared/scene.h"

layout(push_constant, scalar) uniform Push { uint count; };
layout(binding = 0, scalar) readonly buffer Sources { Source sources[]; };
layout(binding = 1, scalar) readonly buffer Triangles { StoredTriangle triangles[]; };
layout(binding = 2, scalar) readonly buffer Positions { vec3 positions[]; };
layout(binding = 3, scalar) readonly buffer Instances { Instance instances[]; };
layout(binding = 4, scalar) writeonly buffer CornersA { vec4 corner_a[]; };
layout(binding = 5, scalar) writeonly buffer CornersB { vec4 corner_b[]; };
layout(binding = 6, scalar) writeonly buffer CornersC { vec4 corner_c[]; };
layout(binding = 7, scalar) writeonly buffer Spheres { vec4 triangle_spheres[]; };

vec3 to_world(Instance instance, vec3 point) {
  precise vec3 turned = vec3(exact_dot(instance.row0.xyz, point), exact_dot(instance.row1.xyz, point),
                             exact_dot(instance.row2.xyz, point));
  precise vec3 moved = turned + vec3(instance.row0.w, instance.row1.w, instance.row2.w);
  return moved;
}

void main() {
  uint i = invocation_index();
  if (i >= count) return;
  Source source = sources[i];
  Instance instance = instances[source.instance];
  uvec3 triangle = triangles[source.triangle].vertices;
  bool mirrored = instance.normal0.w != 0.0;
  vec3 a = to_world(instance, positions[triangle.x]);
  vec3 b = to_world(instance, positions[mirrored ? triangle.z : triangle.y]);
  vec3 c = to_world(instance, positions[mirrored ? triangle.y : triangle.z]);
  uint flagged = triangles[source.triangle].material | (mirrored ? triangle_mirrored : 0u);
  corner_a[i] = vec4(a, uintBitsToFloat(flagged));
  corner_b[i] = vec4(b, uintBitsToFloat(source.instance));
  corner_c[i] = vec4(c, uintBitsToFloat(source.triangle));
  triangle_spheres[i] = smallest_sphere(a, b, c);
}
