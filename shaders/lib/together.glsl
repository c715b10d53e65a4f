#ifndef CRSH_LIB_TOGETHER_GLSL
#define CRSH_LIB_TOGETHER_GLSL
// A subgroup whose lanes all walk one list reads it together: each lane loads another element and passes it round.
// lavapipe pays 10 ns a lane for every vec4 that is loaded, however many lanes want the same one, and 1 ns for a
// shuffle. Where lanes walk different lists, each goes its own way; no result depends on which way was taken. The build
// makes every kernel that includes this file twice: "-alone", with CRSH_ALONE, never reads together and shuffles
// nothing, for devices that cannot or gain nothing. No lane may have returned.

#extension GL_KHR_shader_subgroup_basic : require
#extension GL_KHR_shader_subgroup_ballot : require
#ifndef CRSH_ALONE
#extension GL_KHR_shader_subgroup_shuffle : require
#endif

/// Whether all lanes of the subgroup have the same list, begin to before end, so that they walk it together. (An empty
/// list begins where the next one does: its lanes would stop and leave the others without what they load.)
bool walk_together(uint begin, uint end) {
#ifdef CRSH_ALONE
  return false;
#else
  uvec2 list = uvec2(begin, end), first = subgroupBroadcastFirst(list);
  return subgroupBallot(list != first) == uvec4(0u);
#endif
}

/// Whether any lane of the subgroup wants it.
bool any_lane(bool wanted) { return subgroupBallot(wanted) != uvec4(0u); }

#ifdef CRSH_ALONE
#define FROM_LANE(value, lane) (value)
#else
#define FROM_LANE(value, lane) subgroupShuffle(value, lane)
#endif

#endif
