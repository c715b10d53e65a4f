#version 460
// The raster pass (section 3.1), vertices: corners come from the scene's tables, the projection has its depth reversed
// and a perspective eye no far end unless its camera has one. A triangle whose back lets eye rays pass and faces the
// eye is put outside the image.
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
#extension GL_EXT_samplerless_texture_functions : require
#include "lib/exact.glsl"
#include "raster/view.glsl"
#include "scene/surface.glsl"
#define VARYING out
#include "raster/varyings.glsl"

vec4 projected(vec3 point) {
  vec3 way = point - eye;
  vec3 seen = vec3(exact_dot(right, way) * scale_x, -exact_dot(up, way) * scale_y, exact_dot(forward, way));
  if (orthographic == 1.0) return vec4(seen.xy + shift, (far_plane - seen.z) / (far_plane - near_plane), 1.0);
  float depth = far_plane == 0.0 ? near_plane : near_plane * (far_plane - seen.z) / (far_plane - near_plane);
  return vec4(seen.xy + shift * seen.z, depth, seen.z);
}

void hand_over_vertex(uint corner) {
  Instance instance = instances[instance_of(drawn_triangle)];
  Vertex vertex = vertex_at(vertices_of(drawn_triangle, is_mirrored(instance))[corner]);
  normal = normal_to_world(instance, vertex.normal);
  colour = colour_of(vertex);
  texcoords = vec4(vertex.uv[0], vertex.uv[1]);
  more_texcoords = vertex.uv[2];
}

void main() {
  drawn_triangle = uint(gl_VertexIndex) / 3u;
  uint corner = uint(gl_VertexIndex) % 3u;
  Corners at = corners_at(drawn_triangle);
  front = front_normal(at.a, at.b, at.c);
  area = doubled_area(at.a, at.b, at.c);
  position = corner == 0u ? at.a : corner == 1u ? at.b : at.c;
  hand_over_vertex(corner);
  bool passes = (flags_of(drawn_triangle) & triangle_cull_back) != 0u && !meets_front(front, eye_ray(at.a));
  gl_Position = passes ? vec4(2.0, 2.0, 2.0, 1.0) : projected(position);
}
