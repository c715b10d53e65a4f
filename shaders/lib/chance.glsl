#ifndef CRSH_LIB_CHANCE_GLSL
#define CRSH_LIB_CHANCE_GLSL
// Words mixed into one that looks like chance: of a digest, and of numbers that are the same on every run.

/// One round of a 32-bit finaliser (constants of Wellons's lowbias32).
uint mixed(uint x) {
  x = (x ^ (x >> 16)) * 0x7FEB352Du;
  x = (x ^ (x >> 15)) * 0x846CA68Bu;
  return x ^ (x >> 16);
}

/// The state after one more word.
uint absorbed(uint state, uint word) { return mixed(state ^ (word + 0x9E3779B9u + (state << 6) + (state >> 2))); }

#endif
