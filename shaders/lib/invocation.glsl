#ifndef CRSH_LIB_INVOCATION_GLSL
#define CRSH_LIB_INVOCATION_GLSL
// The numbers of the workgroup and of the invocation in a dispatch. Where one axis cannot hold all workgroups,
// Recorder::dispatch makes several rows of them. The last invocations may lie past the count, and a shader must return
// there.

uint workgroup_index() { return gl_WorkGroupID.y * gl_NumWorkGroups.x + gl_WorkGroupID.x; }

// A macro and not a function: in one that stands before layout(local_size_x = ...) glslang takes gl_WorkGroupSize to be
// 1.
#define invocation_index() \
  (workgroup_index() * (gl_WorkGroupSize.x * gl_WorkGroupSize.y * gl_WorkGroupSize.z) + gl_LocalInvocationIndex)

#endif
