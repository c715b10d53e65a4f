#version 460
// Traces rays with the device's own ray queries (VK_KHR_ray_query), to compare with. Here the device decides what a hit
// is, so that pictures are equal to the others' only within a tolerance. Lane: a ray.
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_ray_query : require
#extension GL_EXT_scalar_block_layout : require
layout(local_size_x = 64) in;
#include "intersection/no_hit.glsl"
#include "intersection/sheer_tables.glsl"
#include "lib/invocation.glsl"
#include "lib/minus_log2.glsl"

layout(constant_id = 0) const bool plain = false;  // every triangle blocks, from either side: none is asked about

layout(push_constant, scalar) uniform Push { uint first, end; };
layout(binding = 0) uniform accelerationStructureEXT scene;
layout(binding = 1, scalar) readonly buffer Rays { Ray rays[]; };
layout(binding = 2, scalar) writeonly buffer Hits { uvec4 hits[]; };
layout(binding = 3, scalar) readonly buffer CornersA { vec4 corner_a[]; };  // for the flags
layout(binding = 4, scalar) readonly buffer Materials { Material materials[]; };

/// What the device says may be hit, and what of it is.
struct Candidate {
  bool met;
  bool tints;
  uvec3 through;  // where it tints
};

Candidate met_whole(Ray ray, uint flags, bool front) {
  bool any_hit = takes_any_hit(ray);
  bool tints = any_hit && (flags & triangle_transmissive) != 0u;
  bool met = !passes_backs(ray) || (flags & triangle_cull_back) == 0u || front;
  return Candidate(met, tints, tints ? materials[flags & triangle_material_mask].tint.xyz : uvec3(blocked));
}

/// The same where the triangle has alpha: as in meet.glsl.
Candidate met_covered(Candidate whole, bool any_hit, uint triangle, uint flags, vec2 share) {
  Sheer sheer = sheer_of(triangle);
  float alpha = alpha_at(sheer, vec3(1.0 - share.x - share.y, share), (flags & triangle_mirrored) != 0u);
  bool blends = any_hit && is_blended(sheer);
  uvec3 through = blends ? sheet_minus_log2(alpha, sheer.through) : whole.through;
  bool stops = through == uvec3(blocked);
  return Candidate(whole.met && is_there(sheer, alpha), any_hit && !stops, through);
}

void main() {
  uint i = first + invocation_index();
  if (i >= end) return;
  Ray ray = rays[i];
  uvec4 hit = no_hit(ray);
  bool any_hit = takes_any_hit(ray);
  uint query_flags = (plain ? gl_RayFlagsOpaqueEXT : 0u) | (any_hit ? gl_RayFlagsTerminateOnFirstHitEXT : 0u);
  rayQueryEXT query;
  rayQueryInitializeEXT(query, scene, query_flags, 0xFFu, ray.origin.xyz, 0.0, ray.direction.xyz, ray.origin.w);
  while (rayQueryProceedEXT(query)) {
    uint triangle = rayQueryGetIntersectionPrimitiveIndexEXT(query, false);
    uint flags = floatBitsToUint(corner_a[triangle].w);
    Candidate found = met_whole(ray, flags, rayQueryGetIntersectionFrontFaceEXT(query, false));
    if (sheer_pages != 0u && (flags & triangle_sheer) != 0u)
      found = met_covered(found, any_hit, triangle, flags, rayQueryGetIntersectionBarycentricsEXT(query, false));
    if (found.met && found.tints) hit.xyz = saturating_sum(hit.xyz, found.through);
    if (found.met && !found.tints) rayQueryConfirmIntersectionEXT(query);
  }
  if (rayQueryGetIntersectionTypeEXT(query, true) == gl_RayQueryCommittedIntersectionTriangleEXT) {
    uint triangle = rayQueryGetIntersectionPrimitiveIndexEXT(query, true);
    float t = rayQueryGetIntersectionTEXT(query, true);
    hit = any_hit ? uvec4(blocked, blocked, blocked, 0u) : uvec4(floatBitsToUint(t), triangle, 0u, 0u);
  }
  hits[i] = hit;
}
