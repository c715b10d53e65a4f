#ifndef CRSH_LIB_INVOCATION_GLSL
#define CRSH_LIB_INVOCATION_GLSL
// Which workgroup and which invocation of a dispatch this is. Recorder::dispatch makes a second row of workgroups where
// one axis does not hold them all, and the last ones may lie past the count: the shader compares and returns.

uint workgroup_index() { return gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x; }

// A macro: in a function that stands before layout(local_size_x = ...) glslang takes gl_WorkGroupSize for 1.
#define invocation_index() \
  (workgroup_index() * (gl_WorkGroupSize.x * gl_WorkGroupSize.y * gl_WorkGroupSize.z) + gl_LocalInvocationIndex)

#endif
