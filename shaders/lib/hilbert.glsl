#ifndef CRSH_LIB_HILBERT_GLSL
#define CRSH_LIB_HILBERT_GLSL
// The order of a square grid's cells along a Hilbert curve: consecutive cells share an edge, and every aligned square
// of cells is one part of the curve.

/// Place along the curve, 0 to 4^bits - 1, of a cell of a grid of 2^bits × 2^bits (bits <= 16).
uint hilbert(uvec2 cell, uint bits) {
  uint place = 0u;
  for (uint i = bits; i-- > 0u;) {
    const uint right = cell.x >> i & 1u, upper = cell.y >> i & 1u;
    place = place << 2 | ((3u * right) ^ upper);
    const uint flip = upper == 0u && right == 1u ? (1u << bits) - 1u : 0u;  // n - 1 - c is c with all bits inverted
    cell ^= flip;
    cell = upper == 0u ? cell.yx : cell;
  }
  return place;
}

#endif
