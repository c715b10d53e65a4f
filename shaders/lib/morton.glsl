#ifndef CRSH_LIB_MORTON_GLSL
#define CRSH_LIB_MORTON_GLSL
// Z order of a grid's cells: the bits of the coordinates are interleaved, with the first coordinate's highest.

/// Moves bits 0 to 15 of v to the even bits.
uint spread_2(uint v) {
  v = (v | v << 8) & 0x00FF00FFu;
  v = (v | v << 4) & 0x0F0F0F0Fu;
  v = (v | v << 2) & 0x33333333u;
  return (v | v << 1) & 0x55555555u;
}

/// Moves bits 0 to 9 of v to every third bit.
uint spread_3(uint v) {
  v = (v | v << 16) & 0x030000FFu;
  v = (v | v << 8) & 0x0300F00Fu;
  v = (v | v << 4) & 0x030C30C3u;
  return (v | v << 2) & 0x09249249u;
}

uint morton(uvec2 cell) { return spread_2(cell.x) << 1 | spread_2(cell.y); }

uint morton(uvec3 cell) { return spread_3(cell.x) << 2 | spread_3(cell.y) << 1 | spread_3(cell.z); }

/// Z order in five dimensions, with the lowest `bits` (6 at most) bits of each.
uint morton(uvec3 a, uvec2 b, uint bits) {
  uint code = 0u;
  for (uint i = bits; i-- > 0u;) {
    const uvec3 c = a >> i & 1u;
    const uvec2 d = b >> i & 1u;
    code = code << 5 | c.x << 4 | c.y << 3 | c.z << 2 | d.x << 1 | d.y;
  }
  return code;
}

#endif
