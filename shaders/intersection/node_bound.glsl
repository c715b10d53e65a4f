// Loads a node's bound: the lanes of its cluster load a word each and pass it to the others.

const uint bound_words = bound_bytes / 16u;
vec4 own_words[8];

#ifdef CRSH_NO_SHUFFLE
#define WORD(k) own_words[k]
#else
#define WORD(k) FROM_LANE(own_words[(k) / cluster], first_of_cluster() + (k) % cluster)
#endif

BOUND load_bound(uint node) {
  for (uint k = 0u; k * cluster < bound_words; ++k)
    own_words[k] = node_words[node * bound_words + min(k * cluster + lane_in_cluster(), bound_words - 1u)];
  return BOUND_OF_WORDS(WORD);
}
