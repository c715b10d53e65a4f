#ifndef CRSH_LIB_PIXEL_ORDER_GLSL
#define CRSH_LIB_PIXEL_ORDER_GLSL
// The orders in which pixels make rays (--ray-order).

const uint tile_side = 8u;

/// The i-th pixel in tiles of 8x8 pixels: tiles go row by row, and so do the pixels of a tile. Tiles at the right and
/// lower edges are smaller where the image's size is no multiple of 8.
uvec2 tiled_pixel(uint i, uvec2 size) {
  uint row = i / (tile_side * size.x), in_row = i % (tile_side * size.x);
  uint height = min(tile_side, size.y - row * tile_side);
  uint column = in_row / (tile_side * height), in_tile = in_row % (tile_side * height);
  uint width = min(tile_side, size.x - column * tile_side);
  return uvec2(column * tile_side + in_tile % width, row * tile_side + in_tile / width);
}

uvec2 scanline_pixel(uint i, uvec2 size) { return uvec2(i % size.x, i / size.x); }

#endif
