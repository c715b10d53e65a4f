#ifndef CRSH_LIB_SHUFFLE_READ_GLSL
#define CRSH_LIB_SHUFFLE_READ_GLSL
// Where all lanes of a subgroup walk the same list, each loads another element of it and passes it to the others by a
// shuffle. On lavapipe a load of a vec4 takes 10 ns a lane, even where all lanes load the same one, and a shuffle 1 ns.
// Where lanes walk different lists each loads its own elements; results are the same either way. The build makes every
// kernel that includes this file twice: the one called "-no-shuffle", with CRSH_NO_SHUFFLE, has no shuffles, for
// devices that have none or gain nothing by them. No lane may have returned before.

#extension GL_KHR_shader_subgroup_basic : require
#extension GL_KHR_shader_subgroup_ballot : require
#ifndef CRSH_NO_SHUFFLE
#extension GL_KHR_shader_subgroup_shuffle : require
#endif

/// Whether all lanes of the subgroup have the same list, from begin to before end. (Lanes with an empty list, which
/// begins where the next one does, do not count as having the same: they would stop, and the others would miss what
/// they load.)
bool same_list(uint begin, uint end) {
#ifdef CRSH_NO_SHUFFLE
  return false;
#else
  uvec2 list = uvec2(begin, end), first = subgroupBroadcastFirst(list);
  return subgroupBallot(list != first) == uvec4(0u);
#endif
}

/// Whether `wanted` is true in any lane of the subgroup; asked only where all have the same list.
bool any_lane(bool wanted) {
#ifdef CRSH_NO_SHUFFLE
  return wanted;
#else
  return subgroupBallot(wanted) != uvec4(0u);
#endif
}

#ifdef CRSH_NO_SHUFFLE
#define FROM_LANE(value, lane) (value)
#else
#define FROM_LANE(value, lane) subgroupShuffle(value, lane)
#endif

#endif
