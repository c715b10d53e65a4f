#version 460
// Deforms meshes for this frame: morph targets first (glTF 2.0, section 3.7.2.2), then the joints of a skin (section
// 3.7.3.3). Normals are turned by the blended joints' cofactors, on the side that a mirror leaves outside. Lane: a
// vertex of an instance that deforms.
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
layout(local_size_x = 64) in;
#include "lib/exact.glsl"
#include "lib/invocation.glsl"
#include "lib/tangent.glsl"
#include "shared/limits.h"
#include "shared/scene.h"

layout(push_constant, scalar) uniform Push {
  uint count;
  uint first_vertex;  // where the stored vertices of instances that deform begin
};
layout(binding = 0, scalar) readonly buffer PosedVertices { PosedVertex posed_vertices[]; };
layout(binding = 1, scalar) readonly buffer PosedInstances { PosedInstance posed_instances[]; };
layout(binding = 2, scalar) readonly buffer Rest { RestVertex rest[]; };
layout(binding = 3, scalar) readonly buffer Influences { Influence influences[]; };
layout(binding = 4, scalar) readonly buffer Displacements { Displacement displacements[]; };
layout(binding = 5, scalar) readonly buffer Joints { vec4 joints[]; };  // three rows a joint
layout(binding = 6, scalar) readonly buffer Weights { float weights[]; };
layout(binding = 7, scalar) writeonly buffer Positions { vec3 positions[]; };
layout(binding = 8, scalar) writeonly buffer Vertices { Vertex vertices[]; };

struct Rows {
  vec4 row0;
  vec4 row1;
  vec4 row2;
};

/// The joints' matrices, blended.
Rows blended(PosedInstance instance, uint begin, uint end) {
  Rows sum = Rows(vec4(0.0), vec4(0.0), vec4(0.0));
  for (uint i = begin; i < end; ++i) {
    Influence influence = influences[i];
    uint joint = influence.joint == none ? instance.joint_count - 1u : influence.joint;
    uint at = 3u * (instance.first_joint + joint);
    sum.row0 += joints[at] * influence.weight;
    sum.row1 += joints[at + 1u] * influence.weight;
    sum.row2 += joints[at + 2u] * influence.weight;
  }
  return sum;
}

vec3 moved(Rows m, vec3 p) {
  return vec3(exact_dot(m.row0.xyz, p) + m.row0.w, exact_dot(m.row1.xyz, p) + m.row1.w,
              exact_dot(m.row2.xyz, p) + m.row2.w);
}

vec3 stretched(Rows m, vec3 direction) {
  return vec3(exact_dot(m.row0.xyz, direction), exact_dot(m.row1.xyz, direction), exact_dot(m.row2.xyz, direction));
}

bool mirrors(Rows m) { return exact_dot(m.row0.xyz, exact_cross(m.row1.xyz, m.row2.xyz)) < 0.0; }

/// By the cofactors, which exist even where the matrix has no inverse, times the sign of the determinant.
vec3 turned(Rows m, vec3 normal) {
  float size = max(max(largest(m.row0.xyz), largest(m.row1.xyz)), max(largest(m.row2.xyz), 1e-30));
  vec3 x = m.row0.xyz / size, y = m.row1.xyz / size, z = m.row2.xyz / size;
  vec3 cofactors = exact_cross(y, z);
  vec3 turned =
      vec3(exact_dot(cofactors, normal), exact_dot(exact_cross(z, x), normal), exact_dot(exact_cross(x, y), normal));
  return exact_dot(x, cofactors) < 0.0 ? -turned : turned;
}

void main() {
  uint i = invocation_index();
  if (i >= count) return;
  PosedVertex vertex = posed_vertices[i];
  PosedInstance instance = posed_instances[vertex.posed];
  RestVertex own = rest[vertex.rest], next = rest[vertex.rest + 1u];
  vec3 position = own.position, normal = own.normal;
  vec4 tangent = has_tangent(own.tangent) ? unpacked_tangent(own.tangent) : vec4(0.0);
  for (uint d = own.first_displacement; d < next.first_displacement; ++d) {
    Displacement displacement = displacements[d];
    float weight = weights[instance.first_weight + displacement.target];
    position += displacement.position * weight;
    normal += displacement.normal * weight;
    tangent.xyz += displacement.tangent * weight;
  }
  if (own.normal == vec3(0.0)) normal = vec3(0.0);  // flat, at rest as deformed
  if (instance.joint_count != 0u) {
    Rows joint = blended(instance, own.first_influence, next.first_influence);
    position = moved(joint, position);
    normal = turned(joint, normal);
    tangent = vec4(stretched(joint, tangent.xyz), mirrors(joint) ? -tangent.w : tangent.w);
  }
  positions[first_vertex + i] = position;
  vertices[first_vertex + i].normal = exact_normalize(normal);
  if (has_tangent(own.tangent)) vertices[first_vertex + i].tangent = packed_tangent(tangent);
}
