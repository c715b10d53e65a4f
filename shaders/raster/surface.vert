#version 460
// The raster pass (section 3.1), vertices: corners come from the scene's tables, the projection has its depth reversed
// and a perspective eye no far end. A triangle whose back lets eye rays pass and faces the eye is put outside the image.
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#include "lib/surface.glsl"
#include "raster/view.glsl"
#include "scene/tables.glsl"

layout(location = 0) flat out uint out_triangle;
layout(location = 1) out vec3 out_weights;

vec4 projected(vec3 point) {
  vec3 way = point - eye;
  vec3 seen = vec3(exact_dot(right, way) * scale_x, -exact_dot(up, way) * scale_y, exact_dot(forward, way));
  if (orthographic == 1.0) return vec4(seen.xy + shift, (far_plane - seen.z) / (far_plane - near_plane), 1.0);
  return vec4(seen.xy + shift * seen.z, near_plane, seen.z);
}

void main() {
  uint triangle = uint(gl_VertexIndex) / 3u, corner = uint(gl_VertexIndex) % 3u;
  vec3 a = corner_a[triangle].xyz, b = corner_b[triangle].xyz, c = corner_c[triangle].xyz;
  bool passes = (flags_of(triangle) & triangle_cull_back) != 0u && !meets_front(front_normal(a, b, c), eye_ray(a));
  out_triangle = triangle;
  out_weights = vec3(equal(uvec3(corner), uvec3(0u, 1u, 2u)));
  gl_Position = passes ? vec4(2.0, 2.0, 2.0, 1.0) : projected(corner == 0u ? a : corner == 1u ? b : c);
}
