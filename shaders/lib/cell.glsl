#ifndef CRSH_LIB_CELL_GLSL
#define CRSH_LIB_CELL_GLSL
// The cell of a regular grid in which a point of the unit interval, square or cube lies. A point outside gets a cell at
// the edge, and any float, even not a number, gets some cell.

uint cell_of(float place, uint bits) {
  const uint last = (1u << bits) - 1u;
  precise float scaled = place * float(1u << bits);
  return min(uint(clamp(scaled, 0.0, float(last))), last);
}

uvec2 cell_of(vec2 place, uint bits) { return uvec2(cell_of(place.x, bits), cell_of(place.y, bits)); }

uvec3 cell_of(vec3 place, uint bits) { return uvec3(cell_of(place.xy, bits), cell_of(place.z, bits)); }

#endif
