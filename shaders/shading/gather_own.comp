#version 460
// What each surface of a generation sends back along the ray that came, of its own: emission and direct light. What the
// rays from it brought is added kind by kind (gather.comp). Lane: a surface.
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_scalar_block_layout : require
layout(local_size_x = 64) in;
#include "lib/invocation.glsl"

layout(push_constant, scalar) uniform Push {
  vec3 background;  // of the generation: what a ray that met nothing brings
  uint count;
};
layout(binding = 0, scalar) readonly buffer Emissions { vec4 emissions[]; };
layout(binding = 1, scalar) readonly buffer Direct { vec4 direct[]; };
layout(binding = 2, scalar) writeonly buffer Totals { vec4 totals[]; };  // w: 1 where something was met

void main() {
  uint surface = invocation_index();
  if (surface >= count) return;
  vec4 emission = emissions[surface];
  bool met = emission.w >= 0.0;
  totals[surface] = met ? vec4(emission.rgb + direct[surface].rgb, 1.0) : vec4(background, 0.0);
}
