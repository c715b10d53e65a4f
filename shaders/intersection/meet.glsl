// What happens where a ray meets a triangle (section 3.2.6), the same for every kernel that tests rays: the test of
// lib/triangle.glsl, then alpha where the triangle has any, then the closest hit, with ties to the lower id, or a
// shadow ray's transmittance. It uses bindings 0 to 4 and set 1.

#include "intersection/no_hit.glsl"
#include "intersection/sheer_tables.glsl"
#include "lib/minus_log2.glsl"
#include "lib/shuffle_read.glsl"
#include "lib/triangle.glsl"
#include "shared/scene.h"

layout(binding = 0, scalar) readonly buffer CornersA { vec4 corner_a[]; };
layout(binding = 1, scalar) readonly buffer CornersB { vec4 corner_b[]; };
layout(binding = 2, scalar) readonly buffer CornersC { vec4 corner_c[]; };
layout(binding = 3, scalar) readonly buffer Materials { Material materials[]; };
layout(binding = 4, scalar) buffer Hits { uvec4 hits[]; };

/// A triangle as it lies in memory: three corners, with the flags in the first one's w.
struct Loaded {
  uint id;
  vec4 a;
  vec4 b;
  vec4 c;
};

Loaded load_triangle(uint triangle) {
  return Loaded(triangle, corner_a[triangle], corner_b[triangle], corner_c[triangle]);
}

/// The same where the corners are those in leaf order (shared/object.h).
Loaded load_leaf_triangle(uint place) {
  vec4 c = corner_c[place];
  return Loaded(floatBitsToUint(c.w), corner_a[place], corner_b[place], c);
}

/// The triangle that lane k of the subgroup has loaded.
Loaded passed_round(Loaded mine, uint k) {
  return Loaded(FROM_LANE(mine.id, k), FROM_LANE(mine.a, k), vec4(FROM_LANE(mine.b.xyz, k), 0.0),
                vec4(FROM_LANE(mine.c.xyz, k), 0.0));
}

/// What a hit is once the triangle's alpha has been asked for.
struct Covered {
  bool there;     // a hit at all
  uvec3 through;  // what it lets through to a shadow ray, as in hits
};

Covered covered(uint triangle, uint flags, vec3 edges, uvec3 whole) {
  Sheer sheer = sheer_of(triangle);
  float alpha = alpha_at(sheer, normalised(edges), (flags & triangle_mirrored) != 0u);
  return Covered(is_there(sheer, alpha), is_blended(sheer) ? sheet_minus_log2(alpha, sheer.through) : whole);
}

/// The hit of `ray`, whose direction has this shear, after it has been tested against a triangle. Alpha is asked for
/// only where the triangle's plain hit would change something.
uvec4 meet(uvec4 hit, Ray ray, Shear shear, Loaded loaded) {
  uint triangle = loaded.id;
  vec4 a = loaded.a, b = loaded.b, c = loaded.c;
  uint flags = floatBitsToUint(a.w);
  bool any_hit = takes_any_hit(ray);
  bool cull_back = passes_backs(ray) && (flags & triangle_cull_back) != 0u;
  float t;
  vec3 edges;
  bool met =
      hit_triangle(ray.origin.xyz, ray.direction.xyz, shear, ray.origin.w, a.xyz, b.xyz, c.xyz, cull_back, t, edges);

  float best = uintBitsToFloat(hit.x);
  bool closer = !any_hit && met && (t < best || (t == best && triangle < hit.y));
  bool stopped = any_hit && met && (flags & triangle_transmissive) == 0u;
  bool tinted = any_hit && met && !stopped;
  uvec3 through = uvec3(blocked);
  if (tinted) through = materials[flags & triangle_material_mask].tint.xyz;
  if (sheer_pages != 0u) {
    bool open = any_hit ? met && any(notEqual(hit.xyz, uvec3(blocked))) : closer;
    if (open && (flags & triangle_sheer) != 0u) {
      Covered found = covered(triangle, flags, edges, through);
      ++hit.w;
      closer = closer && found.there;
      tinted = any_hit && found.there;
      stopped = false;
      through = found.through;
    }
  }
  uvec4 result = closer ? uvec4(floatBitsToUint(t), triangle, 0u, hit.w) : hit;
  result = stopped ? uvec4(blocked, blocked, blocked, hit.w) : result;
  if (tinted) result.xyz = saturating_sum(result.xyz, through);
  return result;
}
